// Closing the groups in the search for all assemblies: on a given side, or from anywhere.
#include "lib/mechanism/groups/positions.hpp"
#include "lib/mechanism/model/whole_turn.hpp"

#include <cmath>

namespace loadpath::mechanism {

void GroupPositions::aim(std::span<const Drive> drives) {
  least_sine_ = 0.0;
  for (std::size_t d = 0; d < drives.size(); ++d) target_[d] = drives[d].coordinate;
  for (std::size_t t = 0; t < plan_.tree.size(); ++t) {
    const TreeJoint& tree = plan_.tree[t];
    if (tree.driver == none) continue;
    hung_[t].value = tree.sense * (target_[tree.driver] - tree.offset);
    hung_[t].turned = turn(hung_[t].value);
  }
}

bool GroupPositions::close_on_side(std::size_t g, double branch) {
  const GroupPlan& group = plan_.groups[g];
  if (group.closing != Closing::nothing) {
    refer(group);
    if (!close_in_closed_form(group, branch)) return false;
  }
  place_tree(group);
  if (group.closing == Closing::slide_of_two_turns || group.closing == Closing::slide_of_turn) unwind(group);
  return true;
}

// The two links of a slide keep their angle, including full revolutions; a jump to the other assembly may lose them.
void GroupPositions::unwind(const GroupPlan& group) {
  const Cut& cut = plan_.cuts[group.first_cut];
  const bool turns_i = plan_.tree[group.mover_i].kind == TreeJoint::Kind::turn;
  const double turns = std::round((links_[cut.i].phi - links_[cut.j].phi - cut.shape.angle) / whole_turn);
  hung_[turns_i ? group.mover_i : group.mover_j].value -= (turns_i ? whole_turn : -whole_turn) * turns;
  place_tree(group);
}

// Newton's iteration with limited steps: it may wander, since any assembly that it finds is acceptable.
bool GroupPositions::close_from(std::size_t g, std::span<const double> start) {
  constexpr double longest_step = 0.5, exact = 1e-12;
  constexpr int most_steps = 60;
  const GroupPlan& group = plan_.groups[g];
  for (std::size_t u = 0; u < group.unknowns.size(); ++u) hung_[group.unknowns[u]].value = start[u];
  for (int k = 0; k < most_steps; ++k) {
    const double size = newton_step(g);
    if (!std::isfinite(size)) return false;
    if (size <= exact) {
      place_turned(group);
      return true;
    }
    const double back = size > longest_step ? 1.0 - longest_step / size : 0.0;
    for (std::size_t u = 0; u < group.unknowns.size(); ++u) hung_[group.unknowns[u]].value += back * step_[u];
  }
  return false;
}

}  // namespace loadpath::mechanism
