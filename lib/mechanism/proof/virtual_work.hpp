// Two proofs by the principle of virtual displacements (text D, section 4): each unknown by itself, from one equation.
#pragma once

#include "lib/mechanism/proof/forces.hpp"
#include "lib/mechanism/proof/instant.hpp"

#include <cstddef>
#include <vector>

namespace loadpath::mechanism {

/// The effort, N m or N, of this driver: it alone moves, and the powers of all that acts sum up to nothing.
double effort_by_virtual_power(const Instant& instant, std::size_t driver);

/// Reactions, each component of which does work where its constraint alone is released and all drivers are held; the
/// efforts likewise. Group after group, the last first: what a later group presses with is a force on those before.
class ReleasedConstraints {
 public:
  void find_forces(const Instant& instant, Forces& forces);

 private:
  std::vector<double> acting_, multipliers_;
};

}  // namespace loadpath::mechanism
