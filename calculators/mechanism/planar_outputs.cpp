#include "calculators/mechanism/planar_outputs.hpp"

#include "lib/mechanism/vec.hpp"

namespace loadpath {

namespace {

using mechanism::Position;
using mechanism::Vec;

/// A unit with its dimension, by a Unit of lib/units.hpp.
template <class Quantity>
MechanismOutput output(std::string path, const char* doc, const Unit<Quantity>& unit,
                       std::function<double(const Position&)> read) {
  return {std::move(path), doc, unit.symbol, unit.dimension(), std::move(read)};
}

using Outputs = std::vector<MechanismOutput>;

void add_drives(const mechanism::Model& model, Outputs& out) {
  for (std::size_t d = 0; d < model.drivers.size(); ++d) {
    const mechanism::Driver driver = model.drivers[d];
    const auto speed = [driver](const Position& p) {
      const auto of = [&](int link) {
        return link == mechanism::ground ? mechanism::Pose{} : p.velocity[static_cast<std::size_t>(link)];
      };
      return of(driver.i).phi - of(driver.j).phi;
    };
    if (driver.kind == mechanism::Driver::Kind::rotary) {
      out.push_back(output("drive.M", "moment of the drive on the driven link, counter-clockwise positive", N_m,
                           [d](const Position& p) { return p.effort[d]; }));
      out.push_back(
          output("drive.P", "power of the drive", W, [d, speed](const Position& p) { return p.effort[d] * speed(p); }));
    } else {
      out.push_back(output("cylinders." + driver.name + ".F", "force of the drive on the first link, along the guide",
                           N, [d](const Position& p) { return p.effort[d]; }));
    }
  }
}

void add_joints(const mechanism::Model& model, Outputs& out) {
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const std::string path = "joints." + model.joints[j].name;
    out.push_back(output(path + ".F", "magnitude of the joint's force", N,
                         [j](const Position& p) { return mechanism::length(p.reactions[j].force); }));
    out.push_back(output(path + ".x", "force of the first link on the second, along x", N,
                         [j](const Position& p) { return -p.reactions[j].force.x; }));
    out.push_back(output(path + ".y", "force of the first link on the second, along y", N,
                         [j](const Position& p) { return -p.reactions[j].force.y; }));
    if (model.joints[j].kind != mechanism::JointKind::prismatic) continue;
    out.push_back(output(path + ".M", "couple of the first link on the second at the first link's point", N_m,
                         [j](const Position& p) { return -p.reactions[j].couple; }));
  }
}

void add_links(const mechanism::Model& model, Outputs& out) {
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const std::string path = "links." + model.links[k].name;
    out.push_back(
        output(path + ".phi", "angle of the link's axes", deg, [k](const Position& p) { return p.pose[k].phi; }));
    out.push_back(
        output(path + ".omega", "angular speed", rad_per_s, [k](const Position& p) { return p.velocity[k].phi; }));
    out.push_back(output(path + ".epsilon", "angular acceleration", rad_per_s2,
                         [k](const Position& p) { return p.acceleration[k].phi; }));
  }
}

void add_points(const PlanarMechanism::Input& in, Outputs& out) {
  for (const TracedPoint& point : traced_points(in)) {
    const std::string path = "points." + point.name;
    const auto motion = [link = point.link, at = point.at](const Position& p) { return motion_of(p, link, at); };
    out.push_back(output(path + ".x", "place along x", mm, [motion](const Position& p) { return motion(p).place.x; }));
    out.push_back(output(path + ".y", "place along y", mm, [motion](const Position& p) { return motion(p).place.y; }));
    out.push_back(output(path + ".v", "speed", m_per_s,
                         [motion](const Position& p) { return mechanism::length(motion(p).velocity); }));
    out.push_back(output(path + ".v_x", "velocity along x", m_per_s,
                         [motion](const Position& p) { return motion(p).velocity.x; }));
    out.push_back(output(path + ".v_y", "velocity along y", m_per_s,
                         [motion](const Position& p) { return motion(p).velocity.y; }));
    out.push_back(output(path + ".a", "magnitude of the acceleration", m_per_s2,
                         [motion](const Position& p) { return mechanism::length(motion(p).acceleration); }));
    out.push_back(output(path + ".a_x", "acceleration along x", m_per_s2,
                         [motion](const Position& p) { return motion(p).acceleration.x; }));
    out.push_back(output(path + ".a_y", "acceleration along y", m_per_s2,
                         [motion](const Position& p) { return motion(p).acceleration.y; }));
  }
}

}  // namespace

std::vector<MechanismOutput> mechanism_outputs(const PlanarMechanism::Input& in, const mechanism::Model& model) {
  Outputs out;
  add_drives(model, out);
  add_joints(model, out);
  add_links(model, out);
  add_points(in, out);
  return out;
}

PointMotion motion_of(const Position& p, int link, Vec at) {
  if (link == mechanism::ground) return {at, {}, {}};
  const auto k = static_cast<std::size_t>(link);
  const Vec arm = mechanism::turn(p.pose[k].phi)(at);
  const double omega = p.velocity[k].phi, epsilon = p.acceleration[k].phi;
  const Vec across = mechanism::normal(arm);
  return {Vec{p.pose[k].x, p.pose[k].y} + arm, Vec{p.velocity[k].x, p.velocity[k].y} + omega * across,
          Vec{p.acceleration[k].x, p.acceleration[k].y} + epsilon * across - (omega * omega) * arm};
}

}  // namespace loadpath
