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

enum class Arrangement { open, crossed };

/// What a course is laid from: one of `a` and `L` is set.
struct Pulleys {
  Length d_1, d_2;
  Length a;
  Length L;
  Arrangement arrangement = Arrangement::open;
};

struct DriveCourse {
  Length a = unset<Length>, L = unset<Length>, l_s = unset<Length>;
  double gamma = unset<double>;  // of the spans to the line of centres; open: positive where pulley 2 is the larger
  double alpha_1 = unset<double>, alpha_2 = unset<double>;
};

/// The centre distance at which a belt has the length L, for pulleys whose spans are inclined by asin(difference / 2a);
/// NaN where no distance is long enough for straight spans. Newton from the right: L(a) rises and is convex.
Length centre_of_length(const Pulleys& pulleys);

/// Whether the pulleys of a course stand clear of each other.
bool stand_clear(const Pulleys& pulleys);
/// What to say where they do not: the least centre distance, or the least length.
FieldFault overlap(const Pulleys& pulleys);

/// Angles, spans, and what is missing of a and L.
template <class Tracer>
DriveCourse lay(const Pulleys& pulleys, Tracer& trace) {
  const auto d_1 = pulleys.d_1, d_2 = pulleys.d_2;
  const Length a = is_set(pulleys.a) ? pulleys.a : centre_of_length(pulleys);
  if (!is_set(pulleys.a)) trace.value("a", a, "centre distance at which the exact length of the belt is L, by Newton");
  DriveCourse c;
  c.a = a, c.L = pulleys.L;
  if (pulleys.arrangement == Arrangement::crossed) {
    STEP(gamma, asin((d_1 + d_2) / (2.0 * a)), "inclination of the spans to the line of centres, crossed belt");
    STEP(alpha_1, pi + 2.0 * gamma, "wrap of the driving pulley, and of the driven one");
    c.gamma = gamma, c.alpha_1 = c.alpha_2 = alpha_1;
    if (!is_set(c.L)) {
      STEP(L, 2.0 * a * cos(gamma) + alpha_1 * (d_1 + d_2) / 2.0, "two spans and the arcs, exact");
      c.L = L;
    }
  } else {
    STEP(gamma, asin((d_2 - d_1) / (2.0 * a)), "inclination of the spans to the line of centres");
    STEP(alpha_1, pi - 2.0 * gamma, "wrap of the driving pulley");
    STEP(alpha_2, pi + 2.0 * gamma, "wrap of the driven pulley");
    c.gamma = gamma, c.alpha_1 = alpha_1, c.alpha_2 = alpha_2;
    if (!is_set(c.L)) {
      STEP(L, 2.0 * a * cos(gamma) + (d_1 * alpha_1 + d_2 * alpha_2) / 2.0, "two spans and the arcs, exact");
      c.L = L;
    }
  }
  const auto gamma = c.gamma;
  STEP(l_s, a * cos(gamma), "span between the points of contact");
  c.l_s = l_s;
  return c;
}

}  // namespace loadpath::belt
