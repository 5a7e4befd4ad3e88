// Pin joints as loads of their pins and lugs: relative rotation, diameter, whether their force reverses on the pin,
// and its component transverse to the links.
#include "calculators/mechanism/cycle/point_motion.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "lib/mechanism/model/vec.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace loadpath::planar {

namespace {

using mechanism::Position;
using mechanism::Vec;

struct Pin {
  std::string name;
  int i, j;
};

double turning_of(int link, const Position& p) {
  return link == mechanism::ground ? 0.0 : p.velocity[static_cast<std::size_t>(link)].phi;
}

constexpr std::array pin_rows{row<Pin>(
    "joints.NAME.omega", "angular velocity of the first link relative to the second", rad_per_s, {.detail = true},
    [](const Pin& pin, const Position& p) { return turning_of(pin.i, p) - turning_of(pin.j, p); }, nullptr,
    "revolute joints")};

constexpr Declaration reversal = declare(
    "joints.NAME.reversal",
    "minimum over maximum of the force along the direction of its maximum, on the link on which it reverses less",
    ratio, "revolute joints", {.detail = true});
constexpr Declaration diameter =
    declare("joints.NAME.d_pin", "diameter of the pin", mm, "revolute joints with pin_radius", {.detail = true});

/// A point of a pin that is fixed in this link is loaded alternately if the force reverses in the axes of the link.
double reversal_on(int link, std::size_t joint, const Solved& solved) {
  std::vector<Vec> forces;
  for (std::size_t k = 0; k < solved.cycle.positions.size(); ++k) {
    if (!solved.cycle.has_forces(k)) continue;
    const Position& p = solved.cycle.positions[k];
    const Vec force = p.reactions[joint].force;
    const double c = std::cos(angle_of(p, link)), s = std::sin(angle_of(p, link));
    forces.push_back({c * force.x + s * force.y, c * force.y - s * force.x});
  }
  const auto is_less = [](const Vec& a, const Vec& b) { return mechanism::length(a) < mechanism::length(b); };
  const auto most = std::max_element(forces.begin(), forces.end(), is_less);
  if (most == forces.end() || !(mechanism::length(*most) > 0.0)) return none;
  double least = 1.0;
  for (const Vec& force : forces) least = std::min(least, mechanism::dot(force, *most) / mechanism::dot(*most, *most));
  return least;
}

constexpr const char* bars = "revolute joints of a link that has revolute joints only, in two places";
constexpr std::array transverse{
    declare("joints.NAME.F_t1", "maximum component of the force transverse to the first link", N, bars,
            {.detail = true}),
    declare("joints.NAME.F_t2", "maximum component of the force transverse to the second link", N, bars,
            {.detail = true})};

/// Whether a link has other pins than this one, and no joints of other kinds.
bool is_bar(int link, std::size_t joint, const mechanism::Model& model) {
  bool has_other = false;
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const mechanism::Joint& one = model.joints[k];
    if (one.i != link && one.j != link) continue;
    if (one.kind != mechanism::JointKind::revolute) return false;
    has_other = has_other || k != joint;
  }
  return link != mechanism::ground && has_other;
}

/// From a pin of the link to the only other place that has pins, in its own axes; nothing if there is not one only.
std::optional<Vec> axis_of(int link, std::size_t joint, const mechanism::Model& model) {
  constexpr double same = 1e-9;  // metres
  const auto place = [link](const mechanism::Joint& one) { return one.i == link ? one.point_i : one.point_j; };
  std::optional<Vec> axis;
  for (const mechanism::Joint& one : model.joints) {
    if (one.i != link && one.j != link) continue;
    const Vec arm = place(one) - place(model.joints[joint]);
    if (mechanism::length(arm) <= same) continue;
    if (axis && mechanism::length(arm - *axis) > same) return std::nullopt;
    axis = arm;
  }
  return axis;
}

/// The lugs of a bar lie along the line between its pins.
double transverse_to(int link, const Vec& axis, std::size_t joint, const Solved& solved) {
  constexpr double rounding = 1e-9;  // of the force
  double most = none;
  for (std::size_t k = 0; k < solved.cycle.positions.size(); ++k) {
    if (!solved.cycle.has_forces(k)) continue;
    const Position& p = solved.cycle.positions[k];
    const Vec force = p.reactions[joint].force;
    const double c = std::cos(angle_of(p, link)), s = std::sin(angle_of(p, link));
    const Vec along{(c * axis.x - s * axis.y) / mechanism::length(axis),
                    (s * axis.x + c * axis.y) / mechanism::length(axis)};
    const double across = std::abs(along.x * force.y - along.y * force.x);
    most = std::fmax(most, across > rounding * mechanism::length(force) ? across : 0.0);
  }
  return most;
}

void add_single(const Declaration& what, const std::string& name, std::vector<Output>& out,
                std::function<Output::Values(const Solved&)> read) {
  out.push_back(output(what, name));
  out.back().is_single = true;
  out.back().read_cycle = std::move(read);
}

void add_pins(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out) {
  for (std::size_t n = 0; n < model.joints.size(); ++n) {
    const mechanism::Joint& joint = model.joints[n];
    if (joint.kind != mechanism::JointKind::revolute) continue;
    add_outputs(Pin{joint.name, joint.i, joint.j}, pin_rows, out);
    add_single(reversal, joint.name, out, [n, i = joint.i, j = joint.j](const Solved& solved) {
      return Output::Values({std::fmax(reversal_on(i, n, solved), reversal_on(j, n, solved))});
    });
    for (const int link : {joint.i, joint.j}) {
      if (!is_bar(link, n, model)) continue;
      const auto axis = axis_of(link, n, model);
      if (!axis) continue;
      add_single(transverse[link == joint.i ? 0 : 1], joint.name, out, [n, link, along = *axis](const Solved& solved) {
        return Output::Values({transverse_to(link, along, n, solved)});
      });
    }
    const auto given = std::find_if(in.joints.begin(), in.joints.end(),
                                    [&](const planar::Joint& one) { return one.name.view() == joint.name; });
    if (given == in.joints.end() || !is_set(given->pin_radius)) continue;
    add_single(diameter, joint.name, out,
               [d = 2.0 * in_si(given->pin_radius)](const Solved&) { return Output::Values({d}); });
  }
}

void list_pins(std::vector<ResultPattern>& patterns) {
  list_patterns(pin_rows, patterns);
  patterns.push_back(reversal.pattern);
  for (const Declaration& one : transverse) patterns.push_back(one.pattern);
  patterns.push_back(diameter.pattern);
}

}  // namespace

constinit const Aspect aspects::pins{.list = &list_pins, .add_outputs = &add_pins};

}  // namespace loadpath::planar
