#include "calculators/mechanism/results/design.hpp"

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/cycle/rounding.hpp"
#include "calculators/mechanism/results/cams.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "calculators/mechanism/results/wheels.hpp"
#include "lib/mechanism/model/frames.hpp"
#include "lib/mechanism/model/spring.hpp"
#include "lib/mechanism/studies/member.hpp"
#include "lib/mechanism/studies/reduction.hpp"
#include "lib/mechanism/studies/shaking.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace loadpath::planar {

namespace {

using mechanism::JointKind;
using mechanism::Position;
using mechanism::Vec;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// ---- internal forces of links

mechanism::Member member_of(const Mechanism::Input& in, const mechanism::Model& model, std::size_t k) {
  mechanism::Member member = mechanism::member_of(model, k);
  const bool bar = member.length() > 0.0 && mechanism::is_uniform(model, member);
  const bool uniform = in.links[k].mass_line == planar::MassLine::uniform ||
                       (in.links[k].mass_line == planar::MassLine::automatic && bar);
  member.mass = uniform ? mechanism::MassLine::uniform : mechanism::MassLine::lumped;
  return member;
}

using mechanism::MemberLoads;

struct Bar {
  std::string name;
  std::shared_ptr<const mechanism::Model> model;
  std::shared_ptr<MemberLoads> loads;
  std::size_t index = 0;
  bool statics = false;

  [[nodiscard]] bool knows_reactions(const Position& p) const {
    const int own = static_cast<int>(index);
    for (std::size_t k = 0; k < model->joints.size(); ++k) {
      const auto& [at, force, couple] = p.reactions[k];
      const bool known = std::isfinite(force.x) && std::isfinite(couple);
      if (!known && (model->joints[k].i == own || model->joints[k].j == own)) return false;
    }
    return true;
  }
  [[nodiscard]] MemberLoads::Peaks now(const Position& p) const {
    if (!knows_reactions(p)) return {{0.0, none, none, none}, {0.0, none, none, none}, {0.0, none, none, none}};
    loads->take(p, statics);
    return loads->peaks();
  }
};

constexpr std::array bar_rows{
    row<Bar>(
        "links.NAME.N", "axial force of the largest magnitude over the link's length, tension positive", N,
        [](const Bar&, const MemberLoads::Peaks& most) { return most.N.N; }, nullptr, "links with two joints or more"),
    row<Bar>(
        "links.NAME.V", "shear force of the largest magnitude over its length", N,
        [](const Bar&, const MemberLoads::Peaks& most) { return most.V.V; }, nullptr, "links with two joints or more"),
    row<Bar>(
        "links.NAME.M_b", "bending moment of the largest magnitude over its length", N_m,
        [](const Bar&, const MemberLoads::Peaks& most) { return most.M.M; }, nullptr, "links with two joints or more")};

// ---- guides

/// What the first link does to the second across the guide.
struct Guide {
  std::string name;
  std::size_t index = 0;
  mechanism::Joint joint;

