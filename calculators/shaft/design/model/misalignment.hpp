// Misalignment of the teeth of a cylindrical gear from the deflection of its shaft, across the face width.
#pragma once

#include "calculators/shaft/design/model/bending.hpp"

namespace loadpath::shaft {

/// Displacements along the transverse normal force of the mesh, positive where the shaft yields more at the right end
/// of the face: by bending of the shaft, and by twist at the base radius, of the shaft or of the body of the gear up to
/// its root circle where this is stiffer. `sag`: of the middle of the face against its ends.
struct Misalignment {
  double bending = 0.0, twist = 0.0, sag = 0.0;
};

/// Whether the face width of a gear with a transverse force is known.
bool has_face(const Seat& seat);

/// Across the face of a gear at a position of the turn. Its load is concentrated at the middle of the face; a uniform
/// load turns the face of a shaft on two bearings less, by the share b^2/(16 a c), a and c their distances.
Misalignment misalignment_of(const DesignInput& in, const Elastic& elastic, const Loaded& loaded, std::size_t seat,
                             std::size_t position);

}  // namespace loadpath::shaft
