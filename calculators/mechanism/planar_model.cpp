#include "calculators/mechanism/planar_model.hpp"

#include "calculators/mechanism/planar_accuracy.hpp"
#include "calculators/mechanism/planar_balance.hpp"
#include "calculators/mechanism/planar_hodographs.hpp"
#include "calculators/mechanism/planar_joints.hpp"
#include "calculators/mechanism/planar_loads.hpp"
#include "calculators/mechanism/planar_masses.hpp"
#include "calculators/mechanism/planar_names.hpp"
#include "calculators/mechanism/planar_profiles.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath {

namespace {

using Planar = PlanarMechanism;
using mechanism::Vec;

class NameCheck : private NameFaults {
 public:
  explicit NameCheck(const Planar::Input& in) : NameFaults(in), in_(in) {}

  std::vector<ModelFault> run() {
    for (const auto& point : in_.ground) check_point(point, "ground." + std::string(point.name.view()));
    for (const auto& link : in_.links) check_link(link);
    for (const auto& joint : in_.joints) check_joint(joint);
    for (const auto& profile : in_.profiles) {
      for (FieldFault& fault : check_fields(profile)) add(std::move(fault));
    }
    check_drives();
    for (std::size_t i = 0; i < in_.loads.size(); ++i) check_load(in_.loads[i], i);
    for (const auto& spring : in_.springs) check_spring(spring);
    for (const auto& link : in_.links) check_mass_points(link, *this);
    check_accuracy(*this);
    check_balance(*this);
    check_hodographs(*this);
    if (none()) check_shared_points();
    return take();
  }

 private:
  void check_point(const Planar::Point& p, const std::string& path) {
    const bool cartesian = is_set(p.x) && is_set(p.y), polar = is_set(p.r) && is_set(p.angle);
    const bool any_cartesian = is_set(p.x) || is_set(p.y), any_polar = is_set(p.r) || is_set(p.angle);
    if (!(cartesian && !any_polar) && !(polar && !any_cartesian)) {
      add(path, say("a point has either x and y or r and angle"),
          say("write [\"40 mm\", \"0 mm\"] or { r = \"40 mm\", angle = \"20 deg\" }"));
    }
  }

  void check_link(const Planar::Link& link) {
    if (link.name.view() == "ground")
      add(path_of("links", link.name, ""),
          say("the fixed link is always called 'ground'; its points stand in [ground]"));
    for (const auto& p : link.points)
      check_point(p, path_of("links", link.name, "points") + "." + std::string(p.name.view()));
    if (!link.S.empty()) require_point(link_index(in_, link.name), link.S, path_of("links", link.name, "S"));
    if (is_set(link.origin.x) && !is_set(link.angle)) {
      add(path_of("links", link.name, "origin"), say("a link with an origin needs its angle too"));
    }
  }

  void check_joint(const Planar::Joint& joint) {
    const std::string links = path_of("joints", joint.name, "links");
    const std::string points = joint.points.first.empty() ? links : path_of("joints", joint.name, "points");
    const bool first = require_link(joint.links.first, links + ".first");
    const bool second = require_link(joint.links.second, links + ".second");
    const auto [p1, p2] = point_names(joint);
    if (first) require_point(link_index(in_, joint.links.first), p1, points + ".first");
    if (second) require_point(link_index(in_, joint.links.second), p2, points + ".second");
    if (first && joint.links.first == joint.links.second) {
      add(links, say("joint '{1}' connects '{2}' with itself", joint.name.view(), joint.links.first.view()),
          say("a joint is between two links, or between a link and the ground"));
    }
    for (FieldFault& fault : check_fields(joint)) add(std::move(fault));
    if (is_cam(joint.type) && !joint.profile.empty()) check_cam(joint);
  }

  void check_cam(const Planar::Joint& joint) {
    if (find_profile(in_, joint.profile) == nullptr) {
      const auto names = names_in(in_.profiles);
      add(path_of("joints", joint.name, "profile"), say("there is no profile '{1}'", joint.profile.view()),
          did_you_mean(joint.profile.view(), names,
                       say("add it: profiles.{1} = { shape = \"circle\", r = \"40 mm\" }", joint.profile.view())));
    }
    if (roller_radius(in_, joint) == 0.0 || (joint.mu == 0.0 && in_si(joint.c) == 0.0)) return;
    add(path_of("joints", joint.name, joint.mu != 0.0 ? "mu" : "c"),
        say("the roller of joint '{1}' rolls on its cam, and does not rub", joint.name.view()),
        say("leave it out; an edge (radius 0) and a flat face rub"));
  }

