#include "calculators/chain/inverted_tooth.hpp"

#include "calculators/chain/figures.hpp"
#include "calculators/chain/layout.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::chain {

namespace {

/// Pitch diameter less root diameter, over the pitch: the teeth are less deep than a pitch, so that the root circles
/// are larger.
constexpr double deepest_teeth = 2.0;

/// Without the mass of the chain, sag and centrifugal force are excluded from the maximum pull, as reported.
template <class Tracer>
void chain_pulls(const InvertedTooth::Input& in, InvertedTooth::Result& r, Tracer& trace) {
  STEP_TO(r, n_2, in.n_1 / r.i, "mean speed");
  STEP_TO(r, v, in.z_1 * in.p * in.n_1 / (2.0 * pi), "mean chain speed");
  if (is_set(in.v_max)) {
    STEP_TO(r, v_share, v / in.v_max, "chain speed / maximum speed");
  }
  STEP_TO(r, T_1, in.P / in.n_1, "torque from the power, nominal");
  STEP_TO(r, T_2, T_1 * r.i, "without losses");
  STEP_TO(r, F_t, in.P / v, "mean pull");
  STEP(q, is_set(in.q) ? in.q : 0.0 * kg_per_m,
       is_set(in.q) ? "mass per length" : "not given: sag and centrifugal force left out");
  STEP(g, 9.81 * m_per_s2, "gravity");
  STEP_TO(r, F_c, q * v * v, "centrifugal force, [Chain-laws]");
  STEP_TO(r, F_f, in.K_f * q * g * r.a, "pull due to the sag of the slack strand, [Vunivere]");
  load_sprocket_shafts(in, deepest_teeth * in.p, r, trace);
}

template <class Tracer>
void required_width(const InvertedTooth::Input& in, InvertedTooth::Result& r, Tracer& trace) {
  STEP_TO(r, P_c, in.P * in.K_A, "design power, [Ramsey]");
  if (!is_set(in.P_b)) return;
  trace.value("odd", r.odd, "1 for an odd number of links");
  STEP(k_o, r.odd > 0.5 ? 1.25 : 1.0, "a hunting link needs a chain wider by 25 %, [Ramsey]");
  STEP_TO(r, b_min, k_o * P_c / in.P_b * in.b_R, "design power over rated power per width, [Ramsey]");
  STEP_TO(r, u_b, b_min / in.b, "required / actual width");
}

template <class Tracer>
void breaking_safety(const InvertedTooth::Input& in, InvertedTooth::Result& r, Tracer& trace) {
  if (!is_set(in.F_u) || !is_set(in.q)) return;  // without q, part of the pull is unknown
  STEP_TO(r, u_F, r.F / in.F_u, "the maximum pull must not break the chain");
  if (!(r.F > 0.0 * N)) return;
  STEP_TO(r, S_dyn, in.F_u / r.F, "with the service factor");
  if (!is_set(in.S_min)) return;
  STEP_TO(r, u_S, in.S_min / S_dyn, "required / calculated safety factor");
}

}  // namespace

namespace {
constexpr double most_silent_speed = 35.0;  // m/s, from memory: fast silent chains, 7000 ft/min
}

/// Silent chains of GOST 13552 break at 70 to 92 N/mm^2 of pitch x width, from memory; strong ones at some 125 N/mm^2.
double InvertedTooth::most_breaking_load(const Input& in) { return in_si(140.0 * MPa * in.p * in.b); }

/// A seventh of that breaking load as the pull of the rated power.
double InvertedTooth::most_rating(const Input& in) {
  const Speed v = in.z_1 * in.p * in.n_1 / (2.0 * pi);
  return in_si(20.0 * MPa * in.p * in.b_R * v);
}

/// A wider chain is loaded unevenly on a sprocket that is not parallel to the other; bound set by loadpath.
double InvertedTooth::most_width(const Input& in) { return in_si(in.p) / std::sin(pi / std::min(in.z_1, in.z_2)); }

/// Silent chains of GOST 13552 have 4500 to 6000 kg/m^3 of pitch x width, from memory.
double InvertedTooth::least_mass(const Input& in) { return in_si(in.p) * in_si(in.b) * 2500.0; }

double InvertedTooth::most_speed(const Input&) { return most_silent_speed; }
/// Where no maximum speed of the chain is given.
double InvertedTooth::most_rotation(const Input& in) {
  return is_set(in.v_max) ? unset<double> : most_silent_speed * 2.0 * pi / (in.z_1 * in_si(in.p));
}
double InvertedTooth::most_centre(const Input& in) { return most_centre_of(in, longest_span); }
double InvertedTooth::most_links(const Input& in) { return most_links_of(in, longest_span); }

bool InvertedTooth::sprockets_apart(const Input& in) { return stand_apart(in); }
FieldFault InvertedTooth::sprockets_touch(const Input& in) { return touching(in); }
bool InvertedTooth::links_reach(const Input& in) { return reach_around(in); }
FieldFault InvertedTooth::too_few_links(const Input& in) { return too_short(in); }

template <class Tracer>
InvertedTooth::Result InvertedTooth::evaluate(const Input& in, Tracer& trace) {
  Result r;
  lay_links(in, r, trace);
  lay_sprockets(in, r, trace);
  chain_pulls(in, r, trace);
  required_width(in, r, trace);
  breaking_safety(in, r, trace);
  return r;
}

template InvertedTooth::Result InvertedTooth::evaluate(const Input&, NoTrace&);
template InvertedTooth::Result InvertedTooth::evaluate(const Input&, Trace&);

std::vector<figure::Figure> InvertedTooth::figures(const Input& in, const Result& r) {
  return drive_figures(in.n_1, r);
}

}  // namespace loadpath::chain

template const loadpath::Calculator& loadpath::erased<loadpath::chain::InvertedTooth>();
