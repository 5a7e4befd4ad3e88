#include "lib/mechanism/proof/instant.hpp"

#include "lib/mechanism/forces/induced.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::mechanism {
namespace {

using Row = Eigen::Vector3d;  // a force and a couple in units of length

/// The part of a reaction that is square to the forces of the joint's constraints.
Reaction unconstrained_part(const Pair& pair, const Reaction& reaction, double length) {
  Row left(reaction.force.x, reaction.force.y, reaction.couple / length);
  std::array<Row, 3> rows;
  for (std::size_t r = 0; r < pair.shape.rows(); ++r) {
    const PairRow& row = pair.at.rows[r];
    rows[r] = {row.e.x, row.e.y, row.m};
    for (std::size_t n = 0; n < r; ++n) rows[r] -= rows[n].dot(rows[r]) * rows[n];
    rows[r].normalize();
    left -= rows[r].dot(left) * rows[r];
  }
  return {reaction.at, {left[0], left[1]}, length * left[2]};
}

}  // namespace

Instant::Instant(const Model& model)
    : model_(&model),
      has_wheels_(std::ranges::any_of(model.joints, [](const Joint& joint) { return joint.radius_i != 0.0; })),
      length_(characteristic_length(model)),
      scaled_(in_unit_of_length(model, length_)),
      constraints_(scaled_),
      q_(3 * (model.links.size() + 1)),  // the ground's stay zero
      no_targets_(model.drivers.size()),
      unconstrained_(model.joints.size()),
      inverse_(constraints_, groups(model)),
      rates_(constraints_.rows()),
      motions_(model.drivers.size() * constraints_.columns()) {
  active_.reserve(2 * model.links.size() + model.loads.size() + 2 * model.springs.size() + 2 * model.joints.size());
}

void Instant::take_dimensions(const Model& model) {
  model_ = &model;
  length_ = characteristic_length(model);
  scaled_ = model;
  change_unit_of_length(scaled_, length_);
  constraints_.take_dimensions(scaled_);
}

void Instant::take(const Position& at, bool statics) {
  take_forces(at, statics);
  find_motions();
}

void Instant::take_forces(const Position& at, bool statics) {
  at_ = &at;
  statics_ = statics;
  for (std::size_t k = 0; k < at.pose.size(); ++k) {
    q_[3 * k] = at.pose[k].x / length_;
    q_[3 * k + 1] = at.pose[k].y / length_;
    q_[3 * k + 2] = at.pose[k].phi;
  }
  place();
  find_active_forces(*model_, at, statics, active_);
  find_induced_forces();
}

void Instant::place() {
  constraints_.place(q_, no_targets_);
  if (!has_wheels_) return;
  constraints_.count_turns();
  constraints_.place(q_, no_targets_);
}

void Instant::find_induced_forces() {
  external_ = active_.size();
  for (std::size_t k = 0; k < unconstrained_.size(); ++k) {
    const Joint& joint = model_->joints[k];
    if (modes_of(joint) == 0) continue;
    unconstrained_[k] = unconstrained_part(constraints_.pairs()[k], at_->reactions[k], length_);
    add_induced(joint.i, k, unconstrained_[k], 1.0);
    add_induced(joint.j, k, unconstrained_[k], -1.0);
  }
}

void Instant::add_induced(int link, std::size_t joint, const Reaction& acting, double sense) {
  if (link == ground) return;
  const auto k = static_cast<std::size_t>(link);
  const Vec arm = acting.at - Vec{at_->pose[k].x, at_->pose[k].y};
  active_.push_back({ActiveForce::Kind::induced, joint, k, arm, sense * acting.force, sense * acting.couple});
}

void Instant::find_motions() {
  inverse_.invert(constraints_);
  condition_ = inverse_.condition();
  const std::size_t size = constraints_.columns();
  for (std::size_t k = 0; k < model_->drivers.size(); ++k) {
    std::ranges::fill(rates_, 0.0);
    rates_[constraints_.first_driver_row() + k] = 1.0;
    inverse_.find_motion(rates_, std::span(motions_).subspan(k * size, size));
  }
}

double Instant::effort_arm(std::size_t driver) const {
  return model_->drivers[driver].kind == Driver::Kind::rotary ? length_ : 1.0;
}

double Instant::virtual_power(std::size_t driver) const {
  double sum = 0.0;
  for (const ActiveForce& active : active_) sum += power(active, virtual_velocity(driver, active.link));
  return sum;
}

}  // namespace loadpath::mechanism
