#include "lib/mechanism/spring.hpp"

#include <cmath>

namespace loadpath::mechanism {

SpringNow spring_now(const Spring& spring, const Placed& i, const Placed& j, const Speeds& speed_i,
                     const Speeds& speed_j) {
  SpringNow now{.at_i = i.point(spring.point_i), .at_j = j.point(spring.point_j), .force = {}};
  if (spring.kind == Spring::Kind::turning) {
    now.stretch = i.phi - j.phi - spring.free;
    now.effort = spring.rate * now.stretch + spring.damping * (speed_i.omega - speed_j.omega);
    now.couple = -now.effort;
    return now;
  }
  const Vec apart = now.at_i - now.at_j;
  const double span = std::sqrt(dot(apart, apart));
  now.stretch = span - spring.free;
  if (span == 0.0) return now;
  const Vec along = (1.0 / span) * apart;
  const Vec speed = speed_i.origin + speed_i.omega * normal(now.at_i - i.origin) - speed_j.origin -
                    speed_j.omega * normal(now.at_j - j.origin);
  now.effort = spring.rate * now.stretch + spring.damping * dot(along, speed);
  now.force = -now.effort * along;
  return now;
}

SpringNow spring_now(const Spring& spring, const Position& at) {
  const auto placed = [&](int link) {
    if (link == ground) return Placed{};
    const Pose& pose = at.pose[static_cast<std::size_t>(link)];
    return Placed{turn(pose.phi), {pose.x, pose.y}, pose.phi};
  };
  const auto speeds = [&](int link) {
    if (link == ground) return Speeds{};
    const Pose& v = at.velocity[static_cast<std::size_t>(link)];
    return Speeds{{v.x, v.y}, v.phi};
  };
  return spring_now(spring, placed(spring.i), placed(spring.j), speeds(spring.i), speeds(spring.j));
}

}  // namespace loadpath::mechanism
