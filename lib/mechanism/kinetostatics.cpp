#include "lib/mechanism/kinetostatics.hpp"

#include "lib/mechanism/spring.hpp"

namespace loadpath::mechanism {
namespace {

Vec at(std::span<const double> q, std::size_t link) { return {q[3 * link], q[3 * link + 1]}; }

void add_spring(const Spring& spring, const Constraints& constraints, std::span<const double> velocity,
                std::span<double> required) {
  const auto speeds = [&](int link) {
    const std::size_t k = constraints.index(link);
    return Speeds{at(velocity, k), velocity[3 * k + 2]};
  };
  const Placed &i = constraints.placed(spring.i), &j = constraints.placed(spring.j);
  const SpringNow now = spring_now(spring, i, j, speeds(spring.i), speeds(spring.j));
  const auto supply = [&](int link, const Placed& frame, Vec place, double sense) {
    if (link == ground) return;
    double* const of_link = &required[3 * constraints.index(link)];
    of_link[0] -= sense * now.force.x;
    of_link[1] -= sense * now.force.y;
    of_link[2] -= sense * (now.couple + cross(place - frame.origin, now.force));
  };
  supply(spring.i, i, now.at_i, 1.0);
  supply(spring.j, j, now.at_j, -1.0);
}

}  // namespace

void required_forces(const Model& model, const Constraints& constraints, std::span<const double> velocity,
                     std::span<const double> acceleration, bool statics, std::span<double> required) {
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const Acceleration a{at(acceleration, k), velocity[3 * k + 2], acceleration[3 * k + 2]};
    const Wrench needed =
        inertia_less_weight(model.links[k], constraints.turned(k), statics ? Acceleration{} : a, model.gravity);
    required[3 * k] = needed.force.x;
    required[3 * k + 1] = needed.force.y;
    required[3 * k + 2] = needed.moment;
  }
  for (const auto& load : model.loads) {
    const auto k = static_cast<std::size_t>(load.link);
    const Wrench acting = wrench_of(load, constraints.turned(k));
    required[3 * k] -= acting.force.x;
    required[3 * k + 1] -= acting.force.y;
    required[3 * k + 2] -= acting.moment;
  }
  for (const Spring& spring : model.springs) add_spring(spring, constraints, velocity, required);
}

void share_out(const Model& model, const Constraints& constraints, std::span<const double> multipliers, double length,
               std::span<Reaction> reactions, std::span<double> effort) {
  for (std::size_t k = 0; k < reactions.size(); ++k) {
    const Pair& pair = constraints.pairs()[k];
    Reaction& reaction = reactions[k];
    reaction = {};
    for (std::size_t r = 0; r < pair.shape.rows(); ++r) {
      const double multiplier = length * multipliers[pair.row + r];
      reaction.force = reaction.force + multiplier * pair.at.rows[r].e;
      reaction.couple += length * multiplier * pair.at.rows[r].m;
    }
    reaction.at = length * pair.at.at;
  }
  const auto efforts = multipliers.subspan(constraints.first_driver_row());
  for (std::size_t k = 0; k < effort.size(); ++k) {
    const bool rotary = model.drivers[k].kind == Driver::Kind::rotary;
    effort[k] = (rotary ? length * length : length) * efforts[k];
  }
}

}  // namespace loadpath::mechanism
