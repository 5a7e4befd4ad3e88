#include "lib/mechanism/studies/group_jacobian.hpp"

#include "lib/mechanism/equations/kinematics.hpp"
#include "lib/mechanism/model/pair.hpp"

#include <cmath>

namespace loadpath::mechanism {
namespace {

/// Lengths among the equations of a cut: all but those that hold an angle.
int lengths_of(const PairShape& shape) {
  int lengths = 0;
  for (std::size_t row = 0; row < shape.rows(); ++row) {
    const RowPattern pattern = pattern_of(shape, row);
    if (pattern.x || pattern.y) ++lengths;
  }
  return lengths;
}

}  // namespace

GroupJacobians::GroupJacobians(const Model& model)
    : plan_(plan_of(model)), positions_(plan_, characteristic_length(model)) {}

void GroupJacobians::take(std::span<const Pose> poses) { positions_.adopt(poses); }

double GroupJacobians::magnitude(std::size_t group) {
  if (plan_.groups[group].unknowns.empty()) return 1.0;
  return positions_.factor(group) ? std::abs(positions_.loops(group).determinant()) : 0.0;
}

int GroupJacobians::metres(std::size_t group) const {
  const GroupPlan& plan = plan_.groups[group];
  int metres = 0;
  for (std::size_t k = plan.first_cut; k < plan.last_cut; ++k) metres += lengths_of(plan_.cuts[k].shape);
  for (const std::size_t t : plan.unknowns) metres -= plan_.tree[t].kind == TreeJoint::Kind::slide ? 1 : 0;
  return metres;
}

}  // namespace loadpath::mechanism
