#include "calculators/mechanism/planar_kinematics.hpp"

#include "calculators/mechanism/planar_rows.hpp"
#include "lib/mechanism/closing.hpp"
#include "lib/mechanism/point_motion.hpp"
#include "lib/mechanism/position_functions.hpp"
#include "lib/mechanism/relative_motion.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace loadpath {

namespace {

using planar::named;

using mechanism::Position;
using mechanism::Stroke;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Guided {
  const char* path;
  const char* doc;
  const char* unit;
  Dimension dimension;
  double (*read)(const mechanism::RelativeMotion&);
};

const std::array<Guided, 4>& guided_rows() {
  using mechanism::RelativeMotion;
  static const std::array<Guided, 4> rows{
      {{"joints.NAME.s", "place of the pin along the guide, from the second link's point", "mm", mm.dimension(),
        [](const RelativeMotion& m) { return m.s; }},
       {"joints.NAME.v_r", "relative velocity, along the guide", "m/s", m_per_s.dimension(),
        [](const RelativeMotion& m) { return m.s_dot; }},
       {"joints.NAME.a_r", "relative acceleration, along the guide", "m/s^2", m_per_s2.dimension(),
        [](const RelativeMotion& m) { return m.s_ddot; }},
       {"joints.NAME.a_C", "Coriolis acceleration, across the guide, positive to its left", "m/s^2",
        m_per_s2.dimension(),
        [](const RelativeMotion& m) { return mechanism::dot(m.a_C, mechanism::normal(m.along)); }}}};
  return rows;
}

struct Derivative {
  const char* path;
  const char* doc;
  const char* unit;
  Dimension dimension;
  double (*of_link)(const Position&, std::size_t link);
  double (*of_point)(const Position&, const TracedPoint&);
};

double derivative_x(const Position& p, const TracedPoint& t) { return motion_of(p, t.link, t.at).velocity.x; }
double derivative_y(const Position& p, const TracedPoint& t) { return motion_of(p, t.link, t.at).velocity.y; }

const std::array<Derivative, 4>& derivative_rows() {
  static const std::array<Derivative, 4> rows{
      {{"links.NAME.dphi", "first derivative of the angle with respect to the crank angle: omega over the crank's", "-",
        ratio.dimension(), [](const Position& p, std::size_t k) { return p.velocity[k].phi; }, nullptr},
       {"links.NAME.d2phi", "second derivative of the angle with respect to the crank angle", "-", ratio.dimension(),
        [](const Position& p, std::size_t k) { return p.acceleration[k].phi; }, nullptr},
       {"points.NAME.dx", "first derivative of x with respect to the crank angle, per rad", "mm", mm.dimension(),
        nullptr, derivative_x},
       {"points.NAME.dy", "first derivative of y with respect to the crank angle, per rad", "mm", mm.dimension(),
        nullptr, derivative_y}}};
  return rows;
}

constexpr ResultPattern gamma_pattern{"joints.NAME.gamma", "deg", "transmission angle, 90 deg is best",
                                      "the inner joint of a dyad with two assemblies"};
constexpr ResultPattern swing_pattern{"links.NAME.swing", "deg", "angle between the extreme positions of the cycle",
                                      "with one drive, over a cycle"};
constexpr ResultPattern stroke_pattern{"joints.NAME.stroke", "mm", "way between the extreme places of the cycle",
                                       "slots and slides with one drive, over a cycle"};

void add_guided(const mechanism::Joint& joint, std::vector<MechanismOutput>& out) {
  for (const Guided& row : guided_rows()) {
    out.push_back({named(row.path, joint.name),
                   row.doc,
                   row.unit,
                   row.dimension,
                   [joint, read = row.read](const Position& p) { return read(relative_motion(joint, p)); },
                   {},
                   false});
  }
}

void add_transmission(const mechanism::Model& model, std::vector<MechanismOutput>& out) {
  mechanism::Model joints;  // the readers need no more of it
  joints.joints = model.joints;
  for (const mechanism::DyadClosing& dyad : dyad_closings(model, plan_of(model))) {
    const auto read = [joints, dyad](const Position& p) {
      return transmission_angle(closing_angle(joints, dyad, p.pose));
    };
    out.push_back({named(gamma_pattern.path, model.joints[dyad.joint].name),
                   gamma_pattern.doc,
                   gamma_pattern.unit,
                   deg.dimension(),
                   read,
                   {},
                   false});
  }
}

template <class Read>
void add_derivative(const Derivative& row, const std::string& name, Read read, std::vector<MechanismOutput>& out) {
  const auto over_cycle = [read](const Solved& solved) {
    const Kinematics& kinematics = solved.kinematics;
    std::vector<double> values;
    for (std::size_t k = 0; k < kinematics.known.size(); ++k)
      values.push_back(kinematics.known[k] ? read(kinematics.derivatives[k]) : none);
    return values;
  };
  out.push_back({named(row.path, name), row.doc, row.unit, row.dimension, {}, over_cycle, false});
}

void add_derivatives(const PlanarMechanism::Input& in, const mechanism::Model& model,
                     std::vector<MechanismOutput>& out) {
  for (const Derivative& row : derivative_rows()) {
    for (std::size_t k = 0; k < model.links.size() && row.of_link != nullptr; ++k)
      add_derivative(
          row, model.links[k].name, [k, read = row.of_link](const Position& p) { return read(p, k); }, out);
    if (row.of_point == nullptr) continue;
    for (const TracedPoint& point : traced_points(in))
      add_derivative(
          row, point.name, [point, read = row.of_point](const Position& p) { return read(p, point); }, out);
  }
}

/// Of the whole cycle only: parts of one would give parts of a stroke.
std::vector<double> range_of(const Kinematics& kinematics, Stroke::Of of, std::size_t index) {
  if (std::find(kinematics.known.begin(), kinematics.known.end(), false) != kinematics.known.end()) return {none};
  for (const Stroke& s : kinematics.strokes) {
    if (s.of == of && s.index == index) return {s.range};
  }
  return {0.0};
}

void add_range(const ResultPattern& pattern, const std::string& name, Stroke::Of of, std::size_t index,
               std::vector<MechanismOutput>& out) {
  const auto read = [of, index](const Solved& solved) { return range_of(solved.kinematics, of, index); };
  const Dimension dimension = of == Stroke::Of::link ? deg.dimension() : mm.dimension();
  out.push_back({named(pattern.path, name), pattern.doc, pattern.unit, dimension, {}, read, true});
}

void add_ranges(const mechanism::Model& model, std::vector<MechanismOutput>& out) {
  for (std::size_t k = 0; k < model.links.size(); ++k)
    add_range(swing_pattern, model.links[k].name, Stroke::Of::link, k, out);
  for (std::size_t n = 0; n < model.joints.size(); ++n) {
    if (is_guided(model.joints[n])) add_range(stroke_pattern, model.joints[n].name, Stroke::Of::guide, n, out);
  }
}

std::vector<std::size_t> iterated_groups(const mechanism::Plan& plan) {
  std::vector<std::size_t> groups;
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    if (plan.groups[g].closing == mechanism::Closing::by_newton) groups.push_back(g);
  }
  return groups;
}

}  // namespace