  void require_turning(const Name& name) {
    for (const auto& j : in_.joints) {
      if (j.name == name && j.type != Planar::Type::revolute) {
        add("crank.joint", say("a crank turns a revolute joint, and '{1}' is none", name.view()),
            say("a slide or a slot takes a cylinder"));
      }
    }
  }

  void check_drives() {
    if (!in_.crank.joint.empty()) require_joint(in_.crank.joint, "crank.joint");
    require_turning(in_.crank.joint);
    for (const auto& c : in_.cylinders) require_joint(c.joint, path_of("cylinders", c.name, "joint"));
    if (in_.crank.joint.empty() || in_.crank.to.empty() || !none()) return;
    const Planar::Joint* const joint = find_named(in_.joints, in_.crank.joint);
    const bool first_fixed = joint->links.first.view() == "ground";
    require_point(link_index(in_, first_fixed ? joint->links.second : joint->links.first), in_.crank.to, "crank.to");
  }

  void check_load(const Planar::Load& load, std::size_t i) {
    const std::string path = path_of(load, i);
    const bool known = require_link(load.link, path + ".link");
    const bool polar = is_set(load.F) && is_set(load.direction), cartesian = is_set(load.F_x) || is_set(load.F_y);
    const bool any_polar = is_set(load.F) || is_set(load.direction);
    const bool part = any_polar || cartesian;
    if (known && load.link.view() == "ground")
      add(path + ".link", say("a load on the ground has no effect"), say("name a moving link"));
    if (any_polar && cartesian)
      add(path, say("give either F with direction or F_x and F_y, not both"));
    else if (part && !polar && !cartesian)
      add(path, say("give F with direction, or F_x and F_y"));
    if (!part && !is_set(load.M)) add(path, say("a load has a force (F with direction, or F_x and F_y) or a couple M"));
    if (part && load.at.empty()) add(path, say("a force needs the point it acts at: at = \"...\""));
    if (known && !load.at.empty()) require_point(link_index(in_, load.link), load.at, path + ".at");
  }

  void check_spring(const Planar::Spring& spring) {
    const bool first = require_link(spring.links.first, path_of("springs", spring.name, "links") + ".first");
    const bool second = require_link(spring.links.second, path_of("springs", spring.name, "links") + ".second");
    for (FieldFault& fault : check_fields(spring)) add(std::move(fault));
    if (first && second && spring.links.first == spring.links.second)
      add(path_of("springs", spring.name, "links"), say("a spring acts between two links, or a link and the ground"));
    if (spring.points.first.empty()) return;
    const std::string points = path_of("springs", spring.name, "points");
    if (first) require_point(link_index(in_, spring.links.first), spring.points.first, points + ".first");
    if (second) require_point(link_index(in_, spring.links.second), end_of(spring).second, points + ".second");
  }

  /// In a drawing one letter is one point: two links may share it only where a pin, or weld, of that name joins them.
  void check_shared_points() {
    for (std::size_t b = 1; b < in_.links.size(); ++b) {
      const auto& link = in_.links[b];
      for (const auto& p : link.points) {
        const auto shares = [&](const auto& other) {
          return find_point(in_, link_index(in_, other.name), p.name) != nullptr &&
                 !pinned(other.name, link.name, p.name);
        };
        const auto end = in_.links.begin() + static_cast<std::ptrdiff_t>(b);
        const auto other = std::find_if(in_.links.begin(), end, shares);
        if (other == end) continue;
        add(path_of("links", link.name, "points") + "." + std::string(p.name.view()),
            say("'{1}' is a point of '{2}' and of '{3}', but no pin '{1}' joins them", p.name.view(),
                other->name.view(), link.name.view()),
            say("give one of the two another name, or add the joint {1} = { type = \"revolute\", links = [\"{2}\", "
                "\"{3}\"] }",
                p.name.view(), other->name.view(), link.name.view()));
      }
    }
  }

