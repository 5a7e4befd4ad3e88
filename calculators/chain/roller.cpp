#include "calculators/chain/roller.hpp"

#include "calculators/chain/figures.hpp"
#include "calculators/chain/layout.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::chain {

namespace {

using Input = Roller::Input;
using Result = Roller::Result;

template <class Tracer>
void chordal_action(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, delta_1, 1.0 - cos(pi / in.z_1), "chain speed between the corners of the polygon, [Strokeforge]");
  STEP_TO(r, delta_2, 1.0 - cos(pi / in.z_2), "speed variation due to chordal action, driven sprocket");
  r.z_min = std::min(in.z_1, in.z_2);
}

/// Sag of a parabola under the pull K_f q g a, whose q cancels; a drive that hangs more steeply sags with less pull.
template <class Tracer>
void position(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.theta)) return;
  STEP_TO(r, theta_c, abs(in.theta), "up to 60° without a tensioner, [HKK]");
  STEP(K_theta,
       theta_c < 2.0 * pi / 9.0 ? 6.0 - 3.0 * theta_c / (2.0 * pi / 9.0)
                                : 3.0 - 2.0 * (theta_c - 2.0 * pi / 9.0) / (5.0 * pi / 18.0),
       "sag factor, linear between 6 at 0°, 3 at 40° and 1 at 90°, [Vunivere]");
  STEP_TO(r, f_s, r.a * cos(theta_c) / (8.0 * min(in.K_f, K_theta)), "q g cos(theta) a^2/(8 F_f), [Chain-sag]");
  if (in.loaded == Roller::Loaded::upper) return;
  STEP(h_p, 0.95 * in.p, "maximum depth of the plates of ISO 606, [Donghua]");
  STEP_TO(r, g_s, (r.d_1 + r.d_2) / 2.0 - f_s - h_p, "the strands must not touch, [Chain-guide]");
}

template <class Tracer>
void speeds(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, n_2, in.n_1 / r.i, "mean speed");
  STEP_TO(r, v, in.z_1 * in.p * in.n_1 / (2.0 * pi), "mean chain speed");
  if (in.lubrication == Roller::Lubrication::grease) {
    STEP_TO(r, v_share, v / (6.0 * m_per_s), "up to 6 m/s, [B40]");
  } else {
    STEP_TO(r, v_share, v / (12.0 * m_per_s), "up to 12 m/s in an oil bath, [B40]");
  }
}

/// Roller diameters of ISO 606 are up to 0.67 of the pitch, [Donghua]; the root circle is that of the pitch less one.
constexpr double thickest_roller = 0.67;

template <class Tracer>
Moment torque(const Input& in, Tracer& trace) {
  if (!is_set(in.P)) return in.T_1;
  return NAMED_STEP("T_1", in.P / in.n_1, "torque from the power, nominal");
}

/// Without the mass of the chain, sag and centrifugal force are excluded from the largest tension, as reported.
template <class Tracer>
void pulls(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, F_t, 2.0 * pi * r.T_1 / (in.z_1 * in.p), "mean pull: work per revolution / (z_1 p)");
  STEP_TO(r, T_2, r.T_1 * r.i, "without losses");
  STEP(q, is_set(in.q) ? in.q : 0.0 * kg_per_m,
       is_set(in.q) ? "mass per length of a strand" : "not given: sag and centrifugal force left out");
  STEP(g, 9.81 * m_per_s2, "gravity");
  const auto v = is_set(r.v) ? r.v : 0.0 * m_per_s;
  if (!is_set(r.v)) trace.value("v", v, "at rest: no speed is given");
  STEP_TO(r, F_c, in.strands * q * v * v, "centrifugal force, [Chain-laws]");
  STEP_TO(r, F_f, in.K_f * in.strands * q * g * r.a, "pull due to the sag of the slack strand, [Vunivere]");
  load_sprocket_shafts(in, thickest_roller * in.p, r, trace);
}

template <class Tracer>
void joints(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.A)) return;
  STEP_TO(r, p_r, in.K_A * r.F_t / (in.strands * in.A), "pressure of the pin in the bush, [Vunivere]");
  if (!is_set(in.p_adm)) return;
  STEP_TO(r, u_p, p_r / in.p_adm, "joint bearing pressure");
}

