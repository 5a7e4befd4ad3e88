// Kinematic results in addition to places, velocities and accelerations: motion along guides, derivatives of position
// functions, transmission angles, strokes.
#include "calculators/mechanism/cycle/point_motion.hpp"
#include "calculators/mechanism/input/points.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "lib/mechanism/groups/closing.hpp"
#include "lib/mechanism/model/point_motion.hpp"
#include "lib/mechanism/studies/relative_motion.hpp"

#include <algorithm>
#include <array>

namespace loadpath::planar {

namespace {

using mechanism::Position;
using mechanism::RelativeMotion;
using mechanism::Stroke;
using mechanism::Vec;

/// A slot or a slide.
struct Guide {
  std::string name;
  mechanism::Joint joint;
  [[nodiscard]] RelativeMotion now(const Position& p) const { return relative_motion(joint, p); }
};

constexpr std::array guide_rows{
    row<Guide>(
        "joints.NAME.s", "position of the pin along the guide, from the second link's point", mm,
        [](const Guide&, const RelativeMotion& m) { return m.s; }, nullptr, "slots and slides"),
    row<Guide>(
        "joints.NAME.v_r", "relative velocity, along the guide", m_per_s,
        [](const Guide&, const RelativeMotion& m) { return m.s_dot; }, nullptr, "slots and slides"),
    row<Guide>(
        "joints.NAME.a_r", "relative acceleration, along the guide", m_per_s2,
        [](const Guide&, const RelativeMotion& m) { return m.s_ddot; }, nullptr, "slots and slides"),
    row<Guide>(
        "joints.NAME.a_C", "Coriolis acceleration, across the guide, positive to its left", m_per_s2,
        [](const Guide&, const RelativeMotion& m) { return mechanism::dot(m.a_C, mechanism::normal(m.along)); },
        nullptr, "slots and slides")};

/// A link's turning with the crank.
struct TurnedLink {
  std::string name;
  std::size_t index;
  [[nodiscard]] const Position* now(const Reached& reached) const { return reached.derivative; }
};

constexpr std::array turned_link_rows{
    row<TurnedLink>(
        "links.NAME.dphi", "first derivative of the angle with respect to the crank angle: omega over the crank's",
        ratio, {.detail = true},
        [](const TurnedLink& l, const Position* const& d) { return d == nullptr ? none : d->velocity[l.index].phi; },
        nullptr, "with a crank as the only drive"),
    row<TurnedLink>(
        "links.NAME.d2phi", "second derivative of the angle with respect to the crank angle", ratio, {.detail = true},
        [](const TurnedLink& l, const Position* const& d) {
          return d == nullptr ? none : d->acceleration[l.index].phi;
        },
        nullptr, "with a crank as the only drive")};

/// A point's motion with the crank.
struct CarriedPoint {
  std::string name;
  TracedPoint traced;
  [[nodiscard]] Vec now(const Reached& reached) const {
    if (reached.derivative == nullptr) return {none, none};
    return motion_of(*reached.derivative, traced.link, traced.at).velocity;
  }
};

constexpr std::array carried_point_rows{
    row<CarriedPoint>(
        "points.NAME.dx", "first derivative of x with respect to the crank angle, per rad", mm, {.detail = true},
        [](const CarriedPoint&, const Vec& d) { return d.x; }, nullptr, "with a crank as the only drive"),
    row<CarriedPoint>(
        "points.NAME.dy", "first derivative of y with respect to the crank angle, per rad", mm, {.detail = true},
        [](const CarriedPoint&, const Vec& d) { return d.y; }, nullptr, "with a crank as the only drive")};

constexpr Declaration gamma =
    declare("joints.NAME.gamma", "transmission angle, 90° is best", deg,
            "the inner joint of a dyad with two assemblies", {.kind = Kind::transmission_angle});
constexpr Declaration swing = declare("links.NAME.swing", "angle between the extreme positions of the cycle", deg,
                                      "with one drive, over a cycle", {.detail = true});
constexpr Declaration stroke = declare("joints.NAME.stroke", "distance between the extreme positions of the cycle", mm,
                                       "slots and slides with one drive, over a cycle");

void add_transmission(const mechanism::Model& model, std::vector<Output>& out) {
  mechanism::Model joints;  // the readers need no more of it
  joints.joints = model.joints;
  for (const mechanism::DyadClosing& dyad : dyad_closings(model, plan_of(model))) {
    const auto read = [joints, dyad](const Position& p) {
      return transmission_angle(closing_angle(joints, dyad, p.pose));
    };
    out.push_back(output(gamma, model.joints[dyad.joint].name));
    out.back().read = read;
  }
}

/// Only for the full cycle: parts of one would give parts of a stroke.
std::vector<double> range_of(const Kinematics& kinematics, Stroke::Of of, std::size_t index) {
  if (std::find(kinematics.known.begin(), kinematics.known.end(), false) != kinematics.known.end()) return {none};
  for (const Stroke& s : kinematics.strokes) {
    if (s.of == of && s.index == index) return {s.range};
  }
  return {0.0};
}

void add_range(const Declaration& what, const std::string& name, Stroke::Of of, std::size_t index,
               std::vector<Output>& out) {
  out.push_back(output(what, name));
  out.back().is_single = true;
  out.back().read_cycle = [of, index](const Solved& solved) { return range_of(solved.kinematics, of, index); };
}

void add_ranges(const mechanism::Model& model, std::vector<Output>& out) {
  for (std::size_t k = 0; k < model.links.size(); ++k) add_range(swing, model.links[k].name, Stroke::Of::link, k, out);
  for (std::size_t n = 0; n < model.joints.size(); ++n) {
    if (is_guided(model.joints[n])) add_range(stroke, model.joints[n].name, Stroke::Of::guide, n, out);
  }
}

void add_kinematics(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out) {
  for (const mechanism::Joint& joint : model.joints) {
    if (is_guided(joint)) add_outputs(Guide{joint.name, joint}, guide_rows, out);
  }
  add_transmission(model, out);
  if (model.drivers.size() != 1) return;
  if (model.drivers[0].kind == mechanism::Driver::Kind::rotary) {
    for (std::size_t k = 0; k < model.links.size(); ++k)
      add_outputs(TurnedLink{model.links[k].name, k}, turned_link_rows, out);
    for (const TracedPoint& point : traced_points(in))
      add_outputs(CarriedPoint{point.name, point}, carried_point_rows, out);
  }
  if (!axis_name(in).empty() && !has_law(in)) add_ranges(model, out);
}

void list_kinematics(std::vector<ResultPattern>& patterns) {
  list_patterns(guide_rows, patterns);
  patterns.push_back(gamma.pattern);
  list_patterns(turned_link_rows, patterns);
  list_patterns(carried_point_rows, patterns);
  patterns.push_back(swing.pattern);
  patterns.push_back(stroke.pattern);
}

}  // namespace

constinit const Aspect aspects::kinematics{.list = &list_kinematics, .add_outputs = &add_kinematics};

}  // namespace loadpath::planar