  /// Whether pins or welds of one name lead from a link to another, over a third where several links meet in one point.
  bool pinned(const Name& from, const Name& to, const Name& pin) const {
    std::vector<Name> reached{from};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      for (const auto& j : in_.joints) {
        const bool joins = j.type == Planar::Type::revolute || j.type == Planar::Type::rigid;
        const bool is_pin = joins && point_names(j) == std::pair(pin, pin);
        if (!is_pin || (j.links.first != reached[i] && j.links.second != reached[i])) continue;
        const Name& other = j.links.first == reached[i] ? j.links.second : j.links.first;
        if (std::find(reached.begin(), reached.end(), other) == reached.end()) reached.push_back(other);
      }
    }
    return std::find(reached.begin(), reached.end(), to) != reached.end();
  }

  const Planar::Input& in_;
};

mechanism::Joint joint_of(const Planar::Input& in, const Planar::Joint& j) {
  const auto [p1, p2] = point_names(j);
  mechanism::Joint joint = joint_values(j);
  joint.i = link_index(in, j.links.first);
  joint.j = link_index(in, j.links.second);
  joint.point_i = vector_of(*find_point(in, joint.i, p1));
  joint.point_j = vector_of(*find_point(in, joint.j, p2));
  if (is_cam(j.type)) {
    joint.profile = profile_of(*find_profile(in, j.profile));
    joint.radius_i = roller_radius(in, j);
  }
  return joint;
}

bool is_drawn(const Planar::Link& link) { return !is_set(link.angle) && !is_set(link.origin.x); }

mechanism::Link link_of(const Planar::Input& in, std::size_t i) {
  const Planar::Link& l = in.links[i];
  mechanism::Link link;
  link.name = l.name.view();
  link.mass = in_si(l.mass);
  link.inertia = in_si(l.J);
  if (!l.S.empty()) link.centre = vector_of(*find_point(in, static_cast<int>(i), l.S));
  link.inertia = reduced_inertia(l, link);
  link.pose.phi = is_set(l.angle) ? l.angle : 0.0;
  if (is_set(l.origin.x)) link.pose = {in_si(l.origin.x), in_si(l.origin.y), link.pose.phi};
  return link;
}

Vec on_paper(const mechanism::Model& model, int link, Vec p) {
  if (link == mechanism::ground) return p;
  const mechanism::Pose& pose = model.links[static_cast<std::size_t>(link)].pose;
  return Vec{pose.x, pose.y} + mechanism::turn(pose.phi)(p);
}

/// Whether the points of its two links lie in one place, or at least on one line.
bool brings_together(mechanism::JointKind kind) {
  using Kind = mechanism::JointKind;
  return kind == Kind::revolute || kind == Kind::prismatic || kind == Kind::slot || kind == Kind::rigid;
}

/// Links that have an angle but no origin are hung, one after the other, on a joint with a link that is placed.
void place_links(const Planar::Input& in, mechanism::Model& model) {
  std::vector<bool> placed;
  for (const auto& l : in.links) placed.push_back(is_drawn(l) || is_set(l.origin.x));
  const auto is_placed = [&](int link) { return link == mechanism::ground || placed[static_cast<std::size_t>(link)]; };
  for (bool again = true; again;) {
    again = false;
    for (const mechanism::Joint& j : model.joints) {
      if (is_placed(j.i) == is_placed(j.j) || !brings_together(j.kind)) continue;
      const bool i_free = !is_placed(j.i);
      const int free = i_free ? j.i : j.j;
      const Vec target = on_paper(model, i_free ? j.j : j.i, i_free ? j.point_j : j.point_i);
      mechanism::Pose& pose = model.links[static_cast<std::size_t>(free)].pose;
      const Vec offset = mechanism::turn(pose.phi)(i_free ? j.point_i : j.point_j);
      pose.x = target.x - offset.x;
      pose.y = target.y - offset.y;
      placed[static_cast<std::size_t>(free)] = again = true;
    }
  }
}

/// The crank turns against the fixed link where it has one, else the first link of the joint against the second.
mechanism::Driver crank_driver(const Planar::Input& in, const mechanism::Model& model) {
  const mechanism::Joint& joint = model.joints[index_of(in.joints, in.crank.joint)];
  mechanism::Driver driver;
  driver.name = "crank";
  const bool first_fixed = joint.i == mechanism::ground;
  driver.i = first_fixed ? joint.j : joint.i;
  driver.j = first_fixed ? joint.i : joint.j;
  if (!in.crank.to.empty()) {
    const Vec to = vector_of(*find_point(in, driver.i, in.crank.to)) - (first_fixed ? joint.point_j : joint.point_i);
    driver.offset = std::atan2(to.y, to.x);
  }
  return driver;
}