  struct Pressure {
    double N = 0.0;  // to the left of the guide's direction
    double M = 0.0;  // at the first link's point, of the pressing alone
  };
  [[nodiscard]] Pressure now(const Position& p) const {
    const mechanism::Reaction& r = p.reactions[index];
    const Vec along = mechanism::turn(mechanism::placed_at(p, joint.j).phi + joint.direction)({1.0, 0.0});
    const double pressing = dot(r.force, normal(along)), rubbing = dot(r.force, along);
    const bool rests = std::abs(rubbing) <= 1e-9 * std::abs(pressing);  // what is left then is rounding
    const double sense = rests ? 0.0 : std::copysign(1.0, rubbing);
    const double rubbed = sense * joint.friction.coefficient * 0.5 * joint.guide_width * pressing;
    const Rounding least = rounding_at(p);
    const double couple = r.couple - rubbed;
    return {std::abs(pressing) <= least.force ? 0.0 : -pressing, std::abs(couple) <= least.moment ? 0.0 : -couple};
  }
  static bool has_length(const Guide& g) { return g.joint.guide_length > 0.0; }
};

constexpr std::array guide_rows{
    row<Guide>(
        "joints.NAME.N", "force of the first link across the guide, to its left", N,
        [](const Guide&, const Guide::Pressure& at) { return at.N; }, nullptr, "prismatic joints"),
    row<Guide>(
        "joints.NAME.h", "where that force lies: distance from the first link's point, along the guide", mm,
        [](const Guide&, const Guide::Pressure& at) { return at.M == 0.0   ? 0.0
                                                             : at.N == 0.0 ? none
                                                                           : at.M / at.N; },
        nullptr, "prismatic joints"),
    row<Guide>(
        "joints.NAME.N_front", "force on the front edge of the block, N/2 + M/l", N,
        [](const Guide& g, const Guide::Pressure& at) { return 0.5 * at.N + at.M / g.joint.guide_length; },
        &Guide::has_length, "with a guide_length"),
    row<Guide>(
        "joints.NAME.N_back", "force on its back edge, N/2 - M/l", N,
        [](const Guide& g, const Guide::Pressure& at) { return 0.5 * at.N - at.M / g.joint.guide_length; },
        &Guide::has_length, "with a guide_length")};

// ---- springs

struct Elastic {
  std::string name;
  mechanism::Spring spring;
  static bool pulls(const Elastic& e) { return e.spring.kind == mechanism::Spring::Kind::linear; }
  static bool turns(const Elastic& e) { return !pulls(e); }
};

constexpr std::array spring_rows{
    row<Elastic>(
        "springs.NAME.F", "force, tension positive", N,
        [](const Elastic& e, const Position& p) { return spring_now(e.spring, p).effort; }, &Elastic::pulls,
        "springs that pull"),
    row<Elastic>(
        "springs.NAME.s", "stretch beyond the length without force", mm,
        [](const Elastic& e, const Position& p) { return spring_now(e.spring, p).stretch; }, &Elastic::pulls,
        "springs that pull"),
    row<Elastic>(
        "springs.NAME.M", "moment on the second link, counter-clockwise positive", N_m,
        [](const Elastic& e, const Position& p) { return spring_now(e.spring, p).effort; }, &Elastic::turns,
        "springs that turn")};

// ---- friction

struct Rubbing {
  std::string name;
  std::size_t index = 0;
  std::shared_ptr<const mechanism::Model> model;
};

constexpr std::array rubbing_rows{row<Rubbing>(
    "joints.NAME.P_loss", "power that friction or meshing takes", W,
    [](const Rubbing& r, const Position& p) { return loss_of(*r.model, r.index, p); }, nullptr,
    "joints with friction")};

/// The mechanism as a whole.
struct Machine {
  std::string name;
  std::shared_ptr<const mechanism::Model> model;
  std::vector<std::size_t> useful;  // loads
  std::shared_ptr<mechanism::Reduction> reduction;
  bool cranked = false, statics = false;

  static bool has_friction(const Machine& m) {
    return std::any_of(m.model->joints.begin(), m.model->joints.end(), [](const auto& j) { return rubs(j); });
  }
  static bool has_use(const Machine& m) { return !m.useful.empty(); }
  static bool has_crank(const Machine& m) { return m.cranked; }
  static bool shakes(const Machine& m) {
    return !m.statics &&
           std::any_of(m.model->links.begin(), m.model->links.end(), [](const auto& link) { return link.mass > 0.0; });
  }

  struct Now {
    const Position* at = nullptr;
    mechanism::Reduced reduced;  // of a machine that has a crank
    mechanism::Shaking shaking;  // of one that shakes
  };
  [[nodiscard]] Now now(const Reached& reached) const {
    Now all{&reached.at, {}, {}};
    if (cranked) all.reduced = reduced(reached).value_or(mechanism::Reduced{none, none, none, none});
    if (shakes(*this)) all.shaking = mechanism::shaking(*model, reached.at, {});
    return all;
  }
  [[nodiscard]] std::optional<mechanism::Reduced> reduced(const Reached& reached) const {
    return reached.derivative == nullptr ? reduction->find(reached.at)
                                         : reduction->find(reached.at, *reached.derivative);
  }
};

double loss(const Machine& m, const Machine::Now& now) {
  double sum = 0.0;
  for (std::size_t k = 0; k < m.model->joints.size(); ++k) {
    if (rubs(m.model->joints[k])) sum += loss_of(*m.model, k, *now.at);
  }
  return sum;
}

double use(const Machine& m, const Machine::Now& now) {
  const Position& p = *now.at;
  double sum = 0.0;
  for (const std::size_t n : m.useful) {
    const mechanism::Load& load = m.model->loads[n];
    const mechanism::Placed frame = mechanism::placed_at(p, load.link);
    const mechanism::Speeds speed = mechanism::speeds_at(p, load.link);
    const Vec velocity = speed.origin + speed.omega * normal(frame.turned(load.point));
    sum -= dot(global_force(load, p.loads[n].force, frame.turned), velocity) + p.loads[n].moment * speed.omega;
  }
  return sum;
}

constexpr std::array machine_rows{
    row<Machine>(
        "drive.J_red", "moment of inertia of all links, reduced to the crank", kg_m2,
        [](const Machine&, const Machine::Now& now) { return now.reduced.inertia; }, &Machine::has_crank,
        "with a crank"),
    row<Machine>(
        "drive.M_red", "moment of loads, weights and springs, reduced to the crank", N_m,
        [](const Machine&, const Machine::Now& now) { return now.reduced.moment; }, &Machine::has_crank,
        "with a crank"),
    row<Machine>(
        "frame.F", "shaking force on the frame, the magnitude of -sum m a", N,
        [](const Machine&, const Machine::Now& now) { return mechanism::length(now.shaking.force); }, &Machine::shakes,
        "links with mass"),
    row<Machine>(
        "frame.x", "shaking force along x", N,
        [](const Machine&, const Machine::Now& now) { return now.shaking.force.x; }, &Machine::shakes,
        "links with mass"),
    row<Machine>(
        "frame.y", "shaking force along y", N,
        [](const Machine&, const Machine::Now& now) { return now.shaking.force.y; }, &Machine::shakes,
        "links with mass"),
    row<Machine>(
        "frame.M", "shaking moment on the frame about the global origin", N_m,
        [](const Machine&, const Machine::Now& now) { return now.shaking.moment; }, &Machine::shakes,
        "links with mass"),
    row<Machine>("drive.P_loss", "power that friction takes in all joints", W, &loss, &Machine::has_friction,
                 "with friction"),
    row<Machine>("drive.P_useful", "power against the useful loads", W, &use, &Machine::has_use, "with useful loads")};

}  // namespace

