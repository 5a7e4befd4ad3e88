// The proof by the full system: the equations of equilibrium of all links at once, three for each, for all components
// of the reactions and all efforts.
#pragma once

#include "lib/mechanism/proof/forces.hpp"
#include "lib/mechanism/proof/instant.hpp"
#include "lib/numerics/sparse_lu.hpp"

namespace loadpath::mechanism {

class AllEquations {
 public:
  explicit AllEquations(const Instant& instant);
  /// Gives NaN if singular to rounding.
  void find_forces(const Instant& instant, Forces& forces);

 private:
  void supply(const ActiveForce& active);

  numerics::SparseLu factors_;
  std::vector<double> velocity_, acceleration_, unknowns_;
};

}  // namespace loadpath::mechanism
