#include "lib/mechanism/studies/instant_centres.hpp"

#include "lib/mechanism/model/point_motion.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::mechanism {
namespace {

// Relative to the mechanism's size.
constexpr double farthest = 1e9;

Pose velocity_of(const Position& at, int link) {
  return link == ground ? Pose{} : at.velocity[static_cast<std::size_t>(link)];
}

Vec origin_of(const Position& at, int link) {
  if (link == ground) return {};
  const Pose& pose = at.pose[static_cast<std::size_t>(link)];
  return {pose.x, pose.y};
}

double fastest(const Position& at, double size) {
  double most = 0.0;
  for (const Pose& v : at.velocity) most = std::max({most, std::hypot(v.x, v.y), size * std::abs(v.phi)});
  return most;
}

}  // namespace

InstantCentre instant_centre(const Position& at, int i, int j, double size) {
  const int of = i == ground ? j : i;  // measured from a link that has a frame
  const Vec from = origin_of(at, of);
  const Pose vi = velocity_of(at, i), vj = velocity_of(at, j);
  const Vec v = point_velocity(vi, from - origin_of(at, i)) - point_velocity(vj, from - origin_of(at, j));
  const double speed = length(v), omega = vi.phi - vj.phi, still = 1e-12 * fastest(at, size);
  if (size * std::abs(omega) <= still && speed <= still) return {};
  if (farthest * size * std::abs(omega) > speed && size * std::abs(omega) > still) {
    return {InstantCentre::Kind::point, from + (1.0 / omega) * normal(v), {}};
  }
  return {InstantCentre::Kind::at_infinity, {}, (1.0 / speed) * normal(v)};
}

std::vector<CentreOfPair> instant_centres(const Position& at, double size) {
  std::vector<CentreOfPair> centres;
  const int links = static_cast<int>(at.velocity.size());
  for (int i = 0; i < links; ++i) {
    for (int j = i + 1; j < links; ++j) centres.push_back({i, j, instant_centre(at, i, j, size)});
    centres.push_back({i, ground, instant_centre(at, i, ground, size)});
  }
  return centres;
}

}  // namespace loadpath::mechanism
