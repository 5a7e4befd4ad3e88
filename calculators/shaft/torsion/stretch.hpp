// One stretch of a shaft in torsion: its least diameter by strength and by stiffness, its stress and its twist.
#pragma once

#include "calculators/shaft/round_sizing.hpp"
#include "calculators/shaft/torsion/types.hpp"
#include "lib/calculator/trace.hpp"

namespace loadpath::shaft {

/// Data for sizing and checking of one stretch in addition to its moment.
struct Allowed {
  Stress tau_all;
  Stress G;
  Twist theta_adm;
};

inline constexpr SizingReasons by_strength{"strength, [B19] (4)", "strength of a ring, [B19] (5)",
                                           "strength: the diameter that has W_t with the given bore, [B19] (3)"};

/// The least diameter by strength.
template <class Tracer>
Length size_by_strength(Moment M_t, const Cylinder& c, Stress tau_all, Tracer& trace) {
  if (!is_set(tau_all)) return unset<Length>;
  STEP(W_t, M_t / tau_all, "required torsional section modulus for strength, [B19] (3)");
  return size_for_modulus("d_strength", W_t, {c.chi, c.d_bore}, by_strength, trace);
}

/// The same by stiffness.
template <class Tracer>
Length size_by_stiffness(Moment M_t, const Cylinder& c, const Allowed& allowed, Tracer& trace) {
  const auto& [tau_all, G, theta_adm] = allowed;
  const Length d_bore = c.d_bore;
  if (!is_set(theta_adm)) return unset<Length>;
  if (is_set(c.chi))
    return NAMED_STEP("d_stiffness", sqrt(sqrt(32.0 * M_t / (pi * G * theta_adm * (1.0 - pow<4>(c.chi))))),
                      "stiffness of a ring, [B19] (10)");
  if (is_set(d_bore))
    return NAMED_STEP("d_stiffness", sqrt(sqrt(pow<4>(d_bore) + 32.0 * M_t / (pi * G * theta_adm))),
                      "stiffness with the given bore, [B19] (8)");
  return NAMED_STEP("d_stiffness", sqrt(sqrt(32.0 * M_t / (pi * G * theta_adm))), "stiffness, [B19] (9)");
}

/// Stress and twist of one stretch at its diameter.
template <class Tracer>
void load(TorsionTypes::Stretch& s, Length rho, Stress G, double K_A, Tracer& trace) {
  if (s.M_t <= 0.0 * N_m.one && !(s.d > s.d_bore)) {  // no moment has sized it, and none loads it
    s.tau = trace.value("tau", from_si<Stress>(0.0), "no moment");
    if (is_set(G)) s.theta = from_si<Twist>(0.0), s.phi = is_set(s.l) ? 0.0 : s.phi;
    return;
  }
  STEP(I_t, pi / 32.0 * (pow<4>(s.d) - pow<4>(s.d_bore)), "polar second moment of area");
  STEP_TO(s, tau, s.M_t * s.d / (2.0 * I_t), "at the surface, [B19] (2)");
  constexpr double rounding = 1e-9;
  const bool in_wall = rho >= s.d_bore / 2.0 * (1.0 - rounding) && rho <= s.d / 2.0 * (1.0 + rounding);
  if (in_wall) {
    trace.value("rho", rho, "radius of the stress");
    STEP_TO(s, tau_rho, s.M_t * rho / I_t, "linear over the radius, [B19] (12)");
  }
  if (!is_set(G)) return;
  STEP_TO(s, GI_t, G * I_t, "torsional stiffness, [B19]");
  STEP_TO(s, theta, K_A * s.M / GI_t, "angle of twist per unit length, signed, [B19] (7)");
  if (in_wall) {
    STEP(tau_G, G * rho * abs(theta), "the same stress by the twist, [B19]");
  }
  if (!is_set(s.l)) return;
  STEP_TO(s, phi, theta * s.l, "twist of the stretch");
}

}  // namespace loadpath::shaft
