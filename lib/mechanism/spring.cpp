#include "lib/mechanism/spring.hpp"

#include "lib/mechanism/frames.hpp"

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
  return spring_now(spring, placed_at(at, spring.i), placed_at(at, spring.j), speeds_at(at, spring.i),
                    speeds_at(at, spring.j));
}

}  // namespace loadpath::mechanism
