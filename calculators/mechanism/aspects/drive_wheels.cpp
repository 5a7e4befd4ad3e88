// The wheels on the shaft of the crank, for steps that design them by the driving torque.
#include "calculators/mechanism/results/aspect.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace loadpath::planar {

namespace {

using mechanism::JointKind;

constexpr Declaration pinion = declare("drive.d_w1", "pitch diameter of the gear on the driven link", mm,
                                       "one pair of gears on the driven link", {.detail = true});
constexpr Declaration wheel =
    declare("drive.d_w2", "pitch diameter of its mate", mm, "one pair of gears on the driven link", {.detail = true});
constexpr Declaration pulley = declare("drive.d_1", "diameter of the belt pulley or sprocket on the driven link", mm,
                                       "one belt or chain on the driven link", {.detail = true});
constexpr Declaration other_pulley = declare("drive.d_2", "diameter of the other pulley or sprocket", mm,
                                             "one belt or chain on the driven link", {.detail = true});

/// Diameters of the wheels of a joint, that on the link first.
struct Wheels {
  double own, mate;
};

/// The wheels of the only joint of this kind on the link; none if there are several.
std::vector<Wheels> wheels_on(int link, JointKind kind, const mechanism::Model& model) {
  std::vector<Wheels> all;
  for (const mechanism::Joint& joint : model.joints) {
    if (joint.kind != kind || (joint.i != link && joint.j != link)) continue;
    const double first = 2.0 * std::abs(joint.radius_i), second = 2.0 * std::abs(joint.radius_j);
    all.push_back(joint.i == link ? Wheels{first, second} : Wheels{second, first});
  }
  if (all.size() > 1) all.clear();
  return all;
}

void add_single(const Declaration& what, double value, std::vector<Output>& out) {
  out.push_back(output(what, ""));
  out.back().is_single = true;
  out.back().read_cycle = [value](const Solved&) { return Output::Values({value}); };
}

void add_drive_wheels(const Mechanism::Input&, const mechanism::Model& model, std::vector<Output>& out) {
  for (const mechanism::Driver& driver : model.drivers) {
    if (driver.kind != mechanism::Driver::Kind::rotary) continue;
    const int link = driver.i == mechanism::ground ? driver.j : driver.i;
    for (const Wheels& gears : wheels_on(link, JointKind::gear, model))
      add_single(pinion, gears.own, out), add_single(wheel, gears.mate, out);
    for (const Wheels& pulleys : wheels_on(link, JointKind::belt, model))
      add_single(pulley, pulleys.own, out), add_single(other_pulley, pulleys.mate, out);
  }
}

void list_drive_wheels(std::vector<ResultPattern>& patterns) {
  for (const Declaration* what : {&pinion, &wheel, &pulley, &other_pulley}) patterns.push_back(what->pattern);
}

}  // namespace

constinit const Aspect aspects::drive_wheels{.list = &list_drive_wheels, .add_outputs = &add_drive_wheels};

}  // namespace loadpath::planar
