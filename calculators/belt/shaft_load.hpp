// What a belt does to its shafts: the pull of the two spans on the driving pulley. The driven pulley has the opposite.
#pragma once

#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath::belt {

struct ShaftLoad {
  Force R_x = unset<Force>;  // along the line of centres, positive toward the driven pulley
  Force R_y = unset<Force>;  // across it, positive to the side of the tight span
  Force R = unset<Force>;
  double theta_R = unset<double>;  // against the line of centres, positive like R_y
};

/// Of spans that press the pulleys with N_1 (tight) and N_2 (slack): their tensions without the part that turns the
/// belt around. `slope` is the inclination of the tight span, positive away from the line of centres.
template <class Tracer>
ShaftLoad shaft_load(Force N_1, Force N_2, double slope, Tracer& trace) {
  ShaftLoad load;
  trace.angle("psi", slope, "inclination of the tight span, positive where it leaves the line of centres");
  const double psi = slope;
  STEP(R_x, (N_1 + N_2) * cos(psi), "shaft load in running along the line of centres");
  STEP(R_y, (N_1 - N_2) * sin(psi), "across it, positive to the side of the tight span");
  STEP(R, sqrt(R_x * R_x + R_y * R_y), "shaft load in running; the same on the driven shaft, reversed");
  STEP(theta_R, atan(R_y / R_x), "its direction against the line of centres");
  load.R_x = R_x, load.R_y = R_y, load.R = R, load.theta_R = theta_R;
  return load;
}

}  // namespace loadpath::belt