template <class Tracer>
void breaking(const Input& in, Result& r, Tracer& trace) {
  using Edition = Roller::Edition;
  const bool maker = in.edition == Edition::maker;
  if (!is_set(maker ? in.F_uM : in.F_u94) || !is_set(r.F)) return;
  STEP(F_1, in.edition == Edition::maker ? in.F_uM : in.F_u94,
       maker ? "one strand, manufacturer's value" : "one strand, ISO 606:1994");
  STEP_TO(r, F_u, in.strands * F_1, "breaking load of all strands");
  STEP_TO(r, u_F, r.F / F_u, "the maximum pull must not break the chain, independent of the required safety factor");
  if (!(r.F > 0.0 * N)) return;
  STEP_TO(r, S_stat, F_u / (r.F_t + r.F_c + r.F_f), "not a design criterion by itself: wear and fatigue govern");
  STEP_TO(r, S_dyn, F_u / r.F, "with the service factor");
  if (!is_set(in.S_min)) return;
  STEP_TO(r, u_S, in.S_min / S_dyn, "required / dynamic safety factor");
}

template <class Tracer>
void rating(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.P)) return;
  trace.value("z_min", r.z_min, "teeth of the smaller sprocket");
  STEP_TO(r, f_2, pow(19.0 / r.z_min, 1.08), "tooth factor, [ISO10823]");
  STEP_TO(r, P_c, in.P * in.K_A * f_2, "corrected power for the rating with 19 teeth, [ISO10823]");
  if (!is_set(in.P_R)) return;
  STEP_TO(r, u_P, P_c / in.P_R, "corrected / rated power");
}

}  // namespace

/// Rating of link plates and of rollers, the smaller, with 19 teeth; strands count 1.7, 2.5 and 3.3 times one.
double Roller::most_rating(const Input& in) {
  constexpr double horsepower = 745.7, inch = 0.0254, teeth = 19.0, at_best = 2.0;
  constexpr std::array of_strands{1.0, 1.7, 2.5, 3.3, 3.9, 4.6};
  const double p = in_si(in.p) / inch, whole = in_si(in.n_1) * 30.0 / pi;
  const double n = in.z_1 > in.z_2 ? whole * in.z_1 / in.z_2 : whole;
  const double plates = 0.004 * std::pow(teeth, 1.08) * std::pow(n, 0.9) * std::pow(p, 3.0 - 0.07 * p);
  const double rollers = 17000.0 * std::pow(teeth, 1.5) * std::pow(p, 0.8) / std::pow(n, 1.5);
  const auto strands = static_cast<std::size_t>(std::clamp(static_cast<int>(in.strands), 1, 6));
  return at_best * horsepower * of_strands[strands - 1] * std::min(plates, rollers);
}

/// Less a fifth, as sources interpolate differently.
double Roller::least_sag(const Input& in) {
  constexpr double tolerance = 0.8, of_horizontal = 6.0, of_40_deg = 3.0, of_vertical = 1.0;
  if (!is_set(in.theta)) return in.K_f < of_vertical ? of_horizontal : unset<double>;
  const double part = std::abs(in.theta) / (2.0 * pi / 9.0);
  const double steeply = of_40_deg - (of_40_deg - of_vertical) * (part - 1.0) / 1.25;
  const double at_theta = part < 1.0 ? of_horizontal - (of_horizontal - of_40_deg) * part : steeply;
  return std::max(tolerance * at_theta, std::min(at_theta, of_vertical));
}

double Roller::most_centre(const Input& in) {
  return most_centre_of(in, in.loaded == Loaded::lower ? longest_above : longest_span);
}
double Roller::most_links(const Input& in) {
  return most_links_of(in, in.loaded == Loaded::lower ? longest_above : longest_span);
}

bool Roller::sprockets_apart(const Input& in) { return stand_apart(in); }
FieldFault Roller::sprockets_touch(const Input& in) { return touching(in); }
bool Roller::links_reach(const Input& in) { return reach_around(in); }
FieldFault Roller::too_few_links(const Input& in) { return too_short(in); }

template <class Tracer>
Roller::Result Roller::evaluate(const Input& in, Tracer& trace) {
  Result r;
  lay_links(in, r, trace);
  lay_sprockets(in, r, trace);
  chordal_action(in, r, trace);
  position(in, r, trace);
  if (is_set(in.n_1)) speeds(in, r, trace);
  r.T_1 = torque(in, trace);
  if (!is_set(r.T_1)) return r;
  pulls(in, r, trace);
  joints(in, r, trace);
  breaking(in, r, trace);
  rating(in, r, trace);
  return r;
}

template Roller::Result Roller::evaluate(const Input&, NoTrace&);
template Roller::Result Roller::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Roller::figures(const Input& in, const Result& r) {
  return is_set(r.a) ? drive_figures(in.n_1, r) : std::vector<figure::Figure>{};
}

}  // namespace loadpath::chain

template const loadpath::Calculator& loadpath::erased<loadpath::chain::Roller>();