double loss_of(const mechanism::Model& model, std::size_t k, const Position& at) {
  const mechanism::Joint& joint = model.joints[k];
  const mechanism::Reaction& r = at.reactions[k];
  const auto power_on = [&](int link) {
    const mechanism::Placed frame = mechanism::placed_at(at, link);
    const mechanism::Speeds speed = mechanism::speeds_at(at, link);
    return dot(r.force, speed.origin + speed.omega * normal(r.at - frame.origin)) + r.couple * speed.omega;
  };
  return power_on(joint.j) - power_on(joint.i);
}

/// A guide that carries a couple alone has no force whose place could be told, and says so.
static void add_guide(const Guide& guide, std::vector<Output>& out) {
  add_outputs(guide, guide_rows, out);
  const std::string path = named("joints.NAME.h", guide.name);
  const auto h = std::find_if(out.begin(), out.end(), [&](const Output& o) { return o.path == path; });
  h->missing = say("where there is none, the guide carries a couple alone, or nothing");
}

void add_design_outputs(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out) {
  const auto kept = std::make_shared<const mechanism::Model>(model);
  const bool statics = in.analysis == Mechanism::Analysis::statics;
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const mechanism::Member member = member_of(in, *kept, k);
    if (member.length() == 0.0) continue;
    const auto loads = std::make_shared<MemberLoads>(*kept, member);
    add_outputs(Bar{model.links[k].name, kept, loads, k, statics}, bar_rows, out);
  }
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const mechanism::Joint& joint = model.joints[k];
    if (joint.kind == JointKind::prismatic) add_guide(Guide{joint.name, k, joint}, out);
    add_wheel_outputs(joint, k, out);
    if (rubs(joint)) add_outputs(Rubbing{joint.name, k, kept}, rubbing_rows, out);
  }
  add_cam_outputs(model, out);
  Machine machine{"",     kept, {}, std::make_shared<mechanism::Reduction>(*kept), !in.crank.joint.empty() && !statics,
                  statics};
  for (std::size_t n = 0; n < in.loads.size(); ++n) {
    if (in.loads[n].useful == planar::Useful::yes) machine.useful.push_back(n);
  }
  add_outputs(machine, machine_rows, out);
  for (const mechanism::Spring& spring : model.springs) add_outputs(Elastic{spring.name, spring}, spring_rows, out);
}

void list_design_patterns(std::vector<ResultPattern>& patterns) {
  list_patterns(bar_rows, patterns);
  list_patterns(guide_rows, patterns);
  list_wheel_patterns(patterns);
  list_patterns(rubbing_rows, patterns);
  list_cam_patterns(patterns);
  list_patterns(machine_rows, patterns);
  list_patterns(spring_rows, patterns);
}

std::vector<FieldFault> check_mass_lines(const Mechanism::Input& in, const mechanism::Model& model) {
  std::vector<FieldFault> faults;
  for (std::size_t k = 0; k < in.links.size(); ++k) {
    if (in.links[k].mass_line != planar::MassLine::uniform) continue;
    const mechanism::Member member = mechanism::member_of(model, k);
    if (member.length() > 0.0 && mechanism::is_uniform(model, member)) continue;
    const double l = member.length(), J = model.links[k].mass * l * l / 12.0;
    faults.push_back({"links." + model.links[k].name + ".mass_line",
                      say("link '{1}' is no uniform bar of {2}: that has its mass centre in the middle and J = {3}",
                          model.links[k].name, format_quantity(l, "mm", 4), format_quantity(J, "kg*m^2", 4)),
                      say("correct S and J, or say mass_line = \"lumped\"")});
  }
  return faults;
}

}  // namespace loadpath::planar
