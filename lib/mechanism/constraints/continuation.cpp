#include "lib/mechanism/constraints/continuation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace loadpath::mechanism {
namespace {

// Changes of a coordinate, in rad or in units of the mechanism's size.
constexpr double longest_step = 0.3;
constexpr double negligible = 1e-12;
constexpr double exact = 1e-13;
constexpr double quadratic = 1e-7;  // a Newton step as small as this leaves rounding errors only

// Relative to a predicted step: the maximum correction by Newton, so that it does not end in another assembly.
constexpr double largest_correction = 0.2;
// Relative to a move: the minimum step, and the remainder at a position that cannot be passed.
constexpr double shortest_part = 1e-9;
constexpr int most_parts = 5000;  // a move that needs more creeps along a position that it never passes
constexpr double nearly_all = 1.0 - 1e-6;

double largest(std::span<const double> x) {
  double most = 0.0;
  for (const double v : x) most = std::max(most, std::abs(v));
  return most;
}

}  // namespace

Continuation::Continuation(const Model& model)
    : constraints_(model), factors_(constraints_.columns(), constraints_.pattern()) {
  assert(constraints_.rows() == constraints_.columns());
  for (auto* x : {&q_, &base_, &start_, &first_, &second_, &newton_}) x->resize(constraints_.columns() + 3);
  for (auto* x : {&held_, &target_, &held_at_start_}) x->resize(model.drivers.size());
}

void Continuation::take_dimensions(const Model& model) {
  constraints_.take_dimensions(model);
  factors_.forget_order();
  assembled_ = false;
}

void Continuation::take_poses(const Model& model) {
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const Pose& pose = model.links[k].pose;
    q_[3 * k] = pose.x;
    q_[3 * k + 1] = pose.y;
    q_[3 * k + 2] = pose.phi;
  }
}

void Continuation::hold(const Model& model, std::span<const double> drives) {
  take_poses(model);
  std::ranges::copy(drives, held_.begin());
  target_ = held_;
  place();
  constraints_.count_turns();
  assembled_ = correct(quadratic);
}

Status Continuation::assemble(const Model& model) {
  take_poses(model);
  place();
  for (std::size_t k = 0; k < held_.size(); ++k) held_[k] = constraints_.coordinate(k);
  target_ = held_;
  const bool together = pull_together();
  assembled_ = together && correct(longest_step);
  if (assembled_) return Status::closed;
  gap_ = widest(0.0);
  return together ? Status::singular : Status::does_not_close;
}

bool Continuation::find_newton_step() {
  if (!factors_.factor(constraints_.jacobian())) return false;
  std::ranges::copy(constraints_.residual(), newton_.begin());
  factors_.solve(unknowns(newton_));
  return true;
}

// Newton's iteration with a search along each step: goes as far as the constraints permit.
bool Continuation::pull_together() {
  constexpr int most_steps = 100;
  place();
  double open = opening();
  for (int k = 0; k < most_steps; ++k) {
    if (open <= negligible * (1.0 + largest(q_))) return true;
    if (!find_newton_step() || !search_along_newton_step(open)) return false;
  }
  return false;
}

bool Continuation::search_along_newton_step(double& open) {
  constexpr double shortest = 1e-4;
  base_ = q_;
  for (double part = std::min(1.0, longest_step / largest(newton_)); part > shortest; part *= 0.5) {
    for (std::size_t k = 0; k < q_.size(); ++k) q_[k] = base_[k] - part * newton_[k];
    place();
    if (opening() < open) {
      open = opening();
      return true;
    }
  }
  q_ = base_;
  place();
  return false;
}

double Continuation::opening() const {
  double sum = 0.0;
  for (const double r : constraints_.residual()) sum += r * r;
  return std::sqrt(sum);
}

Gap Continuation::widest(double reached) const {
  Gap gap{.joint = -1, .size = 0.0, .reached = reached};
  for (std::size_t k = 0; k < constraints_.pairs().size(); ++k) {
    if (constraints_.opening(k) <= gap.size) continue;
    gap.joint = static_cast<int>(k);
    gap.size = constraints_.opening(k);
  }
  return gap;
}

Status Continuation::move(std::span<const double> goal) {
  if (!assembled_) return Status::does_not_close;
  if (std::ranges::equal(goal, held_)) return Status::closed;
  start_ = q_;
  held_at_start_ = held_;
  double reached = 0.0;
  for (int parts = 0; reached < 1.0; ++parts) {
    if (parts == most_parts) return give_up(reached, goal);
    base_ = q_;
    predict(goal);
    const double least = std::min(1.0, shortest_part / (1.0 - reached));
    double part = longest_part();
    while (part >= least && !step_to(part, goal)) part *= 0.5;
    if (part < least) return give_up(reached, goal);
    held_ = target_;
    reached = part < 1.0 ? reached + part * (1.0 - reached) : 1.0;
  }
  return Status::closed;
}

// Velocity and acceleration at the current position, for a move that would take the time 1 to the goal.
void Continuation::predict(std::span<const double> goal) {
  std::ranges::fill(first_, 0.0);
  const std::size_t row = constraints_.first_driver_row();
  for (std::size_t k = 0; k < held_.size(); ++k) first_[row + k] = goal[k] - held_[k];
  factors_.solve(unknowns(first_));
  constraints_.centripetal(first_, second_);
  factors_.solve(unknowns(second_));
}

double Continuation::longest_part() const {
  const double speed = largest(first_);
  const double bend = largest(second_);
  return std::min({1.0, longest_step / speed, bend > 0.0 ? 0.5 * speed / bend : 1.0});
}

bool Continuation::step_to(double part, std::span<const double> goal) {
  for (std::size_t k = 0; k < q_.size(); ++k) q_[k] = base_[k] + part * (first_[k] + 0.5 * part * second_[k]);
  for (std::size_t k = 0; k < held_.size(); ++k) {
    target_[k] = part < 1.0 ? held_[k] + part * (goal[k] - held_[k]) : goal[k];
  }
  return correct(largest_correction * part * largest(first_) + negligible);
}

// Ends with the factors of a matrix that differs from the one at the final coordinates by rounding only.
bool Continuation::correct(double most) {
  constexpr int most_steps = 12;
  double previous = std::numeric_limits<double>::infinity();
  for (int k = 0; k < most_steps; ++k) {
    place();
    if (!find_newton_step()) return false;
    const double size = largest(newton_);
    if (size > most) return false;
    for (std::size_t c = 0; c < q_.size(); ++c) q_[c] -= newton_[c];
    if (size <= exact || previous <= quadratic) return true;
    most = std::max(0.25 * size, quadratic);
    previous = size;
  }
  return false;
}

Status Continuation::give_up(double reached, std::span<const double> goal) {
  q_ = start_;
  std::ranges::copy(goal, target_.begin());
  const bool together = pull_together();  // then it closes there, and only the path is lost
  gap_ = widest(reached);
  q_ = start_;
  held_ = held_at_start_;
  target_ = held_;
  correct(quadratic);
  return together || reached > nearly_all ? Status::singular : Status::does_not_close;
}

}  // namespace loadpath::mechanism
