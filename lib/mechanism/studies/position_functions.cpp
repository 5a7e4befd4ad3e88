#include "lib/mechanism/studies/position_functions.hpp"

#include "lib/mechanism/equations/kinematics.hpp"
#include "lib/mechanism/studies/relative_motion.hpp"

namespace loadpath::mechanism {

PositionFunctions::PositionFunctions(const Model& model)
    : model_(model),
      plan_(plan_of(model)),
      positions_(plan_, characteristic_length(model)),
      motion_(model_, plan_, positions_),
      drives_(model.drivers.size()) {}

bool PositionFunctions::derive(Position& at, std::size_t driver) {
  positions_.adopt(at.pose);
  if (!positions_.factor()) return false;
  for (std::size_t d = 0; d < drives_.size(); ++d) drives_[d].speed = d == driver ? 1.0 : 0.0;
  motion_.find_velocities(drives_);
  motion_.find_accelerations(drives_);
  for (std::size_t k = 0; k < at.pose.size(); ++k) {
    const Moving& m = motion_.link(k);
    at.velocity[k] = {m.velocity.x, m.velocity.y, m.omega};
    at.acceleration[k] = {m.acceleration.x, m.acceleration.y, m.epsilon};
  }
  return true;
}

void divide_by_speed(Position& at, double speed) {
  const auto divide = [](std::vector<Pose>& poses, double by) {
    for (Pose& p : poses) p = {p.x / by, p.y / by, p.phi / by};
  };
  divide(at.velocity, speed);
  divide(at.acceleration, speed * speed);
}

double drive_coordinate(const Model& model, std::size_t driver, const Position& at) {
  const Driver& d = model.drivers[driver];
  if (d.kind == Driver::Kind::linear) {
    return relative_motion(model.joints[static_cast<std::size_t>(d.joint)], at).s + d.offset;
  }
  const auto angle = [&](int link) { return link == ground ? 0.0 : at.pose[static_cast<std::size_t>(link)].phi; };
  return angle(d.i) - angle(d.j) + d.offset;
}

}  // namespace loadpath::mechanism
