// Declarations shared by the parts of the calculation of a gear pair.
#pragma once

#include "calculators/gear/angles.hpp"
#include "calculators/gear/pair_input.hpp"
#include "calculators/gear/pair_result.hpp"
#include "lib/calculator/trace.hpp"

#include <cmath>

namespace loadpath::gear {

/// 1 for a wheel with outer teeth, -1 for a ring: the sign that ISO 21771 gives to its number of teeth.
inline double sign_of(Mesh mesh) { return mesh == Mesh::internal ? -1.0 : 1.0; }

/// Whether the profile shifts give a valid tooth form; limits report the invalid ones.
inline bool has_teeth(const PairInput& in, const PairResult& r) {
  return r.q_a >= 1.0 && (in.mesh == Mesh::rack || std::abs(r.x_2) <= most_shift) && r.s_a > 0.0;
}

}  // namespace loadpath::gear
