#include "lib/mechanism/forces/induced.hpp"

#include "lib/mechanism/equations/kinematics.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::mechanism {
namespace {

void add(double amount, std::span<const Reaction> influence, std::span<Reaction> to) {
  for (std::size_t k = 0; k < to.size(); ++k) {
    to[k].force = to[k].force + amount * influence[k].force;
    to[k].couple += amount * influence[k].couple;
  }
}

}  // namespace

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
  for (auto* x : {&free_, &by_, &moved_}) x->resize(sources_.size());
  influences_.resize(modes_.size() * sources_.size());
  newton_ = numerics::SmallLu(modes_.size());
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

double InducedForces::largest(std::span<const Reaction> reactions) const {
  double most = 1e-300;
  for (const Reaction& reaction : reactions) {
    most = std::max({most, std::abs(reaction.force.x), std::abs(reaction.force.y), std::abs(reaction.couple) / size_});
  }
  return most;
}

/// The trial amount of each mode: of the size of the reactions, so that they do not drown its effect.
double InducedForces::take_free(const Position& at) {
  for (std::size_t k = 0; k < sources_.size(); ++k) free_[k] = at.reactions[sources_[k].joint];
  scale_ = largest(at.reactions);
  return scale_;
}

void InducedForces::take_influence(const Position& at, std::size_t mode) {
  const double amount = amounts_[mode];
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    const Reaction& with = at.reactions[sources_[k].joint];
    Reaction& adds = influences_[mode * sources_.size() + k];
    adds.force = (1.0 / amount) * (with.force - free_[k].force);
    adds.couple = (with.couple - free_[k].couple) / amount;
  }
}

/// Newton's iteration for amounts that induce themselves; the induced amounts are linear in them but for the signs.
bool InducedForces::find_amounts(double share) {
  constexpr int most_steps = 30;
  for (int k = 0; k < most_steps; ++k) {
    find_reactions();
    induce(by_, share);
    if (is_settled()) return true;
    fill_newton(share);
    if (!step()) return false;
  }
  return false;
}

void InducedForces::find_reactions() {
  by_ = free_;
  for (std::size_t m = 0; m < amounts_.size(); ++m) add(amounts_[m], influence(m), by_);
}

void InducedForces::induce(std::span<const Reaction> by, double share) {
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    const InducedSource& source = sources_[k];
    mechanism::induce(model_.joints[source.joint], source, by[k], share, std::span(induced_).subspan(source.first));
  }
}

bool InducedForces::is_settled() const {
  const double rounding = 1e-15 * std::max(scale_, largest(by_));
  for (std::size_t m = 0; m < amounts_.size(); ++m) {
    if (!(std::abs(amounts_[m] - induced_[m]) <= rounding + 1e-13 * std::abs(amounts_[m]))) return false;
  }
  return true;
}

/// The derivatives of the residuals of the amounts under their own induction, by finite differences.
void InducedForces::fill_newton(double share) {
  before_ = induced_;
  const double little = 1e-6 * std::max(scale_, largest(by_));
  for (std::size_t m = 0; m < amounts_.size(); ++m) {
    moved_ = by_;
    add(little, influence(m), moved_);
    induce(moved_, share);
    for (std::size_t r = 0; r < amounts_.size(); ++r) {
      newton_.at(r, m) = (r == m ? 1.0 : 0.0) - (induced_[r] - before_[r]) / little;
    }
  }
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
