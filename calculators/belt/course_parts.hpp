// Data shared by the evaluation and the rules of belt.course: the pulleys as circles, and the movable pulley.
#pragma once

#include "calculators/belt/course_types.hpp"

#include <algorithm>

namespace loadpath::belt {

inline double turn_of(const CourseTypes::Input& in) { return in.turns == CourseTypes::Turns::ccw ? 1.0 : -1.0; }
/// +1 where the pulley turns counter-clockwise.
inline double sense_of(const CourseTypes::Input& in, const CourseTypes::Pulley& p) {
  return p.side == CourseTypes::Side::inside ? turn_of(in) : -turn_of(in);
}

using Circles = List<Circle, most_pulleys>;

inline Circles circles_of(const CourseTypes::Input& in) {
  Circles circles;
  for (const CourseTypes::Pulley& p : in.pulleys)
    circles.push_back({{in_si(p.x), in_si(p.y)}, in_si(p.d) / 2.0, p.side == CourseTypes::Side::outside});
  return circles;
}

/// The place of the pulley that moves; the number of pulleys where none does.
inline std::size_t moving_one(const CourseTypes::Input& in) {
  const auto moves = [](const CourseTypes::Pulley& p) { return is_set(p.along); };
  return static_cast<std::size_t>(std::find_if(in.pulleys.begin(), in.pulleys.end(), moves) - in.pulleys.begin());
}

inline Shift shift_of(const CourseTypes::Input& in, const Circles& circles) {
  const std::size_t moving = moving_one(in);
  return shift_for(in_si(in.L), circles, turn_of(in), moving, in.pulleys[moving].along);
}

inline bool has_powers(const CourseTypes::Input& in) {
  return std::any_of(in.pulleys.begin(), in.pulleys.end(), [](const CourseTypes::Pulley& p) { return is_set(p.P); });
}

}  // namespace loadpath::belt
