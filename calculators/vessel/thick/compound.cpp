#include "calculators/vessel/thick/compound.hpp"

#include "calculators/load/pressed_rings.hpp"
#include "calculators/vessel/thick/lame_constants.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>

namespace loadpath::vessel {

namespace {

using Input = Compound::Input;
using Result = Compound::Result;
using State = Compound::State;
using Ends = Compound::Ends;

/// What the internal pressure adds, per pressure: to the contact pressure and to the axial stresses.
struct PerPressure {
  double q_p = 0.0, z_1 = 0.0, z_2 = 0.0;
};

/// Elastic constants of the contact, in terms of the inner tube.
struct Contact {
  double e_E, K;
};

template <class Tracer>
Contact contact_of(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, Q_1, in.d_i / in.d, "bore over contact diameter");
  STEP_TO(r, Q_2, in.d / in.D, "contact over outer diameter");
  const auto [K_1, K_2] = compliances_of_rings(in, Q_1, Q_2, "inner tube under pressure outside, [Lame]",
                                               "outer tube under pressure inside, [Lame]", trace);
  STEP(e_E, in.E_1 / in.E_2, "ratio of the moduli");
  STEP(K, K_1 + e_E * K_2, "compliance of the contact");
  return {e_E, K};
}

/// The range of the interference, cold and warm.
template <class Tracer>
void interferences(const Input& in, const Contact& contact, Result& r, Tracer& trace) {
  const double K = contact.K;
  if (is_set(in.p_c)) {
    STEP(U_c, in.p_c / in.E_1 * K * in.d, "interference of the contact pressure, [Lame]");
    r.U_w_min = r.U_w_max = U_c;
  } else {
    r.U_w_min = in.U_min, r.U_w_max = in.U_max;
  }
  if (is_set(in.dT_1)) {
    const Length U_1 = trace.value("U_1", r.U_w_min, "minimum interference, cold");
    const Length U_2 = trace.value("U_2", r.U_w_max, "maximum interference, cold");
    STEP_TO(r, U_T, in.d * (in.alpha_2 * in.dT_2 - in.alpha_1 * in.dT_1), "lost by heating");
    STEP_TO(r, u_U, max(U_T, 0.0 * mm) / U_1, "contact is lost where all of it is");
    STEP_TO(r, U_w_min, U_1 - max(U_T, 0.0 * mm), "cold or warm");
    STEP_TO(r, U_w_max, U_2 - min(U_T, 0.0 * mm), "cold or warm");
    return;
  }
  trace.value("U_w_min", r.U_w_min, "minimum interference");
  trace.value("U_w_max", r.U_w_max, "maximum interference");
}

/// The tubes expand alike at the contact; with closed ends, along the axis too.
template <class Tracer>
PerPressure by_pressure(const Input& in, const Contact& contact, const Result& r, Tracer& trace) {
  const double Q_1 = r.Q_1, Q_2 = r.Q_2, e_E = contact.e_E, K = contact.K;
  STEP(s_1, 1.0 - pow<2>(Q_1), "section of the inner tube, over pi d^2/4");
  if (in.ends == Ends::open) {
    const double q_p = NAMED_STEP("q_p", 2.0 * pow<2>(Q_1) / (s_1 * K), "equal expansion at the contact, [Lame]");
    return {q_p, trace.value("z_1", 0.0, "no ends, no axial force"),
            trace.value("z_2", 0.0, "no ends, no axial force")};
  }
  STEP(s_2, 1.0 / pow<2>(Q_2) - 1.0, "section of the outer tube, over pi d^2/4");
  STEP(n_E, s_1 + s_2 / e_E, "axial stiffness of both tubes");
  STEP(eps_p, pow<2>(Q_1) * (1.0 - 2.0 * in.nu_1) / n_E, "axial strain by the internal pressure, E_1 times");
  STEP(eps_q, 2.0 * (in.nu_1 - in.nu_2) / n_E, "axial strain by the contact pressure, E_1 times");
  STEP(w_p, 2.0 * pow<2>(Q_1) * (1.0 - pow<2>(in.nu_1)) / s_1 - (in.nu_1 - in.nu_2) * eps_p,
       "expansion of the inner tube by the internal pressure beyond that of the outer one, Hooke");
  STEP(w_q, K - 2.0 * pow<2>(in.nu_1) / s_1 - 2.0 * e_E * pow<2>(in.nu_2) / s_2 + (in.nu_1 - in.nu_2) * eps_q,
       "the same by a contact pressure, taken back");
  STEP(q_p, w_p / w_q, "equal expansion at the contact");
  STEP(eps_z, eps_p + eps_q * q_p, "axial strain of both tubes, E_1 times");
  STEP(z_1, eps_z + 2.0 * in.nu_1 * (pow<2>(Q_1) - q_p) / s_1, "axial stress of the inner tube per pressure, Hooke");
  STEP(z_2, eps_z / e_E + 2.0 * in.nu_2 * q_p / s_2, "axial stress of the outer tube per pressure, Hooke");
  return {q_p, z_1, z_2};
}

/// Lamé's stresses of both tubes with the pressures at their surfaces.
template <class Tracer>
void hoop_stresses(const Result& r, State& s, Tracer& trace) {
  const double Q_1 = r.Q_1, Q_2 = r.Q_2;
  STEP_TO(s, sigma_1i, (s.p_i * (1.0 + pow<2>(Q_1)) - 2.0 * s.p_k) / (1.0 - pow<2>(Q_1)), "inner tube, inside, [Lame]");
  STEP_TO(s, sigma_1a, (2.0 * s.p_i * pow<2>(Q_1) - s.p_k * (1.0 + pow<2>(Q_1))) / (1.0 - pow<2>(Q_1)),
          "inner tube, at the contact, [Lame]");
  STEP_TO(s, sigma_2i, s.p_k * (1.0 + pow<2>(Q_2)) / (1.0 - pow<2>(Q_2)), "outer tube, at the contact, [Lame]");
  STEP_TO(s, sigma_2a, 2.0 * s.p_k * pow<2>(Q_2) / (1.0 - pow<2>(Q_2)), "outer tube, outside, [Lame]");
}

template <class Tracer>
Stress at_surface_of(const char* place, Stress hoop, Stress axial, Stress pressure, Hypothesis hypothesis,
                     Tracer& trace) {
  [[maybe_unused]] const auto scope = trace.scope(place, 0);
  const Stress s_o = trace.value("s_o", hoop, "hoop stress there");
  const Stress s_M = trace.value("s_M", axial, "axial stress");
  const Stress p_i = trace.value("p_i", pressure, "pressure there");
  return equivalent(s_o, s_M, p_i, hypothesis, trace);
}

/// Both differences of principal stresses and their squares are convex in 1/r^2: a surface governs.
template <class Tracer>
void equivalent_stresses(const Input& in, State& s, Tracer& trace) {
  const Stress none = 0.0 * MPa;
  const Stress s_1i = at_surface_of("bore", s.sigma_1i, s.sigma_z1, s.p_i, in.hypothesis, trace);
  const Stress s_1a = at_surface_of("contact_1", s.sigma_1a, s.sigma_z1, s.p_k, in.hypothesis, trace);
  const Stress s_2i = at_surface_of("contact_2", s.sigma_2i, s.sigma_z2, s.p_k, in.hypothesis, trace);
  const Stress s_2a = at_surface_of("outside", s.sigma_2a, s.sigma_z2, none, in.hypothesis, trace);
  s.sigma_v1 = trace.value("sigma_v1", max(s_1i, s_1a), "inner tube, the larger of the two surfaces");
  s.sigma_v2 = trace.value("sigma_v2", max(s_2i, s_2a), "outer tube, the larger of the two surfaces");
}

template <class Tracer>
void add_state(const Input& in, const Contact& contact, const PerPressure& by, const char* name, Length interference,
               Stress pressure, Result& r, Tracer& trace) {
  [[maybe_unused]] const auto scope = trace.scope("states", r.states.size());
  State s;
  const double K = contact.K, q_p = by.q_p, z_1 = by.z_1, z_2 = by.z_2;
  s.name = name;
  s.U = trace.value("U", interference, "diametral interference");
  s.p_i = trace.value("p_i", pressure, "internal pressure");
  STEP_TO(s, p_k, s.U / in.d * in.E_1 / K + q_p * s.p_i, "by the interference and by the internal pressure");
  hoop_stresses(r, s, trace);
  STEP_TO(s, sigma_z1, z_1 * s.p_i, "axial, inner tube");
  STEP_TO(s, sigma_z2, z_2 * s.p_i, "axial, outer tube");
  equivalent_stresses(in, s, trace);
  r.states.push_back(s);
}

/// The corners of the range of loads.
template <class Tracer>
void add_states(const Input& in, const Contact& contact, const PerPressure& by, Result& r, Tracer& trace) {
  const Stress none = 0.0 * MPa;
  add_state(in, contact, by, "rest", r.U_w_max, none, r, trace);
  if (in.p > none) add_state(in, contact, by, "pressure", r.U_w_max, in.p, r, trace);
  if (!(r.U_w_min < r.U_w_max)) return;
  add_state(in, contact, by, "rest_loose", r.U_w_min, none, r, trace);
  if (in.p > none) add_state(in, contact, by, "pressure_loose", r.U_w_min, in.p, r, trace);
}

template <class Tracer>
void yielding(const Input& in, Result& r, Tracer& trace) {
  Stress sigma_1 = 0.0 * MPa, sigma_2 = 0.0 * MPa;
  for (const State& s : r.states) sigma_1 = max(sigma_1, s.sigma_v1), sigma_2 = max(sigma_2, s.sigma_v2);
  r.sigma_v1 = trace.value("sigma_v1", sigma_1, "inner tube in the governing state");
  r.sigma_v2 = trace.value("sigma_v2", sigma_2, "outer tube in the governing state");
  if (!is_set(in.S)) return;
  STEP_TO(r, u_1, in.S * r.sigma_v1 / in.R_e_1, "inner tube against yield");
  STEP_TO(r, u_2, in.S * r.sigma_v2 / in.R_e_2, "outer tube against yield");
}

/// Equal utilisation of both bores under the internal pressure, where the hoop stress is the largest and the radial one
/// the smallest.
template <class Tracer>
void optimum(const Input& in, const Contact& contact, const PerPressure& by, Result& r, Tracer& trace) {
  if (!is_set(in.R_e_1) || !is_set(in.R_e_2)) return;
  const double Q_1 = r.Q_1, Q_2 = r.Q_2, K = contact.K, q_p = by.q_p;
  STEP(p_1, (1.0 - pow<2>(Q_1)) * in.R_e_1 / 2.0, "pressure difference at which the inner tube yields, Tresca");
  STEP(p_2, (1.0 - pow<2>(Q_2)) * in.R_e_2 / 2.0, "pressure at which the outer tube yields, Tresca");
  STEP_TO(r, p_F, p_1 + p_2, "both tubes yield at once");
  STEP_TO(r, d_opt, sqrt(in.d_i * in.D) * sqrt(sqrt(in.R_e_1 / in.R_e_2)), "maximum of p_F over the contact diameter");
  if (!(p_2 / p_F > q_p) || !(in.p > 0.0 * MPa)) return;
  STEP_TO(r, p_opt, in.p * (p_2 / p_F - q_p), "the tubes share the pressure as they yield");
  STEP_TO(r, U_opt, p_opt / in.E_1 * K * in.d, "interference of that contact pressure, [Lame]");
}

}  // namespace

