// Input queries common to calculation and rules of motion.plane: the line AB, and the given data of B.
#pragma once

#include "calculators/motion/plane_types.hpp"

#include <cmath>

namespace loadpath::motion {

inline constexpr double square_to_AB = 1e-9;  // cosine below which a direction counts as perpendicular to AB

inline double distance(const PlaneTypes::Input& in) {
  return std::hypot(in_si(in.B.x - in.A.x), in_si(in.B.y - in.A.y));
}

/// The cosine of a direction against AB.
inline double cosine_to_AB(const PlaneTypes::Input& in, double alpha) {
  return (in_si(in.B.x - in.A.x) * cos(alpha) + in_si(in.B.y - in.A.y) * sin(alpha)) / distance(in);
}
inline bool is_across_AB(const PlaneTypes::Input& in, double alpha) {
  return std::abs(cosine_to_AB(in, alpha)) <= square_to_AB;
}

/// The speed of B where it was not given: where it rests its direction does not matter.
inline bool rests_in_B(const PlaneTypes::Input& in) { return is_set(in.v_B) && in_si(in.v_B) == 0.0; }
inline bool uses_B(const PlaneTypes::Input& in) { return !is_set(in.omega); }

}  // namespace loadpath::motion
