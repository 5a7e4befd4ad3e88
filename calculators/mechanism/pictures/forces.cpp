#include "calculators/mechanism/pictures/forces.hpp"

#include "calculators/mechanism/cycle/point_motion.hpp"
#include "lib/draw/canvas/typeset.hpp"
#include "lib/mechanism/model/spring.hpp"

#include <algorithm>

namespace loadpath::planar {

namespace {

using mechanism::Model;
using mechanism::Position;
using mechanism::Vec;
using Cause = ActingForce::Cause;

std::string named(const std::string& name, const char* otherwise) { return name.empty() ? otherwise : name; }

void add_loads(const Model& model, const Position& at, int link, std::vector<ActingForce>& forces) {
  for (std::size_t n = 0; n < model.loads.size(); ++n) {
    const mechanism::Load& load = model.loads[n];
    if (load.link != link) continue;
    const mechanism::LoadNow& now = at.loads[n];
    const Vec force = mechanism::global_force(load, now.force, mechanism::turn(angle_of(at, link)));
    const bool is_couple = mechanism::length(force) == 0.0 && now.moment != 0.0;
    forces.push_back({Cause::load, n, 1.0, motion_of(at, link, load.point).place, force, now.moment,
                      named(load.name, is_couple ? "M" : "F")});
  }
}

void add_springs(const Model& model, const Position& at, int link, std::vector<ActingForce>& forces) {
  for (std::size_t n = 0; n < model.springs.size(); ++n) {
    const mechanism::Spring& spring = model.springs[n];
    if (spring.i != link && spring.j != link) continue;
    const mechanism::SpringNow now = mechanism::spring_now(spring, at);
    const bool first = spring.i == link, turning = spring.kind == mechanism::Spring::Kind::turning;
    const double sense = first ? 1.0 : -1.0;
    forces.push_back({Cause::spring, n, sense, first ? now.at_i : now.at_j, sense * now.force, sense * now.couple,
                      (turning ? "M_" : "F_") + spring.name});
  }
}

void add_mass(const Model& model, const Position& at, int link, bool statics, std::vector<ActingForce>& forces) {
  if (link == mechanism::ground) return;
  const auto k = static_cast<std::size_t>(link);
  const mechanism::Link& body = model.links[k];
  const PointMotion centre = motion_of(at, link, body.centre);
  if (body.mass > 0.0 && mechanism::length(model.gravity) > 0.0)
    forces.push_back({Cause::weight, k, 1.0, centre.place, body.mass * model.gravity, 0.0, "G_" + body.name});
  if (statics || (body.mass == 0.0 && body.inertia == 0.0)) return;
  forces.push_back({Cause::inertia, k, 1.0, centre.place, -body.mass * centre.acceleration,
                    -body.inertia * at.acceleration[k].phi,
                    "−" + draw::symbol("m") + " " + draw::symbol("a_" + body.name)});
}

void add_drives(const Model& model, const Position& at, int link, std::vector<ActingForce>& forces) {
  for (std::size_t n = 0; n < model.drivers.size(); ++n) {
    const mechanism::Driver& driver = model.drivers[n];
    const bool rotary = driver.kind == mechanism::Driver::Kind::rotary;
    const mechanism::Joint* slide = rotary ? nullptr : &model.joints[static_cast<std::size_t>(driver.joint)];
    const int first = rotary ? driver.i : slide->i, second = rotary ? driver.j : slide->j;
    if (link != first && link != second) continue;
    const double sense = link == first ? 1.0 : -1.0;
    ActingForce acting{Cause::drive, n, sense, {}, {}, 0.0, rotary ? "M" : "F_" + driver.name};
    if (rotary) {
      acting.couple = sense * at.effort[n];
    } else {
      acting.at = at.reactions[static_cast<std::size_t>(driver.joint)].at;
      acting.force = sense * at.effort[n] * line_of(*slide, at);
    }
    forces.push_back(std::move(acting));
  }
}

/// The name R_A means the force of the joint's first link on its second.
void add_joints(const Model& model, const Position& at, int link, std::vector<ActingForce>& forces) {
  for (std::size_t n = 0; n < model.joints.size(); ++n) {
    const mechanism::Joint& joint = model.joints[n];
    if (joint.i != link && joint.j != link) continue;
    const mechanism::Reaction& reaction = at.reactions[n];
    const double sense = joint.j == link ? 1.0 : -1.0;
    forces.push_back(
        {Cause::joint, n, sense, reaction.at, -sense * reaction.force, -sense * reaction.couple, "R_" + joint.name});
  }
}

}  // namespace

std::string ActingForce::name() const { return sense < 0.0 ? "−" + draw::symbol(label) : label; }

figure::Plan::Tone ActingForce::tone() const {
  if (cause == Cause::joint) return figure::Plan::Tone::first;
  return cause == Cause::weight || cause == Cause::inertia ? figure::Plan::Tone::third : figure::Plan::Tone::second;
}

std::vector<ActingForce> external_forces(const Model& model, const Position& at, int link, bool statics) {
  std::vector<ActingForce> forces;
  add_loads(model, at, link, forces);
  add_springs(model, at, link, forces);
  add_mass(model, at, link, statics, forces);
  add_drives(model, at, link, forces);
  return forces;
}

std::vector<ActingForce> acting_on(const Model& model, const Position& at, int link, bool statics) {
  std::vector<ActingForce> forces = external_forces(model, at, link, statics);
  add_joints(model, at, link, forces);
  return forces;
}

figure::Point middle_of(const std::vector<figure::Point>& points) {
  figure::Point sum;
  for (const auto& p : points) sum.x += p.x, sum.y += p.y;
  const double n = std::max(1.0, static_cast<double>(points.size()));
  return {sum.x / n, sum.y / n};
}

Vec line_of(const mechanism::Joint& joint, const Position& at) {
  return mechanism::turn(angle_of(at, joint.j) + joint.direction)({1.0, 0.0});
}

}  // namespace loadpath::planar
