#include "lib/mechanism/proof/active_forces.hpp"

#include "lib/mechanism/model/point_motion.hpp"
#include "lib/mechanism/model/spring.hpp"

namespace loadpath::mechanism {
namespace {

using Kind = ActiveForce::Kind;

ActiveForce weight(const Model& model, std::size_t k, Vec arm) {
  return {Kind::weight, k, k, arm, model.links[k].mass * model.gravity};
}

ActiveForce inertia(const Link& link, const Position& at, std::size_t k, Vec arm) {
  const Vec a = point_acceleration(at.acceleration[k], at.velocity[k].phi, arm);
  return {Kind::inertia, k, k, arm, -link.mass * a, -link.inertia * at.acceleration[k].phi};
}

}  // namespace

void find_active_forces(const Model& model, const Position& at, bool statics, std::vector<ActiveForce>& active) {
  active.clear();
  const bool weighs = length(model.gravity) != 0.0;
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const Link& link = model.links[k];
    const Vec arm = turn(at.pose[k].phi)(link.centre);
    if (weighs && link.mass != 0.0) active.push_back(weight(model, k, arm));
    if (!statics && (link.mass != 0.0 || link.inertia != 0.0)) active.push_back(inertia(link, at, k, arm));
  }
  for (std::size_t n = 0; n < model.loads.size(); ++n) {
    const Load& load = model.loads[n];
    const auto k = static_cast<std::size_t>(load.link);
    const Turn turned = turn(at.pose[k].phi);
    const LoadNow& now = at.loads[n];
    active.push_back({Kind::load, n, k, turned(load.point), global_force(load, now.force, turned), now.moment});
  }
  for (std::size_t n = 0; n < model.springs.size(); ++n) {
    const Spring& spring = model.springs[n];
    const SpringNow now = spring_now(spring, at);
    const auto pull = [&](int link, Vec place, double sense) {
      if (link == ground) return;
      const auto k = static_cast<std::size_t>(link);
      const Vec arm = place - Vec{at.pose[k].x, at.pose[k].y};
      active.push_back({Kind::spring, n, k, arm, sense * now.force, sense * now.couple});
    };
    pull(spring.i, now.at_i, 1.0);
    pull(spring.j, now.at_j, -1.0);
  }
}

void add_up(std::span<const ActiveForce> active, double length, std::span<double> acting) {
  for (const ActiveForce& a : active) {
    double* const on_link = &acting[3 * a.link];
    on_link[0] += a.force.x;
    on_link[1] += a.force.y;
    on_link[2] += (cross(a.arm, a.force) + a.couple) / length;
  }
}

double power(const ActiveForce& active, const Pose& velocity) {
  return dot(active.force, point_velocity(velocity, active.arm)) + active.couple * velocity.phi;
}

}  // namespace loadpath::mechanism
