#include "calculators/mechanism/input/checks.hpp"

#include "calculators/mechanism/input/joints.hpp"
#include "calculators/mechanism/input/loads.hpp"
#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/input/points.hpp"
#include "calculators/mechanism/input/profiles.hpp"
#include "lib/mechanism/model/vec.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace loadpath::planar {

namespace {

using mechanism::Vec;

class NameCheck {
 public:
  explicit NameCheck(NameFaults& faults) : faults_(faults), in_(faults.input()) {}

  void run() {
    for (const auto& point : in_.ground) check_point(point, "ground." + std::string(point.name.view()));
    for (const auto& link : in_.links) check_link(link);
    for (const auto& joint : in_.joints) check_joint(joint);
    for (const auto& profile : in_.profiles) faults_.add(check_fields(profile));
    check_drives();
    for (std::size_t i = 0; i < in_.loads.size(); ++i) check_load(in_.loads[i], i);
    for (const auto& spring : in_.springs) check_spring(spring);
  }

 private:
  void check_point(const planar::Point& p, const std::string& path) {
    const bool cartesian = is_set(p.x) && is_set(p.y), polar = is_set(p.r) && is_set(p.angle);
    const bool any_cartesian = is_set(p.x) || is_set(p.y), any_polar = is_set(p.r) || is_set(p.angle);
    if (!(cartesian && !any_polar) && !(polar && !any_cartesian)) {
      faults_.add(path, say("a point has either x and y or r and angle"),
                  say("write [\"40 mm\", \"0 mm\"] or { r = \"40 mm\", angle = \"20 deg\" }"));
    }
  }

  void check_link(const planar::Link& link) {
    if (link.name.view() == "ground")
      faults_.add(path_of("links", link.name, ""),
                  say("the fixed link is called 'ground'; give its points in [ground]"));
    for (const auto& p : link.points)
      check_point(p, path_of("links", link.name, "points") + "." + std::string(p.name.view()));
    if (!link.S.empty()) faults_.require_point(link_index(in_, link.name), link.S, path_of("links", link.name, "S"));
    if (is_set(link.origin.x) && !is_set(link.angle)) {
      faults_.add(path_of("links", link.name, "origin"), say("a link with an origin needs its angle too"));
    }
  }

  void check_joint(const planar::Joint& joint) {
    const std::string links = path_of("joints", joint.name, "links");
    const std::string points = joint.points.first.empty() ? links : path_of("joints", joint.name, "points");
    const bool first = faults_.require_link(joint.links.first, links + ".first");
    const bool second = faults_.require_link(joint.links.second, links + ".second");
    const auto [p1, p2] = point_names(joint);
    if (first) faults_.require_point(link_index(in_, joint.links.first), p1, points + ".first");
    if (second) faults_.require_point(link_index(in_, joint.links.second), p2, points + ".second");
    if (first && joint.links.first == joint.links.second) {
      faults_.add(links, say("joint '{1}' connects '{2}' with itself", joint.name.view(), joint.links.first.view()),
                  say("a joint is between two links, or between a link and the ground"));
    }
    faults_.add(check_fields(joint));
    if (is_cam(joint.type) && !joint.profile.empty()) check_cam(joint);
  }

  void check_cam(const planar::Joint& joint) {
    if (find_profile(in_, joint.profile) == nullptr) {
      const auto names = names_in(in_.profiles);
      faults_.add(
          path_of("joints", joint.name, "profile"), say("unknown profile '{1}'", joint.profile.view()),
          did_you_mean(joint.profile.view(), names,
                       say("add it: profiles.{1} = { shape = \"circle\", r = \"40 mm\" }", joint.profile.view())));
    }
    if (roller_radius(in_, joint) == 0.0 || (joint.mu == 0.0 && in_si(joint.c) == 0.0)) return;
    faults_.add(path_of("joints", joint.name, joint.mu != 0.0 ? "mu" : "c"),
                say("the roller of joint '{1}' rolls on its cam, and does not rub", joint.name.view()),
                say("leave it out; an edge (radius 0) and a flat face rub"));
  }

