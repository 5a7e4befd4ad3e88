// Loads of a belt on its shafts: the resultant of the two spans, on each pulley towards the other.
#pragma once

#include "calculators/load/shaft_load.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath::belt {

/// A resultant on both shafts, with the torque of the shaft that it is taken for.
template <class Result>
constexpr auto pull(Force Result::*at, const char* key, const char* doc, const char* with = "shaft_1.T|shaft_2.T") {
  return Field<Result, Force>{at, key, N, doc}.load().with(with).holding("K_A");
}

/// Resultant of spans that load the pulleys with N_1 (tight) and N_2 (slack): their tensions without the part that
/// turns the belt around. psi is the inclination of the tight span, positive away from the line of centres. R_x along
/// that line is positive toward the driven pulley, R_y and theta_R to the side of the tight span.
template <class Result, class Tracer>
void load_shaft(Force N_1, Force N_2, double psi, Result& r, Tracer& trace) {
  trace.angle("psi", psi, "inclination of the tight span, positive where it leaves the line of centres");
  STEP_TO(r, R_x, (N_1 + N_2) * cos(psi), "shaft load in operation along the line of centres");
  STEP_TO(r, R_y, (N_1 - N_2) * sin(psi), "across it, positive to the side of the tight span");
  STEP_TO(r, R, sqrt(R_x * R_x + R_y * R_y), "shaft load in operation; equal and opposite on the driven shaft");
  STEP_TO(r, theta_R, atan(R_y / R_x), "direction of the shaft load to the line of centres");
}

/// The largest resultant on each shaft: R in operation, or one along the line of centres at standstill (R_0, new
/// belts R_new), larger for new belts or where centrifugal force relieves the pulleys.
template <class Result>
ShaftForces largest_pull(const Result& r, Force at_standstill) {
  const Force none = 0.0 * N.one;
  return at_standstill > r.R ? ShaftForces{at_standstill, none, none} : ShaftForces{r.R_x, r.R_y, none};
}

/// The full loads of the two shafts. y points on the driving shaft to the side of the tight span, on the driven shaft
/// to the opposite side.
template <class Result>
void hand_over(Moment T_1, Moment T_2, const ShaftForces& pull, Length d_1, Length d_2, AngularSpeed n_1, Result& r) {
  r.shaft_1 = shaft_load(T_1, pull, d_1, n_1, 0.0);
  r.shaft_2 = shaft_load(T_2, pull, d_2, r.n_2, 0.0);
  r.shaft_1.kind = r.shaft_2.kind = Mounted::pulley;
}

}  // namespace loadpath::belt
