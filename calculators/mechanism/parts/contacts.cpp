// Contact forces of joints: edges of guides, teeth, rolling wheels, spans of belts; their friction.
#include "calculators/mechanism/cycle/rounding.hpp"
#include "calculators/mechanism/parts/losses.hpp"
#include "calculators/mechanism/parts/wheels.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "lib/mechanism/forces/mixed_friction.hpp"
#include "lib/mechanism/model/frames.hpp"
#include "lib/mechanism/model/point_motion.hpp"
#include "lib/quantity/format.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace loadpath::planar {

namespace {

using mechanism::JointKind;
using mechanism::Position;
using mechanism::Vec;

/// Action of the first link on the second across the guide.
struct Guide {
  std::string name;
  std::size_t index = 0;
  mechanism::Joint joint;

  struct Pressure {
    double N = 0.0;  // to the left of the guide's direction
    double M = 0.0;  // at the first link's point, from the normal forces only
  };
  [[nodiscard]] Pressure now(const Position& p) const {
    const mechanism::Reaction& r = p.reactions[index];
    const Vec along = mechanism::turn(mechanism::placed_at(p, joint.j).phi + joint.direction)({1.0, 0.0});
    const double pressing = dot(r.force, normal(along)), rubbing = dot(r.force, along);
    const bool rests = std::abs(rubbing) <= 1e-9 * std::abs(pressing);  // the remainder is rounding
    const double sense = rests ? 0.0 : std::copysign(1.0, rubbing);
    const double mu = mechanism::coefficient_at(joint.friction, sliding(p, along));
    const double rubbed = sense * mu * 0.5 * joint.guide_width * pressing;
    const Rounding least = rounding_at(p);
    const double couple = r.couple - rubbed;
    return {std::abs(pressing) <= least.force ? 0.0 : -pressing, std::abs(couple) <= least.moment ? 0.0 : -couple};
  }
  static bool has_length(const Guide& g) { return g.joint.guide_length > 0.0; }

 private:
  /// Sliding velocity of the first link's point along the guide.
  [[nodiscard]] double sliding(const Position& p, Vec along) const {
    const auto placed = mechanism::placed_at(p, joint.i);
    const Vec pin = placed.origin + mechanism::turn(placed.phi)(joint.point_i);
    const auto velocity_of = [&](int link) {
      if (link == mechanism::ground) return Vec{};
      return mechanism::point_velocity(p.velocity[static_cast<std::size_t>(link)],
                                       pin - mechanism::placed_at(p, link).origin);
    };
    return dot(along, velocity_of(joint.i) - velocity_of(joint.j));
  }
};

constexpr std::array guide_rows{
    row<Guide>(
        "joints.NAME.N", "force of the first link across the guide, to its left", N,
        {.tabled = Tabled::always, .is_load = true}, [](const Guide&, const Guide::Pressure& at) { return at.N; },
        nullptr, "prismatic joints"),
    row<Guide>(
        "joints.NAME.h", "point of action of the guide force: distance from the first link's point, along the guide",
        mm, {.missing = "where there is none, the guide carries only a couple, or nothing"},
        [](const Guide&, const Guide::Pressure& at) { return at.M == 0.0   ? 0.0
                                                             : at.N == 0.0 ? none
                                                                           : at.M / at.N; },
        nullptr, "prismatic joints"),
    row<Guide>(
        "joints.NAME.N_front", "force on the front edge of the block, N/2 + M/l", N,
        {.tabled = Tabled::always, .is_load = true},
        [](const Guide& g, const Guide::Pressure& at) { return 0.5 * at.N + at.M / g.joint.guide_length; },
        &Guide::has_length, "with a guide_length"),
    row<Guide>(
        "joints.NAME.N_back", "force on its back edge, N/2 - M/l", N, {.tabled = Tabled::always, .is_load = true},
        [](const Guide& g, const Guide::Pressure& at) { return 0.5 * at.N - at.M / g.joint.guide_length; },
        &Guide::has_length, "with a guide_length")};

struct SlidingContact {
  std::string name;
  std::size_t index = 0;
  std::shared_ptr<const mechanism::Model> model;
};

constexpr std::array rubbing_rows{row<SlidingContact>(
    "joints.NAME.P_loss", "power loss by friction or meshing", W, {.kind = Kind::joint_loss},
    [](const SlidingContact& r, const Position& p) { return loss_of(*r.model, r.index, p); }, nullptr,
    "joints with friction")};

void list_contacts(std::vector<ResultPattern>& patterns) {
  list_patterns(guide_rows, patterns);
  list_wheel_patterns(patterns);
  list_patterns(rubbing_rows, patterns);
}

/// Joint by joint, to keep the results of a joint together.
void add_contacts(const Mechanism::Input&, const mechanism::Model& model, std::vector<Output>& out) {
  const auto kept = std::make_shared<const mechanism::Model>(model);
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const mechanism::Joint& joint = model.joints[k];
    if (joint.kind == JointKind::prismatic) add_outputs(Guide{joint.name, k, joint}, guide_rows, out);
    add_wheel_outputs(joint, k, out);
    if (rubs(joint)) add_outputs(SlidingContact{joint.name, k, kept}, rubbing_rows, out);
  }
}