  void require_turning(const Name& name) {
    for (const auto& j : in_.joints) {
      if (j.name == name && j.type != planar::Type::revolute) {
        faults_.add("crank.joint", say("a crank needs a revolute joint, and '{1}' is not one", name.view()),
                    say("drive a slide or a slot by a cylinder: cylinders.C1 = { joint = \"{1}\", ... }", name.view()));
      }
    }
  }

  void check_drives() {
    if (!in_.crank.joint.empty()) faults_.require_joint(in_.crank.joint, "crank.joint");
    require_turning(in_.crank.joint);
    if (in_.crank.joint.empty() || in_.crank.to.empty() || !faults_.none()) return;
    const planar::Joint* const joint = find_named(in_.joints, in_.crank.joint);
    const bool first_fixed = joint->links.first.view() == "ground";
    faults_.require_point(link_index(in_, first_fixed ? joint->links.second : joint->links.first), in_.crank.to,
                          "crank.to");
  }

  void check_load(const planar::Load& load, std::size_t i) {
    const std::string path = path_of(load, i);
    if (!load.course.empty()) faults_.require_course(load.course, path + ".course");
    const bool known = faults_.require_link(load.link, path + ".link");
    const bool polar = is_set(load.F) && is_set(load.direction), cartesian = is_set(load.F_x) || is_set(load.F_y);
    const bool any_polar = is_set(load.F) || is_set(load.direction);
    const bool part = any_polar || cartesian;
    if (known && load.link.view() == "ground")
      faults_.add(path + ".link", say("a load on the ground has no effect"), say("name a moving link"));
    if (any_polar && cartesian)
      faults_.add(path, say("give either F with direction or F_x and F_y, not both"));
    else if (part && !polar && !cartesian)
      faults_.add(path, say("give F with direction, or F_x and F_y"));
    if (!part && !is_set(load.M))
      faults_.add(path, say("a load has a force (F with direction, or F_x and F_y) or a couple M"));
    if (part && load.at.empty()) faults_.add(path, say("a force needs the point it acts at: at = \"...\""));
    if (known && !load.at.empty()) faults_.require_point(link_index(in_, load.link), load.at, path + ".at");
  }

  void check_spring(const planar::Spring& spring) {
    const bool first = faults_.require_link(spring.links.first, path_of("springs", spring.name, "links") + ".first");
    const bool second = faults_.require_link(spring.links.second, path_of("springs", spring.name, "links") + ".second");
    faults_.add(check_fields(spring));
    if (first && second && spring.links.first == spring.links.second)
      faults_.add(path_of("springs", spring.name, "links"),
                  say("a spring acts between two links, or a link and the ground"));
    if (spring.points.first.empty()) return;
    const std::string points = path_of("springs", spring.name, "points");
    if (first) faults_.require_point(link_index(in_, spring.links.first), spring.points.first, points + ".first");
    if (second) faults_.require_point(link_index(in_, spring.links.second), end_of(spring).second, points + ".second");
  }

  NameFaults& faults_;
  const Mechanism::Input& in_;
};

/// Whether pins or welds of one name lead from a link to another, over a third where several links meet in one point.
bool pinned(const Mechanism::Input& in, const Name& from, const Name& to, const Name& pin) {
  std::vector<Name> reached{from};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const auto& j : in.joints) {
      const bool joins = j.type == Type::revolute || j.type == Type::rigid;
      const bool is_pin = joins && point_names(j) == std::pair(pin, pin);
      if (!is_pin || (j.links.first != reached[i] && j.links.second != reached[i])) continue;
      const Name& other = j.links.first == reached[i] ? j.links.second : j.links.first;
      if (std::find(reached.begin(), reached.end(), other) == reached.end()) reached.push_back(other);
    }
  }
  return std::find(reached.begin(), reached.end(), to) != reached.end();
}

