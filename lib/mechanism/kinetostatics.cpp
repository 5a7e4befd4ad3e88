#include "lib/mechanism/kinetostatics.hpp"

namespace loadpath::mechanism {
namespace {

Vec at(std::span<const double> q, std::size_t link) { return {q[3 * link], q[3 * link + 1]}; }

Vec global_force(const Load& load, const Turn& turned) {
  return load.turns_with_link ? turned(load.force) : load.force;
}

Vec point_acceleration(Vec origin, double epsilon, double omega, Vec arm) {
  return origin + epsilon * normal(arm) - omega * omega * arm;
}

}  // namespace

void required_forces(const Model& model, const Constraints& constraints, std::span<const double> velocity,
                     std::span<const double> acceleration, bool statics, std::span<double> required) {
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const Link& link = model.links[k];
    const Vec arm = constraints.turned(k)(link.centre);
    const double epsilon = statics ? 0.0 : acceleration[3 * k + 2];
    const Vec a = statics ? Vec{} : point_acceleration(at(acceleration, k), epsilon, velocity[3 * k + 2], arm);
    const Vec force = link.mass * (a - model.gravity);
    required[3 * k] = force.x;
    required[3 * k + 1] = force.y;
    required[3 * k + 2] = link.inertia * epsilon + cross(arm, force);
  }
  for (const auto& load : model.loads) {
    const auto k = static_cast<std::size_t>(load.link);
    const Vec force = global_force(load, constraints.turned(k));
    required[3 * k] -= force.x;
    required[3 * k + 1] -= force.y;
    required[3 * k + 2] -= load.moment + cross(constraints.turned(k)(load.point), force);
  }
}

void share_out(const Model& model, const Constraints& constraints, std::span<const double> q,
               std::span<const double> multipliers, double length, Position& out) {
  for (std::size_t k = 0; k < out.reactions.size(); ++k) {
    const Pair& pair = constraints.pairs()[k];
    const double first = multipliers[pair.row];
    Reaction& reaction = out.reactions[k];
    reaction.at = length * (at(q, pair.i) + pair.arm_i);
    reaction.couple = 0.0;
    if (pair.kind == JointKind::revolute) {
      reaction.force = length * Vec{first, multipliers[pair.row + 1]};
    } else {
      reaction.force = length * (first * normal(pair.along));
      if (pair.kind == JointKind::prismatic) reaction.couple = length * length * multipliers[pair.row + 1];
    }
  }
  const auto efforts = multipliers.subspan(constraints.first_driver_row());
  for (std::size_t k = 0; k < out.effort.size(); ++k) {
    const bool rotary = model.drivers[k].kind == Driver::Kind::rotary;
    out.effort[k] = (rotary ? length * length : length) * efforts[k];
  }
}

}  // namespace loadpath::mechanism