mechanism::Driver cylinder_driver(const Planar::Input& in, const Planar::Cylinder& c, const mechanism::Model& model) {
  mechanism::Driver driver;
  driver.name = c.name.view();
  driver.kind = mechanism::Driver::Kind::linear;
  driver.joint = static_cast<int>(index_of(in.joints, c.joint));
  const mechanism::Joint& joint = model.joints[static_cast<std::size_t>(driver.joint)];
  driver.i = joint.i;
  driver.j = joint.j;
  return driver;
}

/// A link whose only two joints are pins at points in one place.
void check_lengths(const Planar::Input& in, const mechanism::Model& model, double size,
                   std::vector<ModelFault>& faults) {
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
                      say("lay them apart, or join its neighbours by one pin and leave '{1}' out", name.view())});
  }
}

}  // namespace

std::vector<ModelFault> check_drawing(const Planar::Input& in, const mechanism::Model& model) {
  const auto drawn = [&](int link) {
    return link == mechanism::ground || is_drawn(in.links[static_cast<std::size_t>(link)]);
  };
  double size = 0.0;
  for (const auto& j : model.joints)
    size = std::max({size, mechanism::length(j.point_i), mechanism::length(j.point_j)});
  std::vector<ModelFault> faults;
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const mechanism::Joint& j = model.joints[k];
    const double apart = mechanism::length(j.point_i - j.point_j);
    if (j.kind != mechanism::JointKind::revolute || !drawn(j.i) || !drawn(j.j) || apart <= 0.01 * size) continue;
    faults.push_back({path_of("joints", in.joints[k].name, ""),
                      say("the pin '{1}' is drawn at two places, {2} apart", j.name, format_quantity(apart, "mm", 4)),
                      say("draw it at one place on both links, or give the links their angles")});
  }
  check_lengths(in, model, size, faults);
  return faults;
}

std::vector<ModelFault> check_names(const Planar::Input& in) { return NameCheck(in).run(); }

std::pair<Name, Name> point_names(const Planar::Joint& joint) {
  const Name first = joint.points.first.empty() ? joint.name : joint.points.first;
  return {first, joint.points.second.empty() ? first : joint.points.second};
}

int link_index(const Planar::Input& in, const Name& name) {
  return find_named(in.links, name) == nullptr ? mechanism::ground : static_cast<int>(index_of(in.links, name));
}

const Planar::Point* find_point(const Planar::Input& in, int link, const Name& name) {
  return link == mechanism::ground ? find_named(in.ground, name)
                                   : find_named(in.links[static_cast<std::size_t>(link)].points, name);
}

Vec vector_of(const Planar::Point& p) {
  if (is_set(p.x)) return {in_si(p.x), in_si(p.y)};
  return in_si(p.r) * Vec{std::cos(p.angle), std::sin(p.angle)};
}

mechanism::Model model_of(const Planar::Input& in) {
  mechanism::Model model;
  for (std::size_t i = 0; i < in.links.size(); ++i) model.links.push_back(link_of(in, i));
  for (const auto& j : in.joints) model.joints.push_back(joint_of(in, j));
  place_links(in, model);
  take_from_assembly(model);
  if (!in.crank.joint.empty()) model.drivers.push_back(crank_driver(in, model));
  for (const auto& c : in.cylinders) model.drivers.push_back(cylinder_driver(in, c, model));
  for (const auto& l : in.loads) model.loads.push_back(load_of(in, l));
  for (const auto& spring : in.springs) model.springs.push_back(spring_of(in, spring));
  model.gravity = in_si(in.gravity) * Vec{std::cos(in.gravity_direction), std::sin(in.gravity_direction)};
  return model;
}

std::vector<TracedPoint> traced_points(const Planar::Input& in) {
  std::vector<TracedPoint> points;
  for (std::size_t i = 0; i < in.links.size(); ++i) {
    for (const auto& p : in.links[i].points) {
      const bool known =
          std::any_of(points.begin(), points.end(), [&](const auto& t) { return t.name == p.name.view(); });
      if (!known) points.push_back({std::string(p.name.view()), static_cast<int>(i), vector_of(p)});
    }
  }
  return points;
}

}  // namespace loadpath
