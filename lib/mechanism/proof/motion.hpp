// The proof of the motion, from which the forces of inertia come: the joints are closed, and velocities and
// accelerations are those that joints and drives allow.
#pragma once

#include "lib/mechanism/proof/instant.hpp"

#include <span>
#include <vector>

namespace loadpath::mechanism {

class MotionProof {
 public:
  explicit MotionProof(const Instant& instant);
  /// The largest gap of a joint or miss of a drive, in units of the mechanism's length or rad; or the largest error of
  /// a constraint's velocity or acceleration over the largest of the links, centripetal accelerations among them. Takes
  /// no memory.
  double residual(const Instant& instant, std::span<const Drive> drives);

 private:
  // Velocities of the links, with three zeros for the ground, and rates of the constraints.
  std::vector<double> velocity_, acceleration_, rate_, rate_change_;
};

}  // namespace loadpath::mechanism
