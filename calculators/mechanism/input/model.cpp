#include "calculators/mechanism/input/model.hpp"

#include "calculators/mechanism/input/joints.hpp"
#include "calculators/mechanism/input/loads.hpp"
#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/input/point_masses.hpp"
#include "calculators/mechanism/input/points.hpp"
#include "calculators/mechanism/input/profiles.hpp"
#include "lib/mechanism/model/frames.hpp"

#include <cmath>
#include <vector>

namespace loadpath::planar {

namespace {

using mechanism::Vec;

mechanism::Joint joint_of(const Mechanism::Input& in, const planar::Joint& j) {
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

mechanism::Link link_of(const Mechanism::Input& in, std::size_t i) {
  const planar::Link& l = in.links[i];
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

/// Whether the points of its two links lie in one place, or at least on one line.
bool brings_together(mechanism::JointKind kind) {
  using Kind = mechanism::JointKind;
  return kind == Kind::revolute || kind == Kind::prismatic || kind == Kind::slot || kind == Kind::rigid;
}

/// Links that have an angle but no origin are hung, one after the other, on a joint with a link that is placed.
void place_links(const Mechanism::Input& in, mechanism::Model& model) {
  std::vector<bool> placed;
  for (const auto& l : in.links) placed.push_back(is_drawn(l) || is_set(l.origin.x));
  const auto is_placed = [&](int link) { return link == mechanism::ground || placed[static_cast<std::size_t>(link)]; };
  for (bool again = true; again;) {
    again = false;
    for (const mechanism::Joint& j : model.joints) {
      if (is_placed(j.i) == is_placed(j.j) || !brings_together(j.kind)) continue;
      const bool i_free = !is_placed(j.i);
      const int free = i_free ? j.i : j.j;
      const Vec target = placed_in(model, i_free ? j.j : j.i).point(i_free ? j.point_j : j.point_i);
      mechanism::Pose& pose = model.links[static_cast<std::size_t>(free)].pose;
      const Vec offset = mechanism::turn(pose.phi)(i_free ? j.point_i : j.point_j);
      pose.x = target.x - offset.x;
      pose.y = target.y - offset.y;
      placed[static_cast<std::size_t>(free)] = again = true;
    }
  }
}

/// The crank turns against the fixed link where it has one, else the first link of the joint against the second.
mechanism::Driver crank_driver(const Mechanism::Input& in, const mechanism::Model& model) {
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

mechanism::Driver cylinder_driver(const Mechanism::Input& in, const planar::Cylinder& c,
                                  const mechanism::Model& model) {
  mechanism::Driver driver;
  driver.name = c.name.view();
  driver.kind = mechanism::Driver::Kind::linear;
  driver.joint = static_cast<int>(index_of(in.joints, c.joint));
  const mechanism::Joint& joint = model.joints[static_cast<std::size_t>(driver.joint)];
  driver.i = joint.i;
  driver.j = joint.j;
  return driver;
}

}  // namespace

mechanism::Model model_of(const Mechanism::Input& in) {
  mechanism::Model model;
  for (std::size_t i = 0; i < in.links.size(); ++i) model.links.push_back(link_of(in, i));
  for (const auto& j : in.joints) model.joints.push_back(joint_of(in, j));
  place_links(in, model);
  if (!in.crank.joint.empty()) model.drivers.push_back(crank_driver(in, model));
  for (const auto& c : in.cylinders) {  // between two points they become a joint first (with_cylinders)
    if (!c.joint.empty()) model.drivers.push_back(cylinder_driver(in, c, model));
  }
  take_from_assembly(model);
  for (const auto& l : in.loads) model.loads.push_back(load_of(in, l));
  for (const auto& spring : in.springs) model.springs.push_back(spring_of(in, spring));
  model.gravity = in_si(in.gravity) * Vec{std::cos(in.gravity_direction), std::sin(in.gravity_direction)};
  return model;
}

}  // namespace loadpath::planar
