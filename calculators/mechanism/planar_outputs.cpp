#include "calculators/mechanism/planar_outputs.hpp"

#include "calculators/mechanism/planar_accuracy.hpp"
#include "calculators/mechanism/planar_balance.hpp"
#include "calculators/mechanism/planar_design_outputs.hpp"
#include "calculators/mechanism/planar_efficiency.hpp"
#include "calculators/mechanism/planar_kinematics.hpp"
#include "calculators/mechanism/planar_rest.hpp"
#include "calculators/mechanism/planar_rows.hpp"
#include "lib/mechanism/model/vec.hpp"

#include <array>

namespace loadpath {

namespace {

using mechanism::Position;
using mechanism::Vec;
using planar::add_outputs;
using planar::list_patterns;
using planar::row;

struct Drive {
  std::string name;
  std::size_t index;
  mechanism::Driver driver;

  static bool is_rotary(const Drive& d) { return d.driver.kind == mechanism::Driver::Kind::rotary; }
  static bool is_linear(const Drive& d) { return !is_rotary(d); }
  [[nodiscard]] double speed(const Position& p) const {
    const auto of = [&](int link) {
      return link == mechanism::ground ? mechanism::Pose{} : p.velocity[static_cast<std::size_t>(link)];
    };
    return of(driver.i).phi - of(driver.j).phi;
  }
};

constexpr std::array drive_rows{
    row<Drive>(
        "drive.M", "moment of the drive on the driven link, counter-clockwise positive", N_m,
        [](const Drive& d, const Position& p) { return p.effort[d.index]; }, &Drive::is_rotary, "with a crank"),
    row<Drive>(
        "drive.P", "power of the drive", W,
        [](const Drive& d, const Position& p) { return p.effort[d.index] * d.speed(p); }, &Drive::is_rotary,
        "with a crank"),
    row<Drive>(
        "cylinders.NAME.F", "force of the drive on the first link, along the guide", N,
        [](const Drive& d, const Position& p) { return p.effort[d.index]; }, &Drive::is_linear)};

struct Joint {
  std::string name;
  std::size_t index;
  mechanism::JointKind kind;

  static bool is_prismatic(const Joint& j) { return j.kind == mechanism::JointKind::prismatic; }
};

constexpr std::array joint_rows{
    row<Joint>("joints.NAME.F", "magnitude of the joint's force", N,
               [](const Joint& j, const Position& p) { return mechanism::length(p.reactions[j.index].force); }),
    row<Joint>("joints.NAME.x", "force of the first link on the second, along x", N,
               [](const Joint& j, const Position& p) { return -p.reactions[j.index].force.x; }),
    row<Joint>("joints.NAME.y", "force of the first link on the second, along y", N,
               [](const Joint& j, const Position& p) { return -p.reactions[j.index].force.y; }),
    row<Joint>(
        "joints.NAME.M", "couple of the first link on the second at the first link's point", N_m,
        [](const Joint& j, const Position& p) { return -p.reactions[j.index].couple; }, &Joint::is_prismatic,
        "prismatic joints")};

struct Link {
  std::string name;
  std::size_t index;
};

constexpr std::array link_rows{row<Link>("links.NAME.phi", "angle of the link's axes", deg,
                                         [](const Link& l, const Position& p) { return p.pose[l.index].phi; }),
                               row<Link>("links.NAME.omega", "angular speed", rad_per_s,
                                         [](const Link& l, const Position& p) { return p.velocity[l.index].phi; }),
                               row<Link>("links.NAME.epsilon", "angular acceleration", rad_per_s2,
                                         [](const Link& l, const Position& p) { return p.acceleration[l.index].phi; })};

struct Point {
  std::string name;
  TracedPoint traced;

  [[nodiscard]] PointMotion now(const Position& p) const { return motion_of(p, traced.link, traced.at); }
};

constexpr std::array point_rows{
    row<Point>("points.NAME.x", "place along x", mm, [](const Point&, const PointMotion& m) { return m.place.x; }),
    row<Point>("points.NAME.y", "place along y", mm, [](const Point&, const PointMotion& m) { return m.place.y; }),
    row<Point>("points.NAME.v", "speed", m_per_s,
               [](const Point&, const PointMotion& m) { return mechanism::length(m.velocity); }),
    row<Point>("points.NAME.v_x", "velocity along x", m_per_s,
               [](const Point&, const PointMotion& m) { return m.velocity.x; }),
    row<Point>("points.NAME.v_y", "velocity along y", m_per_s,
               [](const Point&, const PointMotion& m) { return m.velocity.y; }),
    row<Point>("points.NAME.a", "magnitude of the acceleration", m_per_s2,
               [](const Point&, const PointMotion& m) { return mechanism::length(m.acceleration); }),
    row<Point>("points.NAME.a_x", "acceleration along x", m_per_s2,
               [](const Point&, const PointMotion& m) { return m.acceleration.x; }),
    row<Point>("points.NAME.a_y", "acceleration along y", m_per_s2,
               [](const Point&, const PointMotion& m) { return m.acceleration.y; })};

}  // namespace

bool is_drive_effort(std::string_view path) {
  return path == "drive.M" || (path.starts_with("cylinders.") && path.ends_with(".F"));
}

std::vector<MechanismOutput> mechanism_outputs(const PlanarMechanism::Input& in, const mechanism::Model& model) {
  std::vector<MechanismOutput> out;
  for (std::size_t d = 0; d < model.drivers.size(); ++d)
    add_outputs(Drive{model.drivers[d].name, d, model.drivers[d]}, drive_rows, out);
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    add_outputs(Joint{model.joints[j].name, j, model.joints[j].kind}, joint_rows, out);
  for (std::size_t k = 0; k < model.links.size(); ++k) add_outputs(Link{model.links[k].name, k}, link_rows, out);
  for (const TracedPoint& point : traced_points(in)) add_outputs(Point{point.name, point}, point_rows, out);
  add_design_outputs(in, model, out);
  add_kinematic_outputs(in, model, out);
  add_rest_outputs(model, out);
  add_efficiency_outputs(in, model, out);
  add_error_outputs(in, out);
  add_balance_outputs(in, out);
  return out;
}

std::vector<ResultPattern> mechanism_result_patterns() {
  std::vector<ResultPattern> patterns;
  const auto list = [&](const auto& rows) { list_patterns(rows, patterns); };
  list(drive_rows);
  list(joint_rows);
  list(link_rows);
  list(point_rows);
  list_design_patterns(patterns);
  for (const ResultPattern& p : kinematic_result_patterns()) patterns.push_back(p);
  list_rest_patterns(patterns);
  list_efficiency_patterns(patterns);
  list_error_patterns(patterns);
  list_balance_patterns(patterns);
  return patterns;
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
