#include "calculators/mechanism/parts/wheels.hpp"

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "lib/mechanism/model/frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::planar {

namespace {

using mechanism::JointKind;
using mechanism::Position;
using mechanism::Vec;

struct Contact {
  std::string name;
  std::size_t index = 0;
  mechanism::Joint joint;

  struct Forces {
    double T = 0.0, N = 0.0;  // along and across the contact
  };
  [[nodiscard]] Forces forces(const Position& p) const {
    const mechanism::PairShape shape = mechanism::shape_of(joint);
    mechanism::PairPlace at;
    mechanism::place(shape, mechanism::placed_at(p, joint.i), mechanism::placed_at(p, joint.j), at);
    const Vec force = p.reactions[index].force;
    const bool line = joint.kind == JointKind::rack || joint.kind == JointKind::rolling_on_line;
    const Vec along = (1.0 / mechanism::length(at.along)) * at.along;  // pitch circles may lie a little apart
    const Vec towards_axis = line ? std::copysign(1.0, joint.radius_i) * normal(along) : -along;
    return {dot(force, line ? along : normal(along)), dot(force, towards_axis)};
  }
  static bool meshes(const Contact& c) { return c.joint.kind == JointKind::gear || c.joint.kind == JointKind::rack; }
  static bool rolls(const Contact& c) { return !meshes(c); }
};

constexpr std::array contact_rows{
    row<Contact>(
        "joints.NAME.F_t", "circumferential force on the first link's wheel; its sign indicates the loaded flank", N,
        {.kind = Kind::tooth_force, .tabled = Tabled::always, .is_load = true},
        [](const Contact& c, const Position& p) { return c.forces(p).T; }, &Contact::meshes, "gears and racks"),
    row<Contact>(
        "joints.NAME.F_r", "radial force, which presses the wheels apart", N,
        {.tabled = Tabled::always, .is_load = true}, [](const Contact& c, const Position& p) { return c.forces(p).N; },
        &Contact::meshes, "gears and racks"),
    row<Contact>(
        "joints.NAME.N", "contact force between the wheels; negative: the contact is lost", N,
        {.tabled = Tabled::always, .is_load = true}, [](const Contact& c, const Position& p) { return c.forces(p).N; },
        &Contact::rolls, "rolling wheels"),
    row<Contact>(
        "joints.NAME.mu_req", "coefficient of friction required for rolling without slip", ratio,
        [](const Contact& c, const Position& p) {
          const auto [T, pressing] = c.forces(p);
          return T == 0.0 ? 0.0 : pressing > 0.0 ? std::abs(T) / pressing : none;
        },
        &Contact::rolls, "rolling wheels")};

/// A belt or chain around two wheels: its two spans follow from the force on the first wheel's axis and the moment on
/// it.
struct Belt {
  std::string name;
  std::size_t index = 0;
  mechanism::Joint joint;

  struct Spans {
    double tight = 0.0, slack = 0.0;
  };
  [[nodiscard]] Spans spans(const Position& p) const {
    const mechanism::Reaction& r = p.reactions[index];
    const Vec apart = towards(p), centre = mechanism::placed_at(p, joint.i).point(joint.point_i);
    const double cosine = std::cos(tilt(p));
    const double sum = dot(r.force, apart) / cosine;
    const double difference = (cross(r.at - centre, r.force) + r.couple) / joint.radius_i;
    return {0.5 * (sum + std::abs(difference)), 0.5 * (sum - std::abs(difference))};
  }
  /// By which a span leaves the line of centres; of the first wheel's side positive where that is the larger wheel.
  [[nodiscard]] double tilt(const Position& p) const {
    return std::asin((joint.radius_i - joint.radius_j) / distance(p));
  }
  [[nodiscard]] double wrap(const Position& p) const { return pi + 2.0 * tilt(p); }
  /// For a crossed belt, whose second radius is negative, both are equal.
  [[nodiscard]] double wrap_second(const Position& p) const {
    return joint.radius_j < 0.0 ? wrap(p) : pi - 2.0 * tilt(p);
  }

 private:
  [[nodiscard]] Vec between(const Position& p) const {
    return mechanism::placed_at(p, joint.j).point(joint.point_j) -
           mechanism::placed_at(p, joint.i).point(joint.point_i);
  }
  [[nodiscard]] double distance(const Position& p) const { return mechanism::length(between(p)); }
  [[nodiscard]] Vec towards(const Position& p) const { return (1.0 / distance(p)) * between(p); }
};

constexpr std::array belt_rows{
    row<Belt>(
        "joints.NAME.S_tight", "tension of the tight span", N, {.tabled = Tabled::at_one_position, .is_load = true},
        [](const Belt& b, const Position& p) { return b.spans(p).tight; }, nullptr, "belts"),
    row<Belt>(
        "joints.NAME.S_slack", "tension of the slack span", N, {.tabled = Tabled::at_one_position, .is_load = true},
        [](const Belt& b, const Position& p) { return b.spans(p).slack; }, nullptr, "belts"),
    row<Belt>(
        "joints.NAME.wrap", "wrap angle on the first link's wheel", deg,
        [](const Belt& b, const Position& p) { return b.wrap(p); }, nullptr, "belts"),
    row<Belt>(
        "joints.NAME.wrap_second", "wrap angle on the second link's wheel", deg,
        [](const Belt& b, const Position& p) { return b.wrap_second(p); }, nullptr, "belts")};

}  // namespace

void add_wheel_outputs(const mechanism::Joint& joint, std::size_t index, std::vector<Output>& out) {
  const bool touches = joint.kind == JointKind::gear || joint.kind == JointKind::rack ||
                       joint.kind == JointKind::rolling || joint.kind == JointKind::rolling_on_line;
  if (touches) add_outputs(Contact{joint.name, index, joint}, contact_rows, out);
  if (joint.kind == JointKind::belt) add_outputs(Belt{joint.name, index, joint}, belt_rows, out);
}

void list_wheel_patterns(std::vector<ResultPattern>& patterns) {
  list_patterns(contact_rows, patterns);
  list_patterns(belt_rows, patterns);
}

}  // namespace loadpath::planar
