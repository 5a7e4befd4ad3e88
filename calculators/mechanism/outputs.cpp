#include "calculators/mechanism/outputs.hpp"

#include "calculators/mechanism/aspects/accuracy.hpp"
#include "calculators/mechanism/aspects/balance.hpp"
#include "calculators/mechanism/aspects/efficiency.hpp"
#include "calculators/mechanism/aspects/rest.hpp"
#include "calculators/mechanism/cycle/point_motion.hpp"
#include "calculators/mechanism/results/design.hpp"
#include "calculators/mechanism/results/kinematics.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "calculators/mechanism/words/points.hpp"
#include "lib/mechanism/model/vec.hpp"

#include <array>

namespace loadpath::planar {

namespace {

using mechanism::Position;
using mechanism::Vec;

struct Driven {
  std::string name;
  std::size_t index;
  mechanism::Driver driver;

  static bool is_rotary(const Driven& d) { return d.driver.kind == mechanism::Driver::Kind::rotary; }
  static bool is_linear(const Driven& d) { return !is_rotary(d); }
  [[nodiscard]] double speed(const Position& p) const {
    const auto of = [&](int link) {
      return link == mechanism::ground ? mechanism::Pose{} : p.velocity[static_cast<std::size_t>(link)];
    };
    return of(driver.i).phi - of(driver.j).phi;
  }
};

constexpr std::array drive_rows{
    row<Driven>(
        "drive.M", "moment of the drive on the driven link, counter-clockwise positive", N_m,
        [](const Driven& d, const Position& p) { return p.effort[d.index]; }, &Driven::is_rotary, "with a crank"),
    row<Driven>(
        "drive.P", "power of the drive", W,
        [](const Driven& d, const Position& p) { return p.effort[d.index] * d.speed(p); }, &Driven::is_rotary,
        "with a crank"),
    row<Driven>(
        "cylinders.NAME.F", "force of the drive on the first link, along the guide", N,
        [](const Driven& d, const Position& p) { return p.effort[d.index]; }, &Driven::is_linear)};

struct Jointed {
  std::string name;
  std::size_t index;
  mechanism::JointKind kind;

  static bool is_prismatic(const Jointed& j) { return j.kind == mechanism::JointKind::prismatic; }
};

constexpr std::array joint_rows{
    row<Jointed>("joints.NAME.F", "magnitude of the joint's force", N,
                 [](const Jointed& j, const Position& p) { return mechanism::length(p.reactions[j.index].force); }),
    row<Jointed>("joints.NAME.x", "force of the first link on the second, along x", N,
                 [](const Jointed& j, const Position& p) { return -p.reactions[j.index].force.x; }),
    row<Jointed>("joints.NAME.y", "force of the first link on the second, along y", N,
                 [](const Jointed& j, const Position& p) { return -p.reactions[j.index].force.y; }),
    row<Jointed>(
        "joints.NAME.M", "couple of the first link on the second at the first link's point", N_m,
        [](const Jointed& j, const Position& p) { return -p.reactions[j.index].couple; }, &Jointed::is_prismatic,
        "prismatic joints")};

struct MovingLink {
  std::string name;
  std::size_t index;
};

constexpr std::array link_rows{
    row<MovingLink>("links.NAME.phi", "angle of the link's axes", deg,
                    [](const MovingLink& l, const Position& p) { return p.pose[l.index].phi; }),
    row<MovingLink>("links.NAME.omega", "angular speed", rad_per_s,
                    [](const MovingLink& l, const Position& p) { return p.velocity[l.index].phi; }),
    row<MovingLink>("links.NAME.epsilon", "angular acceleration", rad_per_s2,
                    [](const MovingLink& l, const Position& p) { return p.acceleration[l.index].phi; })};

struct MovingPoint {
  std::string name;
  TracedPoint traced;

  [[nodiscard]] PointMotion now(const Position& p) const { return motion_of(p, traced.link, traced.at); }
};

constexpr std::array point_rows{
    row<MovingPoint>("points.NAME.x", "place along x", mm,
                     [](const MovingPoint&, const PointMotion& m) { return m.place.x; }),
    row<MovingPoint>("points.NAME.y", "place along y", mm,
                     [](const MovingPoint&, const PointMotion& m) { return m.place.y; }),
    row<MovingPoint>("points.NAME.v", "speed", m_per_s,
                     [](const MovingPoint&, const PointMotion& m) { return mechanism::length(m.velocity); }),
    row<MovingPoint>("points.NAME.v_x", "velocity along x", m_per_s,
                     [](const MovingPoint&, const PointMotion& m) { return m.velocity.x; }),
    row<MovingPoint>("points.NAME.v_y", "velocity along y", m_per_s,
                     [](const MovingPoint&, const PointMotion& m) { return m.velocity.y; }),
    row<MovingPoint>("points.NAME.a", "magnitude of the acceleration", m_per_s2,
                     [](const MovingPoint&, const PointMotion& m) { return mechanism::length(m.acceleration); }),
    row<MovingPoint>("points.NAME.a_x", "acceleration along x", m_per_s2,
                     [](const MovingPoint&, const PointMotion& m) { return m.acceleration.x; }),
    row<MovingPoint>("points.NAME.a_y", "acceleration along y", m_per_s2,
                     [](const MovingPoint&, const PointMotion& m) { return m.acceleration.y; })};

}  // namespace

std::vector<Output> mechanism_outputs(const Mechanism::Input& in, const mechanism::Model& model) {
  std::vector<Output> out;
  for (std::size_t d = 0; d < model.drivers.size(); ++d)
    add_outputs(Driven{model.drivers[d].name, d, model.drivers[d]}, drive_rows, out);
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    add_outputs(Jointed{model.joints[j].name, j, model.joints[j].kind}, joint_rows, out);
  for (std::size_t k = 0; k < model.links.size(); ++k) add_outputs(MovingLink{model.links[k].name, k}, link_rows, out);
  for (const TracedPoint& point : traced_points(in)) add_outputs(MovingPoint{point.name, point}, point_rows, out);
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

}  // namespace loadpath::planar
