// Links, centre distance, pitch circles and shaft loads of a chain around two sprockets, of any kind of chain.
#pragma once

#include "calculators/chain/links.hpp"
#include "calculators/load/shaft_load.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/units.hpp"
#include "lib/text/issue.hpp"

#include <cmath>
#include <string>

namespace loadpath::chain {

/// The minimum centre distance of the sprockets: their tips touch, about 0.6 p above the half pitch circles.
template <class Input>
Length closest(const Input& in) {
  const double pitch_radii = 0.5 / std::sin(pi / in.z_1) + 0.5 / std::sin(pi / in.z_2);
  return (pitch_radii + 0.6) * in.p;
}

/// Pitches between sprockets without guides: 30 to 50 are usual, 80 the maximum without support of the spans, from
/// memory. A slack strand above sags onto the tight one as the chain wears: 60, set by loadpath.
inline constexpr double longest_span = 80.0, longest_above = 60.0;

template <class Input>
double most_centre_of(const Input& in, double pitches) {
  return pitches * in_si(in.p);
}
template <class Input>
double most_links_of(const Input& in, double pitches) {
  return 2.0 * std::ceil(0.5 * links_at(pitches, in.z_1, in.z_2));
}

/// Links, rounded to the even number that is nearest.
inline double even(double links) { return 2.0 * std::round(0.5 * links); }

template <class Input>
bool stand_apart(const Input& in) {
  return !is_set(in.a) || !is_set(in.p) || in.a > closest(in);
}

template <class Input>
FieldFault touching(const Input& in) {
  return {"a", say("at {1} the sprockets touch each other", format_quantity(in_si(in.a), mm.symbol)),
          say("give more than {1}; 30 to 50 pitches are usual", format_quantity(in_si(closest(in)), mm.symbol))};
}

template <class Input>
bool reach_around(const Input& in) {
  return in.X == 0 || !is_set(in.p) || pitches_of(in.X, in.z_1, in.z_2) * in.p > closest(in);
}

template <class Input>
FieldFault too_short(const Input& in) {
  const double least = std::ceil(links_at(closest(in) / in.p, in.z_1, in.z_2));
  return {"X", say("{1} links do not reach around the sprockets", std::to_string(static_cast<int>(in.X))),
          say("give more than {1}", std::to_string(static_cast<int>(least)))};
}

template <class Input, class Result, class Tracer>
void lay_links(const Input& in, Result& r, Tracer& trace) {
  if (is_set(in.a)) {
    r.X_0 = links_at(in.a / in.p, in.z_1, in.z_2);
    trace.value("X_0", r.X_0, "links at the required centre distance, exact for circles of z pitches, [ISO10823]");
  }
  r.X = trace.value("X", in.X > 0 ? in.X : even(r.X_0), in.X > 0 ? "as given" : "the nearest even number");
  STEP_TO(r, L, r.X * in.p, "chain length");
  r.a_p = pitches_of(r.X, in.z_1, in.z_2);
  trace.value("a_p", r.a_p, "centre distance in pitches for this number of links, exact, [ISO10823]");
  STEP_TO(r, a, r.a_p * in.p, "taut; 0.2 to 0.4 % less for the sag of the slack strand");
  r.odd = std::fmod(r.X, 2.0);
}

template <class Input, class Result, class Tracer>
void lay_sprockets(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, i, in.z_2 / in.z_1, "mean ratio");
  STEP_TO(r, d_1, in.p / sin(pi / in.z_1), "pitch circle through the pins, [Strokeforge]");
  STEP_TO(r, d_2, in.p / sin(pi / in.z_2), "pitch circle through the pins, [Strokeforge]");
  STEP_TO(r, alpha_1, pi - 2.0 * asin((d_2 - d_1) / (2.0 * r.a)), "wrap, [Strokeforge]");
  STEP_TO(r, alpha_2, 2.0 * pi - alpha_1, "wrap of the other sprocket");
}

/// Maximum pull and shaft loads by the nominal, centrifugal and sag pulls. `depth`: pitch diameter less root diameter.
template <class Input, class Result, class Tracer>
void load_sprocket_shafts(const Input& in, Length depth, Result& r, Tracer& trace) {
  STEP_TO(r, F, in.K_A * r.F_t + r.F_c + r.F_f, "maximum pull; service factor included");
  STEP_TO(r, F_W, in.K_A * r.F_t + 2.0 * r.F_f,
          "both strands, [Vunivere]; the centrifugal force does not load the shafts");
  const Force none = 0.0 * N.one;
  r.shaft_1 = shaft_load(in.K_A * r.T_1, {F_W, none, none}, r.d_1, in.n_1, 0.0);
  r.shaft_2 = shaft_load(in.K_A * r.T_2, {F_W, none, none}, r.d_2, r.n_2, 0.0);
  r.shaft_1.d_f = r.d_1 - depth, r.shaft_2.d_f = r.d_2 - depth;
  r.shaft_1.kind = r.shaft_2.kind = Mounted::sprocket;
}

}  // namespace loadpath::chain
