// A quarter-turn drive: shafts at right angles to each other that do not meet, without guide pulleys.
//
// The line in which the middle planes of the pulleys meet is tangent to both. The belt leaves each pulley where it
// touches this line, in the middle plane of the other pulley, and so runs on there straight; it arrives on the far
// side, along the second tangent from the point where it left. Each span is as long as the centre distance, and leaves
// its pulley at twice the angle at which the radius of the other one is seen. With the direction of rotation reversed
// the belt runs off.
#pragma once

#include "calculators/belt/geometry.hpp"
#include "calculators/belt/shaft_load.hpp"

namespace loadpath::belt {

/// Forces on both shafts, each in its own frame.
struct CrossedForces {
  Force x, y_1, y_2;
};

/// Spans, wraps, and the missing one of a and L.
template <class Result, class Tracer>
void lay_quarter_turn(const Pulleys& pulleys, Result& r, Tracer& trace) {
  r.a = pulleys.a, r.L = pulleys.L;
  if (!is_set(r.a)) {
    r.a = centre_of_length(pulleys);
    trace.value("a", r.a, "centre distance at which the exact length of the belt is L, by Newton");
  }
  STEP_TO(r, beta_1, 2.0 * atan(pulleys.d_1 / (2.0 * r.a)), "the span leaves the driven pulley at this angle");
  STEP_TO(r, beta_2, 2.0 * atan(pulleys.d_2 / (2.0 * r.a)), "the span leaves the driving pulley at this angle");
  STEP_TO(r, alpha_1, pi + beta_1, "wrap angle, driving pulley");
  STEP_TO(r, alpha_2, pi + beta_2, "wrap angle, driven pulley");
  STEP_TO(r, l_s, r.a, "both tangents from the point where the belt leaves a pulley are equal");
  if (!is_set(r.L)) {
    STEP_TO(r, L, 2.0 * l_s + (pulleys.d_1 * alpha_1 + pulleys.d_2 * alpha_2) / 2.0, "two spans and the arcs, exact");
  }
}

/// The forces of spans that load the pulleys with N_1 (tight) and N_2 (slack): the tight span arrives at the driving
/// pulley in its plane and leaves the driven one out of its plane, the slack one the other way round.
template <class Result>
CrossedForces crossed_forces(Force N_1, Force N_2, const Result& r) {
  return {N_1 * cos(r.beta_1) + N_2 * cos(r.beta_2), N_1 * sin(r.beta_1), N_2 * sin(r.beta_2)};
}

/// Resultants in operation and at standstill, where both spans have the tension S_0.
template <class Result, class Tracer>
void load_crossed_shafts(Force N_1, Force N_2, Result& r, Tracer& trace) {
  STEP_TO(r, R_x, N_1 * cos(r.beta_1) + N_2 * cos(r.beta_2), "shaft load in operation along the line of centres");
  STEP_TO(r, R_y, N_1 * sin(r.beta_1), "across it on the driving shaft; on the driven shaft along the shaft");
  STEP(R_z, N_2 * sin(r.beta_2), "along the driving shaft; on the driven shaft across the line of centres");
  STEP_TO(r, R, sqrt(R_x * R_x + R_y * R_y + R_z * R_z), "shaft load in operation; equal and opposite on both shafts");
  STEP_TO(r, theta_R, atan(R_y / R_x), "direction of the shaft load to the line of centres, driving shaft");
  STEP_TO(r, R_0, r.S_0 * sqrt(pow<2>(cos(r.beta_1) + cos(r.beta_2)) + pow<2>(sin(r.beta_1)) + pow<2>(sin(r.beta_2))),
          "both spans at standstill");
}

/// The full loads of the two shafts, by the larger resultant.
template <class Result>
void hand_over_crossed(Moment T_1, Moment T_2, Force N_1, Force N_2, Length d_1, Length d_2, AngularSpeed n_1,
                       Result& r) {
  const CrossedForces pull = r.R_0 > r.R ? crossed_forces(r.S_0, r.S_0, r) : crossed_forces(N_1, N_2, r);
  r.shaft_1 = shaft_load(T_1, {pull.x, pull.y_1, pull.y_2}, d_1, n_1, 0.0);
  r.shaft_2 = shaft_load(T_2, {pull.x, pull.y_2, pull.y_1}, d_2, r.n_2, 0.0);
  r.shaft_1.kind = r.shaft_2.kind = Mounted::pulley;
}

}  // namespace loadpath::belt
