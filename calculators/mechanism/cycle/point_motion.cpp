#include "calculators/mechanism/cycle/point_motion.hpp"

#include "lib/mechanism/model/model.hpp"

namespace loadpath::planar {

using mechanism::Vec;

PointMotion motion_of(const mechanism::Position& p, int link, Vec at) {
  if (link == mechanism::ground) return {at, {}, {}};
  const auto k = static_cast<std::size_t>(link);
  const Vec arm = mechanism::turn(p.pose[k].phi)(at);
  const double omega = p.velocity[k].phi, epsilon = p.acceleration[k].phi;
  const Vec across = mechanism::normal(arm);
  return {Vec{p.pose[k].x, p.pose[k].y} + arm, Vec{p.velocity[k].x, p.velocity[k].y} + omega * across,
          Vec{p.acceleration[k].x, p.acceleration[k].y} + epsilon * across - (omega * omega) * arm};
}

double angle_of(const mechanism::Position& p, int link) {
  return link == mechanism::ground ? 0.0 : p.pose[static_cast<std::size_t>(link)].phi;
}

}  // namespace loadpath::planar
