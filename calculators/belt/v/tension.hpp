// Initial tension of V-belts by the rule of their basis, how it is measured, and what it does to the shafts.
#pragma once

#include "calculators/belt/shaft_load.hpp"
#include "calculators/belt/v/types.hpp"

namespace loadpath::belt {

/// Force that one belt carries over, and the tension that presses it into the grooves at rest.
struct Press {
  Force F_t, N_0;
};

template <class Tracer>
Press press(const VTypes::Input& in, const VTypes::Result& r, Tracer& trace) {
  STEP(F_t, r.P_B / (r.z * r.v), "circumferential force of one belt");
  if (in.basis == Basis::optibelt) {
    STEP(N_0, (2.02 - r.c_alpha) / (2.0 * r.c_alpha) * r.P_B / (r.z * r.v),
         "tension that presses a belt into its grooves, [Optibelt-V]");
    return {F_t, N_0};
  }
  STEP(K_P, is_set(in.K_A_1) ? in.K_A_1 : r.K_A,
       is_set(in.K_A_1) ? "for one shift, as given" : "service factor of the power, at least that of one shift");
  STEP(N_0, (2.5 - r.c_alpha) / (2.0 * r.c_alpha) * K_P * in.P / (r.z * r.v),
       "tension that presses a belt into its grooves, [GOST1284.3] (16)");
  return {F_t, N_0};
}

/// Whether friction in the grooves of each pulley, at its own groove angle, holds the force.
template <class Tracer>
void grip(const VTypes::Input& in, const Press& pressed, VTypes::Result& r, Tracer& trace) {
  if (!is_set(in.mu)) return;
  const auto& [F_t, N_0] = pressed;
  STEP(mu_1, in.mu / sin(r.phi_1 / 2.0), "wedge friction of the driving pulley");
  STEP(mu_2, in.mu / sin(r.phi_2 / 2.0), "wedge friction of the driven pulley");
  STEP(m_e, exp(min(mu_1 * r.alpha_1, mu_2 * r.alpha_2)), "Euler's condition at the pulley that slips first, [B40]");
  STEP(N_min, F_t / 2.0 * (m_e + 1.0) / (m_e - 1.0), "minimum tension that holds the force");
  STEP_TO(r, u_grip, N_min / N_0, "grip condition");
}

template <class Tracer>
void tension(const VSection& section, const VTypes::Input& in, VTypes::Result& r, Tracer& trace) {
  const auto m = trace.value("m", section.row.m, "mass per length of one belt");
  STEP_TO(r, F_c, m * r.v * r.v, "centrifugal tension; it does not press the belt into the grooves");
  const Press pressed = press(in, r, trace);
  const auto& [F_t, N_0] = pressed;
  grip(in, pressed, r, trace);
  const bool fixed = in.tensioning == VTypes::Tensioning::fixed;
  const Force F_lost = trace.value(
      "F_lost", fixed ? F_c : 0.0 * F_c,
      fixed ? "on fixed centres the centrifugal part relieves the grooves" : "the tensioner makes up for it");
  STEP_TO(r, F_0, N_0 + F_lost, "initial tension of one belt span, run-in");
  STEP_TO(r, F_0_new, 1.3 * F_0, "new belts lose tension when they run in, [Optibelt-V]");
  STEP_TO(r, S_1, N_0 + F_c + F_t / 2.0, "tight span of one belt");
  STEP_TO(r, S_2, S_1 - F_t, "slack span of one belt");
}

/// Deflection under a test force, and frequency of the plucked span.
template <class Tracer>
void measure(const VSection& section, VTypes::Result& r, Tracer& trace) {
  const auto m = section.row.m;
  STEP_TO(r, y, 1.55 / 100.0 * r.a, "deflection of a span, [GOST1284.3] (17)");
  if (section.basis == Basis::iso) {
    const auto C_0 = trace.value("C_0", section.row.C_0, "stiffness of the belt, [GOST1284.3] 21");
    STEP_TO(r, Q, (r.F_0 + C_0) / 16.0, "test force, [GOST1284.3] (19)");
    STEP_TO(r, Q_new, (r.F_0_new + C_0) / 16.0, "test force of a new belt, [GOST1284.3] (18)");
  } else {
    STEP_TO(r, Q, 4.0 * r.F_0 * y / r.l_s, "test force of a taut string, without the stiffness of the belt");
    STEP_TO(r, Q_new, 4.0 * r.F_0_new * y / r.l_s, "test force of a new belt");
  }
  STEP_TO(r, f_s, sqrt(r.F_0 / m) / (2.0 * r.l_s), "first frequency of a taut string");
  STEP_TO(r, f_s_new, sqrt(r.F_0_new / m) / (2.0 * r.l_s), "first frequency, new belt");
}

template <class Tracer>
void load_shafts(VTypes::Result& r, Tracer& trace) {
  STEP_TO(r, R_0, 2.0 * r.z * r.F_0 * r.l_s / r.a, "two spans of every belt at standstill, along the line of centres");
  STEP_TO(r, R_new, 2.0 * r.z * r.F_0_new * r.l_s / r.a, "the same of new belts");
  STEP(N_1, r.z * (r.S_1 - r.F_c), "tight side tension less centrifugal tension");
  STEP(N_2, r.z * (r.S_2 - r.F_c), "slack side tension less centrifugal tension");
  load_shaft(N_1, N_2, r.gamma, r, trace);
}

}  // namespace loadpath::belt