Kinematics kinematics_of(const mechanism::Model& model, const Cycle& cycle, const Axis* axis, bool goes_by_drive) {
  Kinematics kinematics;
  if (model.drivers.size() != 1) return kinematics;
  mechanism::PositionFunctions functions(model);
  kinematics.derivatives = cycle.positions;
  const auto iterated = iterated_groups(functions.plan());
  for (const std::size_t g : iterated)
    kinematics.iterated.push_back({first_link(functions.plan(), functions.plan().groups[g]), {}});
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    const mechanism::Drive& drive = cycle.drives[k][0];
    const bool uniform = drive.speed != 0.0 && drive.acceleration == 0.0 && iterated.empty();
    Position& derivative = kinematics.derivatives[k];
    if (uniform && cycle.closed[k]) divide_by_speed(derivative, drive.speed);
    kinematics.known.push_back(cycle.closed[k] && (uniform || functions.derive(derivative)));
    for (std::size_t n = 0; n < iterated.size(); ++n)
      kinematics.iterated[n].signs.push_back(kinematics.known[k] ? functions.sign(iterated[n]) : 0.0);
  }
  if (axis != nullptr && goes_by_drive)
    kinematics.strokes = strokes(model, {axis->at, axis->period, kinematics.derivatives, kinematics.known});
  return kinematics;
}

void add_kinematic_outputs(const PlanarMechanism::Input& in, const mechanism::Model& model,
                           std::vector<MechanismOutput>& out) {
  for (const mechanism::Joint& joint : model.joints) {
    if (is_guided(joint)) add_guided(joint, out);
  }
  add_transmission(model, out);
  if (model.drivers.size() != 1) return;
  if (model.drivers[0].kind == mechanism::Driver::Kind::rotary) add_derivatives(in, model, out);
  if (!axis_name(in).empty() && !has_law(in)) add_ranges(model, out);
}

std::vector<ResultPattern> kinematic_result_patterns() {
  std::vector<ResultPattern> patterns;
  for (const Guided& row : guided_rows()) patterns.push_back({row.path, row.unit, row.doc, "slots and slides"});
  patterns.push_back(gamma_pattern);
  for (const Derivative& row : derivative_rows())
    patterns.push_back({row.path, row.unit, row.doc, "with a crank as the only drive"});
  patterns.push_back(swing_pattern);
  patterns.push_back(stroke_pattern);
  return patterns;
}

}  // namespace loadpath
