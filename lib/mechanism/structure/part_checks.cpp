#include "lib/mechanism/structure/structure.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <utility>

namespace loadpath::mechanism {
namespace {

using About = Finding::About;

bool finite(std::initializer_list<double> values) {
  return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
}

bool same_pair(const Driver& a, const Driver& b) { return (a.i == b.i && a.j == b.j) || (a.i == b.j && a.j == b.i); }

/// A rotor: it is only driven, and carries nothing else.
bool turns_about_fixed_pin(const Model& model, int link) {
  return std::ranges::any_of(model.joints, [link](const Joint& joint) {
    const bool own = (joint.i == link && joint.j == ground) || (joint.j == link && joint.i == ground);
    return own && joint.kind == JointKind::revolute;
  });
}

class PartChecks {
 public:
  explicit PartChecks(const Model& model) : model_(model) {}

  std::vector<Finding> run() {
    if (model_.links.empty()) add(About::model, 0, say("the mechanism has no links"), say("add a link"));
    for (std::size_t k = 0; k < model_.links.size(); ++k) check(k, model_.links[k]);
    for (std::size_t k = 0; k < model_.joints.size(); ++k) check(k, model_.joints[k]);
    for (std::size_t k = 0; k < model_.drivers.size(); ++k) check(k, model_.drivers[k]);
    for (std::size_t k = 0; k < model_.loads.size(); ++k) check(k, model_.loads[k]);
    for (std::size_t k = 0; k < model_.springs.size(); ++k) check(k, model_.springs[k]);
    if (!finite({model_.gravity.x, model_.gravity.y})) add(About::model, 0, say("the gravity is not a finite number"));
    if (findings_.empty()) check_connected();
    return std::move(findings_);
  }

 private:
  void check(std::size_t k, const Link& link);
  void check(std::size_t k, const Joint& joint);
  void check(std::size_t k, const Driver& driver);
  void check_wheels(std::size_t k, const Joint& joint);
  void check_cam(std::size_t k, const Joint& joint);
  void check(std::size_t k, const Load& load);
  void check(std::size_t k, const Spring& spring);
  void check_ends(std::size_t k, const Spring& spring);
  void check_rotary(std::size_t k, const Driver& driver);
  void check_linear(std::size_t k, const Driver& driver);
  void check_driven_once(std::size_t k, const Driver& driver);
  void check_connected();

  void add(About about, std::size_t index, Message message, Message hint = {}) {
    findings_.push_back({about, index, std::move(message), std::move(hint)});
  }
  [[nodiscard]] bool exists(int link) const {
    return link == ground || (link >= 0 && static_cast<std::size_t>(link) < model_.links.size());
  }

