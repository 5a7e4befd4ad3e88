// Bars under an eccentric load or with an initial bow: the mean stress at which the extreme fibre yields,
// and its deflection and stress under the given force.
//
// The secant formula for the eccentricity e, [Gere]; a bow in half a sine wave of amplitude e_0 over the effective
// length grows by 1/(1 - F/N_cr), [Case-Chilver]. Both are those of the hinged bar of the effective length.
#pragma once

#include "calculators/column/buckling_parts.hpp"

#include <algorithm>

namespace loadpath::column {

/// What the force is off the axis, and the extreme fibre on that side.
struct Offset {
  Length e, e_0, c;
};

template <class Tracer>
Offset offset_about(const BucklingInput& in, AxisName axis, Tracer& trace) {
  const bool about_y = axis == AxisName::y;
  const auto or_none = [](Length given) { return is_set(given) ? given : 0.0 * mm; };
  return {trace.value("e", or_none(about_y ? in.e_y : in.e_z), "eccentricity in the plane of bending"),
          trace.value("e_0", or_none(about_y ? in.e_0y : in.e_0z), "initial bow in the plane of bending"),
          trace.value("c", or_none(extreme_fibre(in, axis)), "distance of the extreme fibre from the axis")};
}

/// The mean stress that the secant formula allows without safety.
template <class Tracer>
void yield_off_axis(const BucklingInput& in, AxisResult& a, Tracer& trace) {
  const auto sigma_s = a.sigma_s = secant_stress(a.lambda, a.eta, in.E, in.R_e, a.eta_0);
  trace.value("sigma_s", sigma_s, "found so that the extreme fibre yields, or the bar buckles by Euler without e, e_0");
  if (!(a.eta_0 > 0.0)) {
    STEP(sigma_edge, sigma_s * (1.0 + a.eta / cos(0.5 * a.lambda * sqrt(sigma_s / in.E))),
         "extreme fibre at this mean stress, secant formula, [Gere]");
    return;
  }
  STEP(x_s, sigma_s * pow<2>(a.lambda / pi) / in.E, "this mean stress over that of Euler");
  STEP(sigma_edge, sigma_s * (1.0 + a.eta / cos(0.5 * pi * sqrt(x_s)) + a.eta_0 / (1.0 - x_s)),
       "extreme fibre at this mean stress, secant formula, [Gere], with the bow, [Case-Chilver]");
}

/// Elastic: the deflection grows without end towards the critical force, and is none of this bar from there on.
template <class Tracer>
void bend_off_axis(const Offset& at, const MemberResult& r, AxisResult& a, Tracer& trace) {
  if (!(r.F > 0.0 * kN) || !is_set(a.N_cr)) return;
  if (!(r.F < a.N_cr)) {
    a.w = trace.value("w", unset<Length>, "no equilibrium at or above the critical force");
    return;
  }
  const auto e = at.e, e_0 = at.e_0, c = at.c;
  STEP(x, r.F / a.N_cr, "force / critical force");
  STEP_TO(a, w, e * (1.0 / cos(0.5 * pi * sqrt(x)) - 1.0) + e_0 * x / (1.0 - x),
          "the eccentricity grows by the secant, [Gere], the bow by 1/(1 - x), [Case-Chilver]");
  STEP_TO(a, sigma_max, r.F / r.A * (1.0 + (e + e_0 + w) * c / pow<2>(a.i)),
          "extreme fibre, from the force and its lever, [Gere]");
}

/// The axis that was added last.
template <class Tracer>
void take_offset(const BucklingInput& in, AxisName axis, MemberResult& r, Tracer& trace) {
  if (!offset_is_given(in) || !is_set(in.E)) return;
  AxisResult& a = r.axes.back();
  const Offset at = offset_about(in, axis, trace);
  const auto e = at.e, e_0 = at.e_0, c = at.c;
  STEP_TO(a, eta, e * c / pow<2>(a.i), "eccentricity ratio, [Gere]");
  STEP_TO(a, eta_0, e_0 * c / pow<2>(a.i), "bow ratio, as that of the eccentricity");
  if (is_set(in.R_e)) yield_off_axis(in, a, trace);
  bend_off_axis(at, r, a, trace);
}

/// Both axes: a bar that buckles about the other axis is not held by this one.
template <class Tracer>
void sum_up_offset(const BucklingInput& in, MemberResult& r, Tracer& trace) {
  if (!offset_is_given(in) || !(r.F > 0.0 * kN) || !is_set(in.E)) return;
  const AxisResult &y = r.axes[0], &z = r.axes[1];
  if (is_set(y.sigma_max) && is_set(z.sigma_max)) {
    r.w = trace.value("w", max(y.w, z.w), "the larger of the two axes");
    r.sigma_max = trace.value("sigma_max", max(y.sigma_max, z.sigma_max), "the larger of the two axes");
  }
  if (!is_set(in.R_e)) return;
  const auto sigma_s = trace.value("sigma_s", min(y.sigma_s, z.sigma_s), "the lower of the two axes");
  STEP_TO(r, n_e, sigma_s * r.A / r.F, "force at which the extreme fibre yields / force");
}

}  // namespace loadpath::column
