// Torques along a shaft and the internal moment between them.
#pragma once

#include "lib/calculator/list.hpp"
#include "lib/quantity/units.hpp"

#include <cstddef>

namespace loadpath::shaft {

/// A torque on the shaft at x, positive like the torques of the input.
struct AppliedTorque {
  Length x;
  Moment T;
};

/// A cylinder of the shaft as the user gave it; NaN where a value is left to the calculator.
struct Cylinder {
  Length l;
  Length d;
  double chi;
  Length d_bore;
  Length rho = unset<Length>;  // radius of the stress that is shown
};

/// A stretch between two neighbouring sections in which moment and diameter are constant.
struct Stretch {
  Length x;           // position of its left end
  Moment M;           // internal torque: sum of the torques to the left
  Cylinder cylinder;  // that it is cut from, with the length of the stretch
};

inline constexpr std::size_t most_torques = 33;
inline constexpr std::size_t most_cylinders = 32;
inline constexpr std::size_t most_stretches =
    most_torques + 1 + most_cylinders;  // each ends at a torque or a cylinder's end

using Torques = List<AppliedTorque, most_torques + 1>;  // with the reaction of an end that is held
using Cylinders = List<Cylinder, most_cylinders>;
using Stretches = List<Stretch, most_stretches>;

/// The stretches from left to right, at least one. Torques may come in any order; those that share a place act
/// together.
Stretches stretches(Torques torques, const Cylinders& cylinders);

}  // namespace loadpath::shaft
