// Load of a rotating link on the shaft of its fixed joint, an input record of a shaft: load = "=press.shafts.O". It
// includes all loads of the link, with weight and inertia; torque passes where a drive turns the link.
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>
#include <cmath>

namespace loadpath::planar {

namespace {

using mechanism::ground;
using mechanism::Position;

struct Turning {
  std::string name;  // name of its joint with the frame
  std::size_t joint = 0, link = 0;
  double sign = 1.0;                                   // sign of the joint's reaction as link on frame
  std::vector<std::pair<std::size_t, double>> drives;  // that turn it, and the sign of their effort

  /// Sum of all drives, positive in the direction of rotation of the link.
  [[nodiscard]] double torque(const Position& p) const {
    double M = 0.0;
    for (const auto& [index, way] : drives) M += way * p.effort[index];
    return std::copysign(1.0, p.velocity[link].phi) * M;
  }
};

constexpr const char* turning = "revolute joints with the ground";

constexpr std::array turning_rows{
    row<Turning>(
        "shafts.NAME.F_x", "force of the link on its shaft along x, in space", N, {.is_load = true, .with = "F_y, T"},
        [](const Turning& t, const Position& p) { return t.sign * p.reactions[t.joint].force.x; }, nullptr, turning),
    row<Turning>(
        "shafts.NAME.F_y", "force of the link on its shaft along y", N, {.is_load = true, .with = "F_x, T"},
        [](const Turning& t, const Position& p) { return t.sign * p.reactions[t.joint].force.y; }, nullptr, turning),
    row<Turning>(
        "shafts.NAME.T", "torque on the link from its shaft; negative: torque returned", N_m,
        {.is_load = true, .with = "F_x, F_y"}, [](const Turning& t, const Position& p) { return t.torque(p); }, nullptr,
        turning),
    row<Turning>(
        "shafts.NAME.psi", "angle of the shaft, counter-clockwise", deg,
        [](const Turning& t, const Position& p) { return p.pose[t.link].phi; }, nullptr, turning)};

constexpr Declaration speed = declare("shafts.NAME.n", "speed of the shaft, counter-clockwise positive", rpm,
                                      "revolute joints of driven links with the ground, at constant speed");

void list_shafts(std::vector<ResultPattern>& patterns) {
  list_patterns(turning_rows, patterns);
  patterns.push_back(speed.pattern);
}

/// Where it is the same at all positions.
Output::Values speed_of(const Solved& solved, std::size_t link) {
  constexpr double even = 1e-9;
  const auto& positions = solved.cycle.positions;
  const double first = positions.empty() ? 0.0 : positions.front().velocity[link].phi;
  for (const Position& p : positions) {
    if (!(std::abs(p.velocity[link].phi - first) <= even * std::abs(first)))
      return {{}, say("its speed varies over the turn")};
  }
  if (first == 0.0) return {{}, say("the mechanism rests")};
  return {{first}};
}

void add_shafts(const Mechanism::Input&, const mechanism::Model& model, std::vector<Output>& out) {
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const mechanism::Joint& joint = model.joints[k];
    const bool first = joint.j == ground;
    if (joint.kind != mechanism::JointKind::revolute || (joint.i == ground) == first) continue;
    const int link = first ? joint.i : joint.j;
    Turning own{joint.name, k, static_cast<std::size_t>(link), first ? -1.0 : 1.0, {}};
    for (std::size_t d = 0; d < model.drivers.size(); ++d) {
      const mechanism::Driver& driver = model.drivers[d];
      if (driver.kind != mechanism::Driver::Kind::rotary || (driver.i != link && driver.j != link)) continue;
      own.drives.emplace_back(d, driver.i == link ? 1.0 : -1.0);
    }
    add_outputs(own, turning_rows, out);
    if (own.drives.empty()) continue;
    Output n = output(speed, joint.name);
    n.is_single = true;
    n.read_cycle = [link](const Solved& solved) { return speed_of(solved, static_cast<std::size_t>(link)); };
    out.push_back(std::move(n));
  }
}

}  // namespace

constinit const Aspect aspects::shafts{.list = &list_shafts, .add_outputs = &add_shafts};

}  // namespace loadpath::planar
