// Sides of contours by points: which of them touch, and what lies inside. Corners have the coordinates y and z.
#pragma once

#include "lib/quantity/units.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace loadpath::section {

/// Twice the area of the triangle, positive if c lies to the left of the line from a to b.
template <class Corner>
double side_of(const Corner& a, const Corner& b, const Corner& c) {
  return in_si(b.y - a.y) * in_si(c.z - a.z) - in_si(b.z - a.z) * in_si(c.y - a.y);
}

template <class Corner>
bool is_between(const Corner& a, const Corner& b, const Corner& c) {
  return min(a.y, b.y) <= c.y && c.y <= max(a.y, b.y) && min(a.z, b.z) <= c.z && c.z <= max(a.z, b.z);
}

/// Whether two sides share a point.
template <class Corner>
bool meet(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  const double c_side = side_of(a, b, c), d_side = side_of(a, b, d), a_side = side_of(c, d, a),
               b_side = side_of(c, d, b);
  if (c_side * d_side < 0.0 && a_side * b_side < 0.0) return true;
  return (c_side == 0.0 && is_between(a, b, c)) || (d_side == 0.0 && is_between(a, b, d)) ||
         (a_side == 0.0 && is_between(c, d, a)) || (b_side == 0.0 && is_between(c, d, b));
}

template <class Corners>
const auto& next(const Corners& corners, std::size_t i) {
  return corners[(i + 1) % corners.size()];
}

struct Sides {
  std::size_t first = 0, second = 0;
  bool found = false;
};

/// Two sides of one contour that touch where they should not; neighbours share their corner only.
template <class Corners>
Sides crossing_of(const Corners& corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto &a = corners[i], &b = next(corners, i), &after = next(corners, (i + 1) % n);
    const bool no_length = a.y == b.y && a.z == b.z;
    const bool folds = side_of(a, b, after) == 0.0 && (is_between(a, b, after) || is_between(b, after, a));
    if (no_length || folds) return {i, (i + 1) % n, true};
    for (std::size_t j = i + 2; j < n; ++j) {
      const bool neighbours = (j + 1) % n == i;
      if (!neighbours && meet(a, b, corners[j], next(corners, j))) return {i, j, true};
    }
  }
  return {};
}

template <class First, class Second>
bool contours_meet(const First& first, const Second& second) {
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = 0; j < second.size(); ++j) {
      if (meet(first[i], next(first, i), second[j], next(second, j))) return true;
    }
  }
  return false;
}

/// By the number of sides that a ray to the right meets.
template <class Corners, class Corner>
bool is_inside(const Corners& corners, const Corner& p) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = next(corners, i);
    if ((a.z > p.z) == (b.z > p.z)) continue;
    if (p.y < a.y + static_cast<double>((p.z - a.z) / (b.z - a.z)) * (b.y - a.y)) inside = !inside;
  }
  return inside;
}

/// Half-way between two corners.
template <class Corner>
Corner middle(const Corner& a, const Corner& b) {
  return {0.5 * (a.y + b.y), 0.5 * (a.z + b.z)};
}

/// How far a point is from the nearest side.
template <class Corners, class Corner>
double distance_to(const Corners& corners, const Corner& p) {
  double nearest = 1e300;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = next(corners, i);
    const double y = in_si(b.y - a.y), z = in_si(b.z - a.z), length = y * y + z * z;
    const double along = length > 0.0 ? (in_si(p.y - a.y) * y + in_si(p.z - a.z) * z) / length : 0.0;
    const double t = std::clamp(along, 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(in_si(p.y - a.y) - t * y, in_si(p.z - a.z) - t * z));
  }
  return nearest;
}

/// Whether a corner of the second, the middle of one of its sides, or a point within it lies inside of the first, by
/// more than `little`; of two that share their sides none does.
template <class First, class Second>
bool reaches_into(const First& first, const Second& second, double little) {
  const auto is_within = [&](const auto& p) { return is_inside(first, p) && distance_to(first, p) > little; };
  for (std::size_t i = 0; i < second.size(); ++i) {
    const auto &a = second[i], &b = next(second, i), &c = next(second, (i + 1) % second.size());
    if (is_within(a) || is_within(middle(a, b))) return true;
    const auto p = middle(middle(a, b), middle(b, c));  // within an ear of it
    if (is_inside(second, p) && distance_to(second, p) > little && is_within(p)) return true;
  }
  return false;
}

/// Whether two sides cross, each well beyond the other.
template <class First, class Second>
bool sides_cross(const First& first, const Second& second, double little) {
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = 0; j < second.size(); ++j) {
      const auto &a = first[i], &b = next(first, i), &c = second[j], &d = next(second, j);
      const double first_side = little * std::hypot(in_si(b.y - a.y), in_si(b.z - a.z));
      const double second_side = little * std::hypot(in_si(d.y - c.y), in_si(d.z - c.z));
      const double c_side = side_of(a, b, c), d_side = side_of(a, b, d), a_side = side_of(c, d, a),
                   b_side = side_of(c, d, b);
      const bool apart = std::min(std::abs(c_side), std::abs(d_side)) > first_side &&
                         std::min(std::abs(a_side), std::abs(b_side)) > second_side;
      if (apart && c_side * d_side < 0.0 && a_side * b_side < 0.0) return true;
    }
  }
  return false;
}

}  // namespace loadpath::section
