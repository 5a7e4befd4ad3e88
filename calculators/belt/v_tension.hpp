// Initial tension of V-belts by the rule of their basis, how it is measured, and what it does to the shafts.
#pragma once

#include "calculators/belt/shaft_load.hpp"
#include "calculators/belt/v.hpp"

namespace loadpath::belt {

/// Force that one belt carries over, and the tension that presses it into the grooves at rest.
struct Press {
  Force F_t, N_0;
};

template <class Tracer>
Press press(const V::Input& in, const V::Result& r, Tracer& trace) {
  const auto P = in.P, P_B = r.P_B;
  const auto v = r.v;
  const auto c_alpha = r.c_alpha;
  const double z = r.z;
  STEP(F_t, P_B / (z * v), "force that one belt carries over");
  if (in.basis == Basis::optibelt) {
    STEP(N_0, (2.02 - c_alpha) / (2.0 * c_alpha) * P_B / (z * v), "presses a belt into its grooves, [Optibelt-V]");
    return {F_t, N_0};
  }
  const double K_P = is_set(in.K_A_1) ? in.K_A_1 : r.K_A;
  trace.value("K_P", K_P,
              is_set(in.K_A_1) ? "for one shift, as given" : "that of the power: at least that of one shift");
  STEP(N_0, (2.5 - c_alpha) / (2.0 * c_alpha) * K_P * P / (z * v),
       "presses a belt into its grooves, [GOST1284.3] (16)");
  return {F_t, N_0};
}

/// Whether friction in the grooves of each pulley, at its own groove angle, holds the force.
template <class Tracer>
void grip(const V::Input& in, const Press& pressed, V::Result& r, Tracer& trace) {
  if (!is_set(in.mu)) return;
  const auto mu = in.mu, phi_1 = r.phi_1, phi_2 = r.phi_2, alpha_1 = r.alpha_1, alpha_2 = r.alpha_2;
  const auto& [F_t, N_0] = pressed;
  STEP(mu_1, mu / sin(phi_1 / 2.0), "wedge friction of the driving pulley");
  STEP(mu_2, mu / sin(phi_2 / 2.0), "wedge friction of the driven pulley");
  STEP(m_e, exp(min(mu_1 * alpha_1, mu_2 * alpha_2)), "Euler's condition at the pulley that slips first, [B40]");
  STEP(N_min, F_t / 2.0 * (m_e + 1.0) / (m_e - 1.0), "least tension that holds the force");
  STEP(u_grip, N_min / N_0, "grip condition");
  r.u_grip = u_grip;
}

template <class Tracer>
void tension(const VSection& section, const V::Input& in, V::Result& r, Tracer& trace) {
  const auto m = section.row.m;
  const auto v = r.v;
  trace.value("m", m, "mass per length of one belt");
  STEP(F_c, m * v * v, "turns the belt around, and does not press it into the grooves");
  const Press pressed = press(in, r, trace);
  const auto& [F_t, N_0] = pressed;
  grip(in, pressed, r, trace);
  const bool fixed = in.tensioning == V::Tensioning::fixed;
  const Force F_lost = fixed ? F_c : 0.0 * F_c;
  trace.value("F_lost", F_lost,
              fixed ? "on fixed centres the centrifugal part relieves the grooves" : "the tensioner makes up for it");
  STEP(F_0, N_0 + F_lost, "initial tension of a span of one belt, run in");
  STEP(F_0_new, 1.3 * F_0, "new belts lose tension when they run in, [Optibelt-V]");
  STEP(S_1, N_0 + F_c + F_t / 2.0, "tight span of one belt");
  STEP(S_2, S_1 - F_t, "slack span of one belt");
  r.F_c = F_c, r.F_0 = F_0, r.F_0_new = F_0_new, r.S_1 = S_1, r.S_2 = S_2;
}

/// Deflection under a test force, and frequency of the plucked span.
template <class Tracer>
void measure(const VSection& section, V::Result& r, Tracer& trace) {
  const auto a = r.a, l_s = r.l_s;
  const auto F_0 = r.F_0, F_0_new = r.F_0_new;
  const auto m = section.row.m;
  STEP(y, 1.55 / 100.0 * a, "deflection of a span, [GOST1284.3] (17)");
  r.y = y;
  if (section.basis == Basis::iso) {
    const auto C_0 = section.row.C_0;
    trace.value("C_0", C_0, "stiffness of the belt, [GOST1284.3] 21");
    STEP(Q, (F_0 + C_0) / 16.0, "test force, [GOST1284.3] (19)");
    STEP(Q_new, (F_0_new + C_0) / 16.0, "test force of a new belt, [GOST1284.3] (18)");
    r.Q = Q, r.Q_new = Q_new;
  } else {
    STEP(Q, 4.0 * F_0 * y / l_s, "test force of a taut string, without the stiffness of the belt");
    STEP(Q_new, 4.0 * F_0_new * y / l_s, "test force of a new belt");
    r.Q = Q, r.Q_new = Q_new;
  }
  STEP(f_s, sqrt(F_0 / m) / (2.0 * l_s), "first frequency of a taut string");
  STEP(f_s_new, sqrt(F_0_new / m) / (2.0 * l_s), "first frequency, new belt");
  r.f_s = f_s, r.f_s_new = f_s_new;
}

template <class Tracer>
void load_shafts(V::Result& r, Tracer& trace) {
  const auto F_0 = r.F_0, F_0_new = r.F_0_new, F_c = r.F_c, S_1 = r.S_1, S_2 = r.S_2;
  const auto gamma = r.gamma;
  const double z = r.z;
  STEP(R_0, 2.0 * z * F_0 * cos(gamma), "shaft load at standstill");
  STEP(R_new, 2.0 * z * F_0_new * cos(gamma), "shaft load at standstill, new belts");
  r.R_0 = R_0, r.R_new = R_new;
  STEP(N_1, z * (S_1 - F_c), "tight spans: what presses the pulley");
  STEP(N_2, z * (S_2 - F_c), "slack spans: what presses the pulley");
  const auto load = shaft_load(N_1, N_2, gamma, trace);
  r.R_x = load.R_x, r.R_y = load.R_y, r.R = load.R, r.theta_R = load.theta_R;
}

}  // namespace loadpath::belt
