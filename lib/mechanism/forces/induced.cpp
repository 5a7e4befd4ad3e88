#include "lib/mechanism/forces/induced.hpp"

#include "lib/mechanism/equations/kinematics.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::mechanism {

InducedForces::InducedForces(const Model& model) : model_(model), size_(characteristic_length(model)) {
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const Joint& joint = model.joints[k];
    const std::size_t count = modes_of(joint);
    if (count == 0) continue;
    sources_.push_back({.joint = k, .first = modes_.size(), .shape = shape_of(joint)});
    modes_.resize(modes_.size() + count, {.joint = k, .at = {}, .force = {}});
    if (rubs(joint)) parts_ = 4;
  }
  for (auto* x : {&amounts_, &induced_, &before_}) x->resize(modes_.size());
  newton_ = SmallLu(modes_.size());
}

void InducedForces::start(const Position& at, Resting resting) {
  std::ranges::fill(amounts_, 0.0);
  const RestLimits slow = limits(at);
  some_rest_ = false;
  for (InducedSource& source : sources_) {
    const Joint& joint = model_.joints[source.joint];
    set_up(joint, at.pose, at.velocity, source);
    set_modes(joint, source, std::span(modes_).subspan(source.first));
    if (!rubs(joint)) continue;
    source.tendency = tendency_of(joint, source, at, Resting::without_friction, slow);
    const bool at_rest = rests(model_.joints[source.joint], source);
    some_rest_ = some_rest_ || at_rest;
    if (at_rest && resting != Resting::without_friction)
      source.tendency = tendency_of(joint, source, at, resting, slow);
  }
}

RestLimits InducedForces::limits(const Position& at) const {
  constexpr double rounding = 1e-9;
  const auto fastest = [this](const std::vector<Pose>& rates) {
    double most = 0.0;
    for (const Pose& rate : rates)
      most = std::max({most, std::abs(rate.phi), std::abs(rate.x) / size_, std::abs(rate.y) / size_});
    return rounding * most;
  };
  const double omega = fastest(at.tendency), epsilon = fastest(at.acceleration);
  return {size_ * omega, omega, size_ * epsilon, epsilon};
}

void InducedForces::induce(const Position& at, double share) {
  for (const InducedSource& source : sources_) {
    mechanism::induce(model_.joints[source.joint], source, at.reactions[source.joint], share,
                      std::span(induced_).subspan(source.first));
  }
}

double InducedForces::largest_force(const Position& at) {
  double most = 1e-300;
  for (const Reaction& reaction : at.reactions)
    most = std::max({most, std::abs(reaction.force.x), std::abs(reaction.force.y)});
  return most;
}

bool InducedForces::is_settled(const Position& at) const {
  const double rounding = 1e-15 * largest_force(at);
  for (std::size_t m = 0; m < amounts_.size(); ++m) {
    if (!(std::abs(amounts_[m] - induced_[m]) <= rounding + 1e-13 * std::abs(amounts_[m]))) return false;
  }
  return true;
}

bool InducedForces::step() {
  if (!newton_.factor() || newton_.sign() < 0.0) return false;
  for (std::size_t m = 0; m < amounts_.size(); ++m) before_[m] = amounts_[m] - before_[m];
  newton_.solve(before_);
  for (std::size_t m = 0; m < amounts_.size(); ++m) amounts_[m] -= before_[m];
  return true;
}

void InducedForces::add_to(Position& at) const {
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    Reaction& reaction = at.reactions[modes_[m].joint];
    reaction.force = reaction.force + amounts_[m] * modes_[m].force;
    reaction.couple += amounts_[m] * modes_[m].couple;
  }
}

}  // namespace loadpath::mechanism