template <class Tracer>
Compound::Result Compound::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const Contact contact = contact_of(in, r, trace);
  interferences(in, contact, r, trace);
  const PerPressure by = by_pressure(in, contact, r, trace);
  r.q_p = by.q_p;
  optimum(in, contact, by, r, trace);
  const double K = contact.K;
  if (!(r.U_w_min > 0.0 * mm)) return r;  // the tubes are apart
  STEP_TO(r, p_min, r.U_w_min / in.d * in.E_1 / K, "minimum contact pressure at rest, [Lame]");
  STEP_TO(r, p_max, r.U_w_max / in.d * in.E_1 / K, "maximum contact pressure at rest, [Lame]");
  add_states(in, contact, by, r, trace);
  yielding(in, r, trace);
  return r;
}

template Compound::Result Compound::evaluate(const Input&, NoTrace&);
template Compound::Result Compound::evaluate(const Input&, Trace&);

namespace {

/// The hoop stress through both walls; it jumps at the contact.
figure::Curve hoop_curve(const Input& in, const State& s, const char* name) {
  constexpr int count = 30;
  figure::Curve curve{name, {}, {}};
  const auto add = [&](Length low, Length high, Stress p_i, Stress p_a) {
    NoTrace off;
    const Lame lame = lame_constants(p_i, p_a, low, high, off);
    for (int i = 0; i <= count; ++i) {
      const Length at = low + (high - low) * (static_cast<double>(i) / count);
      curve.x.push_back(in_si(at));
      curve.y.push_back(in_si(lame.hoop(at)));
    }
  };
  add(0.5 * in.d_i, 0.5 * in.d, s.p_i, s.p_k);
  add(0.5 * in.d, 0.5 * in.D, s.p_k, 0.0 * MPa);
  return curve;
}

}  // namespace

std::vector<figure::Figure> Compound::figures(const Input& in, const Result& r) {
  if (r.states.empty()) return {};
  figure::Plot plot;
  plot.x = {"r", "radius", "mm"};
  plot.y = {"sigma_t", "hoop stress", "MPa"};
  plot.curves.push_back(hoop_curve(in, r.states[0], "rest"));
  if (r.states.size() % 2 == 0 && in.p > 0.0 * MPa) plot.curves.push_back(hoop_curve(in, r.states[1], "pressure"));
  return {{"stresses", "Hoop stress through both tubes, maximum interference", std::move(plot)}};
}

}  // namespace loadpath::vessel

template const loadpath::Calculator& loadpath::erased<loadpath::vessel::Compound>();
