// Contact forces of joints: edges of guides, teeth, rolling wheels, spans of belts; their friction.
#include "calculators/mechanism/cycle/rounding.hpp"
#include "calculators/mechanism/parts/losses.hpp"
#include "calculators/mechanism/parts/wheels.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "lib/mechanism/model/frames.hpp"

#include <array>
#include <cmath>
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
        {.tabled = Tabled::always, .is_load = true}, [](const Guide&, const Guide::Pressure& at) { return at.N; },
        nullptr, "prismatic joints"),
    row<Guide>(
        "joints.NAME.h", "point of action of that force: distance from the first link's point, along the guide", mm,
        {.missing = "where there is none, the guide carries only a couple, or nothing"},
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

struct Rubbing {
  std::string name;
  std::size_t index = 0;
  std::shared_ptr<const mechanism::Model> model;
};

constexpr std::array rubbing_rows{row<Rubbing>(
    "joints.NAME.P_loss", "power loss by friction or meshing", W, {.kind = Kind::joint_loss},
    [](const Rubbing& r, const Position& p) { return loss_of(*r.model, r.index, p); }, nullptr,
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
    if (rubs(joint)) add_outputs(Rubbing{joint.name, k, kept}, rubbing_rows, out);
  }
}

}  // namespace

constinit const Aspect aspects::contacts{.list = &list_contacts, .add_outputs = &add_contacts};

}  // namespace loadpath::planar
