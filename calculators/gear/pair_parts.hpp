// The parts of the calculation of a pair of gears, in their order; each fills its fields of the result.
#pragma once

#include "calculators/gear/pair.hpp"

#include <cmath>

namespace loadpath::gear {

/// 1 for a wheel with outer teeth, -1 for a ring: the sign that ISO 21771 gives to its number of teeth.
inline double sign_of(Mesh mesh) { return mesh == Mesh::internal ? -1.0 : 1.0; }

/// Whether the profile shifts leave teeth that have a form; limits tell where they do not.
inline bool has_teeth(const Pair::Input& in, const PairResult& r) {
  return r.q_a >= 1.0 && (in.mesh == Mesh::rack || std::abs(r.x_2) <= most_shift) && r.s_a > 0.0;
}

/// Reference circles, centre distance or profile shift, diameters and clearances.
template <class Tracer>
void lay_out(const Pair::Input& in, PairResult& r, Tracer& trace);

/// Path of contact and contact ratios; undercut and interference.
template <class Tracer>
void bring_to_mesh(const Pair::Input& in, PairResult& r, Tracer& trace);

/// Thickness at the reference circle and at the tip, backlash, base-tangent length.
template <class Tracer>
void measure_teeth(const Pair::Input& in, PairResult& r, Tracer& trace);

/// Speeds, torques, forces, bending by Lewis; only what the load that is given allows.
template <class Tracer>
void load_teeth(const Pair::Input& in, PairResult& r, Tracer& trace);

}  // namespace loadpath::gear