struct Arm {
  double most = 0.0;  // m; infinite if the guide carries only a couple
  std::size_t at = 0;
};

/// Where the force passes through zero a small couple has a long arm, and presses hardly at all: there the couple is
/// divided by a tenth of the largest force.
Arm longest_arm(const Guide& guide, const Cycle& cycle) {
  constexpr double least_share = 0.1;
  double least = 0.0;
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    if (cycle.has_forces(k)) least = std::max(least, least_share * std::abs(guide.now(cycle.positions[k]).N));
  }
  Arm arm;
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    if (!cycle.has_forces(k)) continue;
    const Guide::Pressure pressure = guide.now(cycle.positions[k]);
    if (pressure.M == 0.0) continue;
    const double N = std::max(std::abs(pressure.N), least);
    const double h = N == 0.0 ? std::numeric_limits<double>::infinity() : std::abs(pressure.M) / N;
    if (h > arm.most) arm = {h, k};
  }
  return arm;
}

/// Where it is longest, and its share of the length of the block.
Message note_of(const Arm& arm, const mechanism::Joint& joint, const Axis* axis) {
  const bool has_share = joint.guide_length > 0.0 && std::isfinite(arm.most);
  const Message share =
      has_share ? say("{1} of the guide length", format_number(arm.most / joint.guide_length, 3)) : Message{};
  if (axis == nullptr || arm.most == 0.0) return share;
  const std::string place = format_quantity(axis->at[arm.at], axis->unit, 5);
  return has_share ? say("{1} at {2} ({3})", share, place, axis->name()) : say("at {1} ({2})", place, axis->name());
}

/// A force far outside the block presses its edges on opposite faces, which raises friction: [C4], 4.6.2.
void judge_arms(const Solved& solved, std::vector<account::Verdict>& verdicts) {
  const Cycle& cycle = solved.proved;
  for (std::size_t n = 0; n < solved.given.joints.size(); ++n) {
    const Length most = solved.in.joints[n].h_max;
    if (!is_set(most)) continue;
    const mechanism::Joint& joint = solved.given.joints[n];
    account::Verdict& v = verdicts.emplace_back(account::Verdict{
        .step = solved.step,
        .symbol = "arm_" + joint.name,
        .meaning = say("maximum distance of the guide force from the middle of the block, joint '{1}'", joint.name),
        .value = say("not unique"),
        .bound = say("up to {1}", format_quantity(in_si(most), "mm")),
        .state = account::State::not_covered});
    if (!cycle.unique.empty() && !(cycle.unique[n].force && cycle.unique[n].couple)) continue;
    const Arm arm = longest_arm({joint.name, n, joint}, cycle);
    if (std::isfinite(arm.most)) {
      v.value = account::Quantity{arm.most, "mm"};
    } else {
      v.value = say("a couple without a force");
    }
    v.state = account::pass_if(arm.most <= in_si(most) * (1.0 + 1e-9));
    v.note = note_of(arm, joint, solved.axis);
  }
}

}  // namespace

constinit const Aspect aspects::contacts{.list = &list_contacts, .add_outputs = &add_contacts, .judge = &judge_arms};

}  // namespace loadpath::planar
