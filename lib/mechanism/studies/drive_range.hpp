// How far a mechanism can be driven: the range of its drive in which it closes without leaving its assembly. At an end
// of the range the closing equations are singular: the Jacobian of a group vanishes.
#pragma once

#include "lib/mechanism/model/model.hpp"

#include <limits>
#include <optional>

namespace loadpath::mechanism {

/// Coordinates of the drive, rad or m; infinite on a side where nothing stops it.
struct DriveRange {
  double assembled = 0.0;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

/// Of a model with one drive that has passed `diagnose` and has no redundant joints, from its stated assembly, at most
/// this far down and up. None if it does not close there.
std::optional<DriveRange> drive_range(const Model& model, double down, double up);

}  // namespace loadpath::mechanism
