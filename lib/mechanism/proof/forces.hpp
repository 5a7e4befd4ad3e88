// The forces in a mechanism at one position, as one method finds them, and how far two methods are apart.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <vector>

namespace loadpath::mechanism {

/// As long as the model's joints and drivers.
struct Forces {
  std::vector<Reaction> reactions;
  std::vector<double> effort;  // N m or N
};

Forces blank_forces(const Model& model);

/// The sum of two that act at the same point.
inline Reaction operator+(const Reaction& a, const Reaction& b) {
  return {a.at, a.force + b.force, a.couple + b.couple};
}

/// The largest difference of two reactions, N; moments about the place of the first over `length`, m.
double difference(const Reaction& a, const Reaction& b, double length);

}  // namespace loadpath::mechanism
