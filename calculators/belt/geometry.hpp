// The course of a belt around two pulleys: angles of wrap, spans, and length and centre distance from each other,
// exact.
//
// Lengths are those of the line that the diameters are given for: the datum line of a V-belt, the middle of a flat
// belt.
#pragma once

#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"
#include "lib/text/issue.hpp"

namespace loadpath::belt {

enum class Arrangement { open, crossed, quarter_turn };

/// Input of a course: one of `a` and `L` is set.
struct Pulleys {
  Length d_1, d_2;
  Length a;
  Length L;
  Arrangement arrangement = Arrangement::open;
};

/// The centre distance at which a belt has the length L, for pulleys whose spans are inclined by asin(difference / 2a),
/// or of a quarter-turn drive; NaN where no distance is long enough for straight spans. Newton from the right: L(a)
/// rises and is convex.
Length centre_of_length(const Pulleys& pulleys);

/// Whether the pulleys of a course have clearance between each other.
bool stand_clear(const Pulleys& pulleys);
/// Message for overlapping pulleys: the minimum centre distance, or the minimum length.
FieldFault overlap(const Pulleys& pulleys);

/// Spans, wraps, and what is missing of a and L, of open and crossed belts (calculators/belt/quarter_turn.hpp). gamma
/// is the inclination of the spans to the line of centres: open, positive where pulley 2 is the larger.
template <class Result, class Tracer>
void lay(const Pulleys& pulleys, Result& r, Tracer& trace) {
  r.a = pulleys.a, r.L = pulleys.L;
  if (!is_set(r.a)) {
    r.a = centre_of_length(pulleys);
    trace.value("a", r.a, "centre distance at which the exact length of the belt is L, by Newton");
  }
  if (pulleys.arrangement == Arrangement::crossed) {
    STEP_TO(r, gamma, asin((pulleys.d_1 + pulleys.d_2) / (2.0 * r.a)),
            "inclination of the spans to the line of centres, crossed belt");
    STEP_TO(r, alpha_1, pi + 2.0 * gamma, "wrap of the driving pulley, and of the driven one");
    r.alpha_2 = alpha_1;
    STEP_TO(r, l_s, sqrt(r.a * r.a - pow<2>((pulleys.d_1 + pulleys.d_2) / 2.0)), "free span length");
    if (!is_set(r.L)) {
      STEP_TO(r, L, 2.0 * l_s + alpha_1 * (pulleys.d_1 + pulleys.d_2) / 2.0, "two spans and the arcs, exact");
    }
  } else {
    STEP_TO(r, gamma, asin((pulleys.d_2 - pulleys.d_1) / (2.0 * r.a)), "span angle to the line of centres");
    STEP_TO(r, alpha_1, pi - 2.0 * gamma, "wrap angle, driving pulley");
    STEP_TO(r, alpha_2, pi + 2.0 * gamma, "wrap angle, driven pulley");
    STEP_TO(r, l_s, sqrt(r.a * r.a - pow<2>((pulleys.d_2 - pulleys.d_1) / 2.0)), "free span length");
    if (!is_set(r.L)) {
      STEP_TO(r, L, 2.0 * l_s + (pulleys.d_1 * alpha_1 + pulleys.d_2 * alpha_2) / 2.0, "two spans and the arcs, exact");
    }
  }
}

}  // namespace loadpath::belt
