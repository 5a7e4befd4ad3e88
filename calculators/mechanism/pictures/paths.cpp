// The paths of points in a scheme.
#include "calculators/mechanism/cycle/point_motion.hpp"
#include "calculators/mechanism/pictures/scheme.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

/// Whether a point stays where it is, but for rounding.
static bool rests(const std::vector<figure::Point>& path) {
  double far = 0.0, size = 0.0;
  for (const auto& p : path) {
    far = std::max(far, std::hypot(p.x - path.front().x, p.y - path.front().y));
    size = std::max(size, std::hypot(p.x, p.y));
  }
  return far <= 1e-9 * size;
}

void add_paths(const std::vector<TracedPoint>& points, const Cycle& cycle, bool cyclic, figure::Scheme& scheme) {
  constexpr std::size_t positions = 12;
  const std::size_t spacing = std::max<std::size_t>(1, cycle.positions.size() / positions);
  const bool whole = cyclic && std::all_of(cycle.closed.begin(), cycle.closed.end(), [](bool c) { return c; });
  for (const TracedPoint& traced : points) {
    figure::Scheme::Path path{traced.name, {}, {}};
    for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
      if (!cycle.closed[k]) continue;
      const mechanism::Vec place = motion_of(cycle.positions[k], traced.link, traced.at).place;
      path.points.push_back({place.x, place.y});
      if (k % spacing == 0) path.positions.push_back(path.points.back());
    }
    if (path.points.size() < 3 || rests(path.points)) continue;
    if (whole) path.points.push_back(path.points.front());
    scheme.paths.push_back(std::move(path));
  }
}

}  // namespace loadpath::planar