  const Model& model_;
  std::vector<Finding> findings_;
};

void PartChecks::check(std::size_t k, const Link& link) {
  if (!finite({link.centre.x, link.centre.y, link.pose.x, link.pose.y, link.pose.phi})) {
    add(About::link, k, say("link '{1}': its mass centre or its pose is not a finite number", link.name));
  }
  if (!(std::isfinite(link.mass) && link.mass >= 0.0)) {
    add(About::link, k,
        say("link '{1}': mass {2}: must be finite and not negative", link.name, format_quantity(link.mass, "kg")));
  }
  if (!(std::isfinite(link.inertia) && link.inertia >= 0.0)) {
    add(About::link, k,
        say("link '{1}': moment of inertia {2}: must be finite and not negative", link.name,
            format_quantity(link.inertia, "kg*m^2")));
  } else if (link.mass == 0.0 && link.inertia > 0.0 && !turns_about_fixed_pin(model_, static_cast<int>(k))) {
    add(About::link, k, say("link '{1}' is not on a fixed pin and has a moment of inertia, but no mass", link.name),
        say("give its mass too; a rotor on a pin of the frame needs only J, with its mass centre on that pin"));
  }
  const auto at_link = [&](const Joint& joint) {
    return joint.i == static_cast<int>(k) || joint.j == static_cast<int>(k);
  };
  if (std::ranges::none_of(model_.joints, at_link)) {
    add(About::link, k, say("link '{1}' has no joint", link.name), say("connect it by a joint, or remove it"));
  }
}

void PartChecks::check(std::size_t k, const Joint& joint) {
  if (!exists(joint.i) || !exists(joint.j)) {
    add(About::joint, k, say("joint '{1}' is at a link that does not exist", joint.name));
  } else if (joint.i == joint.j) {
    add(About::joint, k, say("joint '{1}' connects '{2}' with itself", joint.name, link_name(model_, joint.i)),
        say("a joint is between two links, or between a link and the ground"));
  }
  if (!finite({joint.point_i.x, joint.point_i.y, joint.point_j.x, joint.point_j.y, joint.direction, joint.angle})) {
    add(About::joint, k, say("joint '{1}': a point or an angle of it is not a finite number", joint.name));
  }
  check_wheels(k, joint);
  check_cam(k, joint);
  const Friction& f = joint.friction;
  if (!finite({f.coefficient, f.pin_radius, f.rolling_arm, f.viscous, f.loss, f.loss_back, joint.guide_length,
               joint.guide_width}) ||
      std::min({f.coefficient, f.pin_radius, f.rolling_arm, f.viscous, f.loss, f.loss_back, joint.guide_length,
                joint.guide_width}) < 0.0) {
    add(About::joint, k,
        say("joint '{1}': its friction and the sizes for it must be finite and not negative", joint.name));
  }
  if (f.rise == 0.0) return;
  if (!finite({f.rise, f.stribeck_speed, f.stribeck_exponent}) || f.rise < 0.0 || !(f.stribeck_speed > 0.0) ||
      !(f.stribeck_exponent > 0.0)) {
    add(About::joint, k,
        say("joint '{1}': the speed and exponent of its mixed friction must be finite and positive", joint.name));
  }
}

void PartChecks::check_wheels(std::size_t k, const Joint& joint) {
  const bool on_line = joint.kind == JointKind::rack || joint.kind == JointKind::rolling_on_line;
  const bool two = joint.kind == JointKind::gear || joint.kind == JointKind::belt || joint.kind == JointKind::rolling;
  if (!on_line && !two) return;
  if (!finite({joint.radius_i, joint.radius_j, joint.pressure_angle, joint.tension, joint.phase})) {
    add(About::joint, k, say("joint '{1}': a number of its wheels is not finite", joint.name));
  } else if (joint.radius_i == 0.0 || (two && joint.radius_j == 0.0)) {
    add(About::joint, k, say("joint '{1}' has a wheel without a radius", joint.name));
  } else if (joint.kind != JointKind::belt && two && joint.radius_i + joint.radius_j == 0.0) {
    add(About::joint, k, say("joint '{1}': a wheel fills its ring, and cannot roll in it", joint.name),
        say("make the wheel smaller than the ring"));
  }
}

void PartChecks::check_cam(std::size_t k, const Joint& joint) {
  if (joint.kind != JointKind::cam) return;
  if (joint.profile == nullptr) {
    add(About::joint, k, say("joint '{1}' is a cam without a profile", joint.name), say("give it a profile"));
  } else if (!(std::isfinite(joint.radius_i) && joint.radius_i >= 0.0)) {
    add(About::joint, k, say("joint '{1}': the radius of its roller must be finite and not negative", joint.name));
  }
}

void PartChecks::check(std::size_t k, const Driver& driver) {
  if (!std::isfinite(driver.offset))
    add(About::driver, k, say("driver '{1}': its offset is not a finite number", driver.name));
  if (driver.kind == Driver::Kind::rotary) check_rotary(k, driver);
  if (driver.kind == Driver::Kind::linear) check_linear(k, driver);
}

void PartChecks::check_rotary(std::size_t k, const Driver& driver) {
  if (!exists(driver.i) || !exists(driver.j)) {
    add(About::driver, k, say("driver '{1}' is at a link that does not exist", driver.name));
    return;
  }
  if (driver.i == driver.j) {
    add(About::driver, k, say("driver '{1}' turns '{2}' against itself", driver.name, link_name(model_, driver.i)));
    return;
  }
  for (const auto& joint : model_.joints) {
    const Driver across{.name = {}, .i = joint.i, .j = joint.j};
    if (joint.kind != JointKind::prismatic || !same_pair(driver, across)) continue;
    add(About::driver, k,
        say("driver '{1}' turns '{2}' against '{3}', but the prismatic joint '{4}' holds that angle", driver.name,
            link_name(model_, driver.i), link_name(model_, driver.j), joint.name),
        say("a prismatic joint takes a linear driver"));
  }
  check_driven_once(k, driver);
}

void PartChecks::check_linear(std::size_t k, const Driver& driver) {
  if (driver.joint < 0 || static_cast<std::size_t>(driver.joint) >= model_.joints.size()) {
    add(About::driver, k, say("driver '{1}' is linear and names no joint", driver.name),
        say("name the prismatic joint or the slot along which it pushes"));
    return;
  }
  const Joint& joint = model_.joints[static_cast<std::size_t>(driver.joint)];
  if (joint.kind == JointKind::revolute) {
    add(About::driver, k, say("driver '{1}' is linear, but joint '{2}' is revolute", driver.name, joint.name),
        say("a linear driver needs a prismatic joint or a slot"));
  } else if (joint.kind != JointKind::prismatic && joint.kind != JointKind::slot) {
    add(About::driver, k, say("driver '{1}' is linear, but joint '{2}' does not slide", driver.name, joint.name),
        say("a linear driver needs a prismatic joint or a slot"));
  }
  check_driven_once(k, driver);
}

void PartChecks::check_driven_once(std::size_t k, const Driver& driver) {
  for (std::size_t before = 0; before < k; ++before) {
    const Driver& other = model_.drivers[before];
    if (other.kind != driver.kind) continue;
    const bool rotary = driver.kind == Driver::Kind::rotary;
    if (rotary ? !same_pair(driver, other) : driver.joint != other.joint) continue;
    add(About::driver, k, say("drivers '{1}' and '{2}' drive the same joint", other.name, driver.name),
        say("remove one of them"));
  }
}

void PartChecks::check(std::size_t k, const Load& load) {
  if (load.link == ground || !exists(load.link)) {
    add(About::load, k, say("load '{1}' acts on no link", load.name), say("name a link other than the ground"));
  }
  if (!finite({load.point.x, load.point.y, load.force.x, load.force.y, load.moment})) {
    add(About::load, k, say("load '{1}': its point, force or moment is not a finite number", load.name));
  }
}

void PartChecks::check(std::size_t k, const Spring& spring) {
  if (!exists(spring.i) || !exists(spring.j) || spring.i == spring.j) {
    add(About::spring, k, say("spring '{1}' does not act between two links", spring.name));
  }
  if (!finite({spring.rate, spring.free, spring.damping, spring.point_i.x, spring.point_i.y, spring.point_j.x,
               spring.point_j.y}) ||
      spring.rate < 0.0 || spring.damping < 0.0) {
    add(About::spring, k, say("spring '{1}': its rate and damping must be finite and not negative", spring.name));
  } else if (spring.kind == Spring::Kind::linear && spring.i != spring.j) {
    check_ends(k, spring);
  }
}

/// Ends on one pin, or on pins that hold one place together, never part.
void PartChecks::check_ends(std::size_t k, const Spring& spring) {
  struct End {
    int link;
    Vec point;
    bool operator==(const End& o) const { return link == o.link && point.x == o.point.x && point.y == o.point.y; }
  };
  std::vector<End> place{{spring.i, spring.point_i}};
  const auto reach = [&](const End& from, const End& to) {
    if (std::ranges::find(place, from) == place.end() || std::ranges::find(place, to) != place.end()) return false;
    place.push_back(to);
    return true;
  };
  for (bool again = true; again;) {
    again = false;
    for (const Joint& joint : model_.joints) {
      if (joint.kind != JointKind::revolute && joint.kind != JointKind::rigid) continue;
      const End i{joint.i, joint.point_i}, j{joint.j, joint.point_j};
      again = reach(i, j) || reach(j, i) || again;
    }
  }
  if (std::ranges::find(place, End{spring.j, spring.point_j}) == place.end()) return;
  add(About::spring, k, say("both ends of spring '{1}' are in one place: it has no direction to act in", spring.name),
      say("attach its ends to points that move apart; a spring that turns about a pin has k_turn, c_turn"));
}

void PartChecks::check_connected() {
  const std::size_t fixed = model_.links.size();
  const auto index = [&](int link) { return link == ground ? fixed : static_cast<std::size_t>(link); };
  std::vector<std::size_t> part(fixed + 1);
  std::iota(part.begin(), part.end(), std::size_t{0});
  for (const auto& joint : model_.joints) {
    std::ranges::replace(part, std::size_t{part[index(joint.i)]}, std::size_t{part[index(joint.j)]});
  }
  for (std::size_t label = 0; label <= fixed; ++label) {
    std::vector<std::size_t> members;
    for (std::size_t k = 0; k < fixed; ++k) {
      if (part[k] == label && label != part[fixed]) members.push_back(k);
    }
    if (members.empty()) continue;
    add(About::link, members.front(), say("no joint connects {1} with the ground", names_of(model_.links, members)),
        say("a mechanism is one chain of links and joints that ends at the ground"));
  }
}

}  // namespace

std::vector<Finding> check_parts(const Model& model) { return PartChecks(model).run(); }

}  // namespace loadpath::mechanism
