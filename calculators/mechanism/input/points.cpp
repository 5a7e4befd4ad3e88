#include "calculators/mechanism/input/points.hpp"

#include "calculators/mechanism/input/names.hpp"
#include "lib/mechanism/model/model.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

using mechanism::Vec;

std::pair<Name, Name> point_names(const planar::Joint& joint) {
  const Name first = joint.points.first.empty() ? joint.name : joint.points.first;
  return {first, joint.points.second.empty() ? first : joint.points.second};
}

bool is_drawn(const planar::Link& link) { return !is_set(link.angle) && !is_set(link.origin.x); }

Vec vector_of(const planar::Point& p) {
  if (is_set(p.x)) return {in_si(p.x), in_si(p.y)};
  return in_si(p.r) * Vec{std::cos(p.angle), std::sin(p.angle)};
}

std::vector<Name> joint_points(const Mechanism::Input& in, const Name& link) {
  std::vector<Name> points;
  const auto add = [&](const Name& point) {
    if (std::find(points.begin(), points.end(), point) == points.end()) points.push_back(point);
  };
  for (const planar::Joint& joint : in.joints) {
    if (joint.links.first != link && joint.links.second != link) continue;
    const auto [first, second] = point_names(joint);
    const Name& own = joint.links.first == link ? first : second;
    add(own);
  }
  for (const Cylinder& c : in.cylinders) {  // between two points: they end in pins
    if (c.links.first == link) add(c.points.first);
    if (c.links.second == link) add(c.points.second);
  }
  return points;
}

std::vector<TracedPoint> traced_points(const Mechanism::Input& in) {
  std::vector<TracedPoint> points;
  for (std::size_t i = 0; i < in.links.size(); ++i) {
    for (const auto& p : in.links[i].points) {
      const bool known =
          std::any_of(points.begin(), points.end(), [&](const auto& t) { return t.name == p.name.view(); });
      if (!known) points.push_back({std::string(p.name.view()), static_cast<int>(i), vector_of(p)});
    }
  }
  return points;
}

}  // namespace loadpath::planar
