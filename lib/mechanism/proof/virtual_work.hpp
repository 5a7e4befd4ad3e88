// Two proofs by the principle of virtual displacements (text D, section 4): each unknown by itself, from one equation.
#pragma once

#include "lib/mechanism/proof/forces.hpp"
#include "lib/mechanism/proof/instant.hpp"

#include <cstddef>
#include <vector>

namespace loadpath::mechanism {

/// The effort, N m or N, of this driver: only it moves, and the powers of all loads sum to zero.
double effort_by_virtual_power(const Instant& instant, std::size_t driver);

/// Reactions, each component by the work done when only its constraint is released and all drivers are fixed; the
/// efforts likewise. Group after group, the last first: forces from a later group are loads on those before.
class ReleasedConstraints {
 public:
  void find_forces(const Instant& instant, Forces& forces);

 private:
  std::vector<double> acting_, multipliers_;
};

}  // namespace loadpath::mechanism
