#include "calculators/mechanism/cycle/kinematics.hpp"

#include "lib/mechanism/groups/closing.hpp"
#include "lib/mechanism/studies/position_functions.hpp"

namespace loadpath::planar {

using mechanism::Position;

static std::vector<std::size_t> iterated_groups(const mechanism::Plan& plan) {
  std::vector<std::size_t> groups;
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    if (plan.groups[g].closing == mechanism::Closing::by_newton) groups.push_back(g);
  }
  return groups;
}

/// Only the motion of a position: of thousands of large mechanisms the forces would be kept twice.
static Position motion_alone(const Position& at) {
  Position motion;
  motion.pose = at.pose;
  motion.velocity = at.velocity;
  motion.acceleration = at.acceleration;
  return motion;
}

Kinematics kinematics_of(const mechanism::Model& model, const Cycle& cycle, const Axis* axis, bool goes_by_drive) {
  Kinematics kinematics;
  if (model.drivers.size() != 1) return kinematics;
  mechanism::PositionFunctions functions(model);
  kinematics.derivatives.reserve(cycle.positions.size());
  for (const Position& position : cycle.positions) kinematics.derivatives.push_back(motion_alone(position));
  const auto iterated = iterated_groups(functions.plan());
  for (const std::size_t g : iterated)
    kinematics.iterated.push_back({first_link(functions.plan(), functions.plan().groups[g]), {}});
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    const mechanism::Drive& drive = cycle.drives[k][0];
    const bool uniform = drive.speed != 0.0 && drive.acceleration == 0.0 && iterated.empty();
    Position& derivative = kinematics.derivatives[k];
    if (uniform && cycle.closed[k]) divide_by_speed(derivative, drive.speed);
    kinematics.known.push_back(cycle.closed[k] && (uniform || functions.derive(derivative)));
    for (std::size_t n = 0; n < iterated.size(); ++n)
      kinematics.iterated[n].signs.push_back(kinematics.known[k] ? functions.sign(iterated[n]) : 0.0);
  }
  if (axis != nullptr && goes_by_drive)
    kinematics.strokes = strokes(model, {axis->at.values(), axis->period, kinematics.derivatives, kinematics.known});
  return kinematics;
}

}  // namespace loadpath::planar
