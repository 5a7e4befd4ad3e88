#include "calculators/mechanism/proof/redundancy.hpp"

#include "lib/mechanism/structure/release.hpp"

#include <algorithm>
#include <limits>

namespace loadpath::planar {

std::vector<account::Verdict> redundancies(const std::string& step, const mechanism::Model& model,
                                           const mechanism::Structure& structure) {
  std::vector<account::Verdict> verdicts;
  for (const auto& [joints, freedoms] : mechanism::shared_freedoms(structure)) {
    account::Verdict v;
    v.step = step;
    v.symbol = "determinate";
    v.meaning = say("equilibrium of rigid links alone decides every reaction");
    v.bound = say("no joint holds too much");
    v.value = say("shared by {1} joints", std::to_string(joints.size()));
    v.state = account::State::not_covered;
    v.note = say("{1}: what they share depends on play and elasticity", mechanism::too_many(model, joints, freedoms));
    verdicts.push_back(std::move(v));
  }
  return verdicts;
}

account::Table uniqueness_table(const mechanism::Model& model, const Cycle& cycle) {
  account::Table table{
      say("Reactions that equilibrium alone decides"), {say("joint"), say("force"), say("couple")}, {}};
  const auto word = [](bool unique) { return unique ? say("unique") : say("not unique"); };
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const mechanism::JointKind kind = model.joints[k].kind;
    const bool turns = kind != mechanism::JointKind::prismatic && kind != mechanism::JointKind::rigid;
    table.rows.push_back({model.joints[k].name, word(cycle.unique[k].force),
                          turns ? account::Cell(std::string("–")) : account::Cell(word(cycle.unique[k].couple))});
  }
  return table;
}

static void hide(const std::vector<mechanism::Uniqueness>& unique, mechanism::Position& p) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < p.reactions.size(); ++k) {
    if (!unique[k].force) p.reactions[k].force = {none, none};
    if (!unique[k].couple) p.reactions[k].couple = none;
  }
}

void hide_what_is_not_unique(Cycle& cycle) {
  for (mechanism::Position& p : cycle.positions) hide(cycle.unique, p);
  for (auto& ways : cycle.either_way) {
    for (mechanism::Position& way : ways) hide(cycle.unique, way);
  }
}

mechanism::Model determinate(const mechanism::Model& model, const Cycle& cycle) {
  const auto closed = std::find(cycle.closed.begin(), cycle.closed.end(), true) - cycle.closed.begin();
  if (static_cast<std::size_t>(closed) == cycle.closed.size()) return model;
  return mechanism::release(model, cycle.positions[static_cast<std::size_t>(closed)].pose).value_or(model);
}

}  // namespace loadpath::planar
