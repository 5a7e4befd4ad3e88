// The section of a vessel through its axis, to scale, with an enlarged piece of its wall: as ordered, what corrosion
// and mill take, what carries.
#pragma once

#include "calculators/vessel/wall.hpp"
#include "lib/figure/drawing.hpp"

#include <optional>
#include <vector>

namespace loadpath::vessel {

/// Data of a section figure in addition to its wall.
struct Section {
  std::vector<figure::Point> middle;  // m, middle of the carrying wall, right of the axis, along the meridian
  figure::Point within;               // a place inside, right of the axis or on it
  bool ring = false;                  // the meridian is closed: a tube, which the axis does not meet
  bool broken_start = false, broken_end = false;  // where the vessel continues
  std::optional<double> surface = {};             // height of the liquid
  std::optional<figure::Point> governing = {};    // on the middle
  std::string radius = "R";                       // radius to the surface given by `measured`
  figure::Drawing::View dimensioned = {};         // dimensions of the shape, supports: what the view has besides
};

/// How far the inside of the wall as ordered lies outside of the surface that the given radii belong to: not positive.
double inside_of(const WallInput& in, double delta);

figure::Figure section_figure(const WallInput& in, const WallResult& r, const Section& section);

/// `count` + 1 places along a meridian, its ends too.
template <class Shape>
std::vector<figure::Point> meridian_of(const Shape& shape, int count) {
  NoTrace off;
  std::vector<figure::Point> points;
  for (int i = 0; i <= count; ++i) {
    const auto place = shape.at(static_cast<double>(i) / count, off);
    points.push_back({in_si(place.r), in_si(place.z)});
  }
  return points;
}

}  // namespace loadpath::vessel