/// A link whose only two joints are pins at points in one place.
void check_lengths(const Mechanism::Input& in, const mechanism::Model& model, double size,
                   std::vector<FieldFault>& faults) {
  for (std::size_t k = 0; k < in.links.size(); ++k) {
    std::vector<std::pair<Name, Vec>> pins;
    bool only_pins = true;
    for (std::size_t n = 0; n < model.joints.size(); ++n) {
      const mechanism::Joint& joint = model.joints[n];
      const bool first = joint.i == static_cast<int>(k);
      if (!first && joint.j != static_cast<int>(k)) continue;
      only_pins = only_pins && joint.kind == mechanism::JointKind::revolute;
      const auto names = point_names(in.joints[n]);
      pins.emplace_back(first ? names.first : names.second, first ? joint.point_i : joint.point_j);
    }
    if (!only_pins || pins.size() != 2 || pins[0].first == pins[1].first) continue;
    if (mechanism::length(pins[0].second - pins[1].second) > 1e-9 * size) continue;
    const auto& name = in.links[k].name;
    faults.push_back({path_of("links", name, "points"),
                      say("points {1} and {2} of '{3}' coincide: it moves nothing", pins[0].first.view(),
                          pins[1].first.view(), name.view()),
                      say("move them apart, or join its neighbours by one pin and leave '{1}' out", name.view())});
  }
}

}  // namespace

void check_names(NameFaults& faults) { NameCheck(faults).run(); }

void check_shared_points(NameFaults& faults) {
  const Mechanism::Input& in = faults.input();
  for (std::size_t b = 1; b < in.links.size(); ++b) {
    const auto& link = in.links[b];
    for (const auto& p : link.points) {
      const auto shares = [&](const auto& other) {
        return find_named(other.points, p.name) != nullptr && !pinned(in, other.name, link.name, p.name);
      };
      const auto end = in.links.begin() + static_cast<std::ptrdiff_t>(b);
      const auto other = std::find_if(in.links.begin(), end, shares);
      if (other == end) continue;
      faults.add(path_of("links", link.name, "points") + "." + std::string(p.name.view()),
                 say("'{1}' is a point of '{2}' and of '{3}', but no pin '{1}' joins them", p.name.view(),
                     other->name.view(), link.name.view()),
                 say("give one of the two another name, or add the joint {1} = { type = \"revolute\", links = "
                     "[\"{2}\", \"{3}\"] }",
                     p.name.view(), other->name.view(), link.name.view()));
    }
  }
}

std::vector<FieldFault> check_gravity(const Mechanism::Input& in) {
  if (!(in_si(in.gravity) < 0.0)) return {};
  return {{"gravity", say("gravity = {1}: must be ≥ 0 m/s²", format_quantity(in_si(in.gravity), "m/s^2")),
           say("it is a magnitude: write gravity = \"{1}\"; direction: downwards, or gravity_direction",
               format_quantity(-in_si(in.gravity), "m/s^2"))}};
}

bool leaves_out_weights(const Mechanism::Input& in) {
  return in_si(in.gravity) == 0.0 &&
         std::ranges::any_of(in.links, [](const auto& link) { return in_si(link.mass) > 0.0; });
}

std::vector<FieldFault> check_drawing(const Mechanism::Input& in, const mechanism::Model& model) {
  const auto drawn = [&](int link) {
    return link == mechanism::ground || is_drawn(in.links[static_cast<std::size_t>(link)]);
  };
  double size = 0.0;
  for (const auto& j : model.joints)
    size = std::max({size, mechanism::length(j.point_i), mechanism::length(j.point_j)});
  std::vector<FieldFault> faults;
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const mechanism::Joint& j = model.joints[k];
    const double apart = mechanism::length(j.point_i - j.point_j);
    if (j.kind != mechanism::JointKind::revolute || !drawn(j.i) || !drawn(j.j) || apart <= 0.01 * size) continue;
    faults.push_back({path_of("joints", in.joints[k].name, ""),
                      say("the pin '{1}' has two positions, {2} apart", j.name, format_quantity(apart, "mm", 4)),
                      say("give it the same position on both links, or give the links their angles")});
  }
  check_lengths(in, model, size, faults);
  return faults;
}

}  // namespace loadpath::planar
