// Tolerances, clearance and outputs of a project in the terms of lib/mechanism/accuracy/tolerance.hpp.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/mechanism/accuracy/tolerance.hpp"

#include <string>
#include <vector>

namespace loadpath::planar {

/// How a kind of tolerance is given: which fields name what it is of, and which give its half width.
struct ToleranceShape {
  bool link = false, point = false, to = false, joint = false, spring = false;
  bool t = false, t_angle = false, t_mass = false, t_part = false;
};
ToleranceShape shape_of(planar::Toleranced of, const Mechanism::Input& in, const planar::Tolerance& tolerance);

/// In the order of the project; the names have been checked.
std::vector<mechanism::Tolerance> tolerances_of(const Mechanism::Input& in, const mechanism::Model& model);
/// Clearances of the pins that have one, in their order.
std::vector<mechanism::Clearance> clearances_of(const Mechanism::Input& in);
mechanism::Output output_of(const Mechanism::Input& in, const mechanism::Model& model, const planar::Accuracy& wanted);

/// Half the width of a tolerance as it is typed, with its unit.
struct HalfWidth {
  double si = 0.0;
  const char* unit = "mm";
};
HalfWidth half_width(const planar::Tolerance& tolerance);

}  // namespace loadpath::planar
