#include "calculators/section/polygon.hpp"

#include "calculators/section/polygon_moments.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <string>

namespace loadpath::section {

namespace {

using Corner = Polygon::Corner;
using Input = Polygon::Input;

/// Twice the area of the triangle, positive where c lies on the left of the way from a to b.
double side_of(const Corner& a, const Corner& b, const Corner& c) {
  return in_si(b.y - a.y) * in_si(c.z - a.z) - in_si(b.z - a.z) * in_si(c.y - a.y);
}

bool is_between(const Corner& a, const Corner& b, const Corner& c) {
  return min(a.y, b.y) <= c.y && c.y <= max(a.y, b.y) && min(a.z, b.z) <= c.z && c.z <= max(a.z, b.z);
}

/// Whether two sides share a point.
bool meet(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  const double c_side = side_of(a, b, c), d_side = side_of(a, b, d), a_side = side_of(c, d, a),
               b_side = side_of(c, d, b);
  if (c_side * d_side < 0.0 && a_side * b_side < 0.0) return true;
  return (c_side == 0.0 && is_between(a, b, c)) || (d_side == 0.0 && is_between(a, b, d)) ||
         (a_side == 0.0 && is_between(c, d, a)) || (b_side == 0.0 && is_between(c, d, b));
}

template <class Corners>
const Corner& next(const Corners& corners, std::size_t i) {
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
    const Corner &a = corners[i], &b = next(corners, i), &after = next(corners, (i + 1) % n);
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
template <class Corners>
bool is_inside(const Corners& corners, const Corner& p) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner &a = corners[i], &b = next(corners, i);
    if ((a.z > p.z) == (b.z > p.z)) continue;
    if (p.y < a.y + static_cast<double>((p.z - a.z) / (b.z - a.z)) * (b.y - a.y)) inside = !inside;
  }
  return inside;
}

bool is_clear(const Input& in, std::size_t hole) {
  const auto& own = in.holes[hole].points;
  if (contours_meet(in.points, own) || !is_inside(in.points, own[0])) return false;
  for (std::size_t i = 0; i < hole; ++i) {
    const auto& other = in.holes[i].points;
    if (contours_meet(other, own) || is_inside(other, own[0]) || is_inside(own, other[0])) return false;
  }
  return true;
}

std::string path_of_hole(std::size_t i) { return "holes[" + std::to_string(i + 1) + "]"; }

FieldFault fault_of_sides(const std::string& path, const Sides& sides) {
  return {path,
          say("sides {1} and {2} of '{3}' touch or cross", std::to_string(sides.first + 1),
              std::to_string(sides.second + 1), path),
          say("side 1 goes from corner 1 to corner 2; give the corners in order around the contour")};
}

Outline outline_of(std::span<const Corner> corners) {
  Outline outline;
  for (const Corner& c : corners) outline.push_back({c.y, c.z});
  return outline;
}

}  // namespace

bool Polygon::has_corners(const Input& in) {
  return in.points.size() >= 3 &&
         std::all_of(in.holes.begin(), in.holes.end(), [](const Hole& hole) { return hole.points.size() >= 3; });
}

bool Polygon::is_simple(const Input& in) {
  if (!has_corners(in)) return true;  // another rule says it
  return !crossing_of(in.points).found && std::none_of(in.holes.begin(), in.holes.end(),
                                                       [](const Hole& hole) { return crossing_of(hole.points).found; });
}

FieldFault Polygon::crossing(const Input& in) {
  if (const Sides sides = crossing_of(in.points); sides.found) return fault_of_sides("points", sides);
  for (std::size_t i = 0; i < in.holes.size(); ++i) {
    if (const Sides sides = crossing_of(in.holes[i].points); sides.found) return fault_of_sides(path_of_hole(i), sides);
  }
  return {};
}

bool Polygon::holes_are_inside(const Input& in) {
  if (!has_corners(in)) return true;
  for (std::size_t i = 0; i < in.holes.size(); ++i) {
    if (!is_clear(in, i)) return false;
  }
  return true;
}

FieldFault Polygon::hole_outside(const Input& in) {
  for (std::size_t i = 0; i < in.holes.size(); ++i) {
    if (!is_clear(in, i)) return {path_of_hole(i), {}, say("a hole at the edge is part of the contour")};
  }
  return {};
}

template <class Tracer>
Polygon::Result Polygon::evaluate(const Input& in, Tracer& trace) {
  const Place origin{in.points[0].y, in.points[0].z};
  Moments sum;
  add(sum, polygon_moments(in.points, origin), 1.0);
  for (const Hole& hole : in.holes) add(sum, polygon_moments(hole.points, origin), -1.0);
  Result r = centroidal(sum, origin, trace);
  Extremes extremes;
  for (const Corner& c : in.points) extremes.push_back({c.y, c.z});
  complete(r, extremes, trace);
  return r;
}

std::vector<draw::Figure> Polygon::figures(const Input& in, const Result& r) {
  Sketch sketch{{outline_of({in.points.data(), in.points.size()})}, {}};
  for (const Hole& hole : in.holes) sketch.holes.push_back(outline_of({hole.points.data(), hole.points.size()}));
  return section::figures(sketch, r);
}

template Polygon::Result Polygon::evaluate(const Input&, NoTrace&);
template Polygon::Result Polygon::evaluate(const Input&, Trace&);

}  // namespace loadpath::section

template const loadpath::Calculator& loadpath::erased<loadpath::section::Polygon>();
