#include "lib/mechanism/studies/causes.hpp"

#include "lib/mechanism/equations/kinetostatics.hpp"
#include "lib/mechanism/forces/induced_source.hpp"

namespace loadpath::mechanism {

CauseSplit::CauseSplit(const Model& model)
    : instant_(model), motions_(instant_), induced_(model.joints.size()), multipliers_(instant_.constraints().rows()) {
  causes_.push_back({Cause::Kind::weights});
  for (std::size_t k = 0; k < model.links.size(); ++k) causes_.push_back({Cause::Kind::inertia, k});
  first_load_ = causes_.size();
  for (std::size_t k = 0; k < model.loads.size(); ++k) causes_.push_back({Cause::Kind::load, k});
  first_spring_ = causes_.size();
  for (std::size_t k = 0; k < model.springs.size(); ++k) causes_.push_back({Cause::Kind::spring, k});
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    induced_[k] = causes_.size();
    if (modes_of(model.joints[k]) > 0) causes_.push_back({Cause::Kind::induced, k});
  }
  shares_.assign(causes_.size(), blank_forces(model));
}

std::size_t CauseSplit::cause_of(const ActiveForce& force) const {
  switch (force.kind) {
    case ActiveForce::Kind::weight:
      return 0;
    case ActiveForce::Kind::inertia:
      return 1 + force.index;
    case ActiveForce::Kind::load:
      return first_load_ + force.index;
    case ActiveForce::Kind::spring:
      return first_spring_ + force.index;
    case ActiveForce::Kind::induced:
      break;
  }
  return induced_[force.index];
}

bool CauseSplit::find(const Position& at, bool statics) {
  instant_.take(at, statics);
  if (instant_.is_singular()) return false;
  motions_.find(instant_);
  for (std::size_t cause = 0; cause < causes_.size(); ++cause) find_share(cause);
  return true;
}

// Each component from the power of the cause when only its constraint is released.
void CauseSplit::find_share(std::size_t cause) {
  const double length = instant_.length();
  Forces& share = shares_[cause];
  for (double& multiplier : multipliers_) multiplier = 0.0;
  for (const ActiveForce& force : instant_.active()) {
    if (cause_of(force) != cause) continue;
    for (std::size_t row = 0; row < multipliers_.size(); ++row) {
      multipliers_[row] -= power(force, motions_.velocity(row, force.link)) / (length * length);
    }
  }
  share_out(instant_.model(), instant_.constraints(), multipliers_, length, share.reactions, share.effort);
  if (causes_[cause].kind != Cause::Kind::induced) return;
  const std::size_t joint = causes_[cause].index;
  share.reactions[joint] = share.reactions[joint] + instant_.unconstrained_reaction(joint);
}

}  // namespace loadpath::mechanism
