#include "calculators/section/polygon.hpp"

#include "calculators/section/contour_sides.hpp"
#include "calculators/section/polygon_moments.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <string>

namespace loadpath::section {

namespace {

using Corner = Polygon::Corner;
using Input = Polygon::Input;

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
  r.section = record_of(r);
  return r;
}

std::vector<figure::Figure> Polygon::figures(const Input& in, const Result& r) {
  Sketch sketch{{outline_of({in.points.data(), in.points.size()})}, {}};
  for (const Hole& hole : in.holes) sketch.holes.push_back(outline_of({hole.points.data(), hole.points.size()}));
  return section::figures(sketch, r);
}

template Polygon::Result Polygon::evaluate(const Input&, NoTrace&);
template Polygon::Result Polygon::evaluate(const Input&, Trace&);

}  // namespace loadpath::section

template const loadpath::Calculator& loadpath::erased<loadpath::section::Polygon>();
