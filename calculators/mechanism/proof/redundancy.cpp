// Report of a planar mechanism with overconstrained joints: the reactions that are not unique. Those are never shown.
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/mechanism/structure/release.hpp"

#include <array>
#include <string>

namespace loadpath::planar {

namespace {

/// A line for each set of joints that hold a freedom too many.
void judge_redundancy(const Solved& solved, std::vector<account::Verdict>& verdicts) {
  for (const auto& [joints, freedoms] : mechanism::shared_freedoms(solved.structure)) {
    verdicts.push_back({.step = solved.step,
                        .symbol = "determinate",
                        .meaning = say("every reaction follows from equilibrium of rigid links"),
                        .value = say("shared by {1} joints", std::to_string(joints.size())),
                        .bound = say("no redundant constraint"),
                        .state = account::State::not_covered,
                        .note = say("{1}: the load sharing depends on clearance and elasticity",
                                    mechanism::too_many(solved.given, joints, freedoms))});
  }
}

/// For each joint whether its force and its couple are unique.
account::Table uniqueness_table(const mechanism::Model& model, const Cycle& cycle) {
  account::Table table{say("Statically determinate reactions"), {say("joint"), say("force"), say("couple")}, {}};
  const auto word = [](bool unique) { return unique ? say("unique") : say("not unique"); };
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const mechanism::JointKind kind = model.joints[k].kind;
    const bool turns = kind != mechanism::JointKind::prismatic && kind != mechanism::JointKind::rigid;
    table.rows.push_back({model.joints[k].name, word(cycle.unique[k].force),
                          turns ? account::Cell(std::string("–")) : account::Cell(word(cycle.unique[k].couple))});
  }
  return table;
}

void show_redundancy(const Solved& solved, const Results&, std::vector<account::Block>& blocks) {
  if (!solved.cycle.unique.empty()) blocks.emplace_back(uniqueness_table(solved.model, solved.cycle));
}

constexpr std::array cited{Citation{
    "Wojtyra", [](const auto&, const mechanism::Structure& structure) { return !structure.redundant.empty(); }}};

}  // namespace

constinit const Aspect aspects::redundancy{.judge = &judge_redundancy, .show = &show_redundancy, .citations = cited};

}  // namespace loadpath::planar
