// What thick cylinders and spheres have in common: radii of the carrying wall, stresses at a surface.
#pragma once

#include "calculators/vessel/assess.hpp"

namespace loadpath::vessel {

/// Radii of the wall that corrosion and mill leave, of the given thickness or the least one.
template <class Input, class Result, class Tracer>
void carrying_radii(const Input& in, Length least, Result& r, Tracer& trace) {
  r.delta_min = least;
  r.delta = is_set(in.delta) ? in.delta : r.delta_min;
  r.delta_c = carrying(in, r.delta, trace);
  const Length R_m = mean_radius(in.R, offset(in, r.delta, r.delta_c, trace), trace);
  STEP_TO(r, R_i, R_m - 0.5 * r.delta_c, "inside of the carrying wall");
  STEP_TO(r, R_a, R_m + 0.5 * r.delta_c, "outside of the carrying wall");
}

/// Equivalent stress where the radial stress is that of a pressure.
template <class Tracer>
Stress at_surface(const char* place, const WallInput& in, Stress sigma_t, Stress sigma_z, Stress pressure,
                  const Strength& strength, Tracer& trace) {
  [[maybe_unused]] const auto scope = trace.scope(place, 0);
  trace.value("sigma_t", sigma_t, "hoop stress there");
  trace.value("sigma_z", sigma_z, "axial stress");
  const Stress p_i = trace.value("p_i", pressure, "pressure there");
  STEP(s_o, sigma_t / in.z_l, "hoop stress for longitudinal welds");
  STEP(s_M, sigma_z / in.z_c, "axial stress for circumferential welds");
  return equivalent(s_o, s_M, p_i, strength.hypothesis, trace);
}

/// The larger equivalent stress of both surfaces: between them it is smaller.
template <class Result, class Tracer>
void governing_surface(Stress inner, Stress outer, Result& r, Tracer& trace) {
  r.sigma_vi = trace.value("sigma_vi", inner, "inner surface");
  r.sigma_va = trace.value("sigma_va", outer, "outer surface");
  STEP_TO(r, sigma_v, max(r.sigma_vi, r.sigma_va), "the governing surface: between them it is smaller");
  STEP_TO(r, u_v, r.sigma_v / r.sigma_all, "strength condition");
}

}  // namespace loadpath::vessel
