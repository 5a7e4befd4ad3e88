// The course of a vessel calculation, the same for all shapes: least thickness, thickness that carries, stresses at the
// governing place, allowable pressure.
#pragma once

#include "calculators/vessel/capacity.hpp"
#include "calculators/vessel/membrane.hpp"

namespace loadpath::vessel {

inline Strength strength_of(const WallInput& in, Stress sigma_all) {
  return {sigma_all, in.z_l, in.z_c, in.hypothesis};
}

/// The thickness to order for a carrying thickness.
template <class Tracer>
Length ordered(const char* symbol, Length carrying, const WallInput& in, Tracer& trace) {
  const Length delta_0 = carrying;
  trace.value("delta_0", delta_0, "thickness at which the governing location reaches the allowable stress");
  return NAMED_STEP(symbol, (delta_0 + in.c + in.c_t) / (1.0 - in.f_t), "with its allowances, each once");
}

template <class Tracer>
Length carrying(const WallInput& in, Length delta, Tracer& trace) {
  return NAMED_STEP("delta_c", delta * (1.0 - in.f_t) - in.c - in.c_t,
                    "wall thickness less corrosion and mill tolerance");
}

template <class Tracer>
Length mean_radius(Length R, Length e, Tracer& trace) {
  return NAMED_STEP("R_m", R + e, "mid-surface radius");
}

/// The bound of the hoop compression of heads whose crown has this radius.
template <class Tracer>
double knuckle_slenderness(Length rho_c, Length delta_c, Tracer& trace) {
  trace.value("rho_c", rho_c, "radius of the crown");
  return NAMED_STEP("w_b", 0.002 * rho_c / delta_c,
                    "knuckles in compression thinner than 0.002 of the crown radius may buckle, [UG-32]");
}

/// Shell without hole: bending decays from its edge over some sqrt(rho t), to exp(-1.29 x) at the distance x sqrt(rho
/// t), [Timoshenko]; from x = 4 on, 0.6 %, its middle is a membrane. A shallow dish bends throughout.
template <class Tracer>
double shallowness_of(Length widest, Length flattest, Length delta_c, Tracer& trace) {
  trace.value("r_a", widest, "widest radius");
  trace.value("rho_a", flattest, "radius of curvature where the shell is flattest");
  const Length r_a = widest, rho_a = flattest;
  return NAMED_STEP("x_s", r_a / sqrt(rho_a * delta_c), "radius / decay length of edge bending");
}

/// Sizes and checks the shape that `make(delta_c)` gives for a carrying thickness. `trace_radii(e, trace)`
/// writes its radii down, which lie e outside of those given. Returns the governing place.
template <class Input, class Result, class Make, class TraceRadii, class Tracer>
double assess(const Input& in, Result& r, Length scale, const Make& make, const TraceRadii& trace_radii,
              Tracer& trace) {
  const Stress sigma_all = r.sigma_all = allowable(in, trace);
  const Strength strength = strength_of(in, sigma_all);
  r.delta_min = ordered("delta_min", least_thickness(make, in.p, scale, strength), in, trace);
  r.delta = is_set(in.delta) ? in.delta : r.delta_min;
  r.delta_c = carrying(in, r.delta, trace);
  trace_radii(offset(in, r.delta, r.delta_c, trace), trace);
  const auto shape = make(r.delta_c);
  const Length rho_min = trace.value("rho_min", shape.sharpest(), "minimum radius of curvature of the shell");
  STEP_TO(r, t_R, r.delta_c / rho_min, "thin walls are below 1/20, [B24]; round ones below 1/10");
  if constexpr (requires { r.t_M; }) {
    if (in.hypothesis == Hypothesis::membrane) r.t_M = t_R;
  }
  const double t = governing_place(shape, in.p, r.delta_c, strength);
  const Place place = shape.at(t, trace);
  const Membrane m = membrane(place, in.p, r.delta_c, strength, trace);
  const Stress sigma_v = equivalent(m, strength.hypothesis, trace);
  r.p_i = m.p_i, r.sigma_o = m.o, r.sigma_M = m.M, r.sigma_v = sigma_v;
  STEP_TO(r, u_v, sigma_v / sigma_all, "strength condition, [B24]");
  r.p_max = allowable_pressure(shape, r.delta_c, strength);
  trace.value("p_max", r.p_max, "pressure at which the first location reaches the allowable stress");
  return t;
}

/// The allowable stress in the test and the pressure that it must have; `by_yield`: the yield strength, if it is given,
/// decides the allowable stress in service, which rises with it in the cold. Returns the pressure at the lowest point.
template <class Input, class Result, class Tracer>
Stress test_requirements(const Input& in, bool by_yield, Result& r, Tracer& trace) {
  const Stress R_t = trace.value("R_t", is_set(in.R_e_t) ? in.R_e_t : in.R_e, "yield strength in the test");
  STEP_TO(r, f_test, R_t / 1.05, "[EN13445-3], 6.2");
  const double f_r = trace.value("f_r", by_yield && is_set(in.R_e) ? std::max(in_si(R_t) / in_si(in.R_e), 1.0) : 1.0,
                                 "allowable stress at the temperature of the test over that in service");
  STEP_TO(r, p_tr, max(1.25 * f_r * in.p, 1.43 * in.p), "[EN13445-5], 10.2.3.3");
  STEP_TO(r, u_tr, p_tr / in.p_t, "requirement of the test");
  const Density rho_w = trace.value("rho_w", 1000.0 * kg_per_m3, "water");
  const Acceleration g_n = trace.value("g_n", gravity, "standard acceleration of free fall");
  return NAMED_STEP("p_w", in.p_t + rho_w * g_n * in.h_t, "pressure of the test at the lowest point");
}

}  // namespace loadpath::vessel
