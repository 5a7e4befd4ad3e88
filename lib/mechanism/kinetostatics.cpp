#include "lib/mechanism/kinetostatics.hpp"

#include "lib/mechanism/point_motion.hpp"

namespace loadpath::mechanism {
namespace {

Vec at(std::span<const double> q, std::size_t link) { return {q[3 * link], q[3 * link + 1]}; }

}  // namespace

void required_forces(const Model& model, const Constraints& constraints, std::span<const double> velocity,
                     std::span<const double> acceleration, bool statics, std::span<double> required) {
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const Link& link = model.links[k];
    const Vec arm = constraints.turned(k)(link.centre);
    const double epsilon = statics ? 0.0 : acceleration[3 * k + 2];
    const Pose frame{acceleration[3 * k], acceleration[3 * k + 1], epsilon};
    const Vec a = statics ? Vec{} : point_acceleration(frame, velocity[3 * k + 2], arm);
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
               std::span<const double> multipliers, double length, std::span<Reaction> reactions,
               std::span<double> effort) {
  for (std::size_t k = 0; k < reactions.size(); ++k) {
    const Pair& pair = constraints.pairs()[k];
    const double first = multipliers[pair.row];
    Reaction& reaction = reactions[k];
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
  for (std::size_t k = 0; k < effort.size(); ++k) {
    const bool rotary = model.drivers[k].kind == Driver::Kind::rotary;
    effort[k] = (rotary ? length * length : length) * efforts[k];
  }
}

}  // namespace loadpath::mechanism
