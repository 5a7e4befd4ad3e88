#include "lib/mechanism/proof/instant.hpp"

#include "lib/mechanism/forces/induced.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace loadpath::mechanism {
namespace {

// Equations beyond which the inverse is found column by column: elimination of a full matrix takes the cube of them.
constexpr std::size_t most_dense = 300;

using Row = Eigen::Vector3d;  // a force and a couple in units of length

/// The part of a reaction that is square to the forces of the joint's constraints.
Reaction beside(const Pair& pair, const Reaction& reaction, double length) {
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
      constraints_(in_unit_of_length(model, length_)),
      q_(3 * (model.links.size() + 1)),  // the ground's stay zero
      no_targets_(model.drivers.size()),
      beside_(model.joints.size()),
      inverse_(constraints_.rows()),
      column_sums_(constraints_.columns()),
      motions_(constraints_.rows() * constraints_.columns()) {
  if (constraints_.rows() > most_dense) factors_.emplace(constraints_.columns(), constraints_.pattern());
  active_.reserve(2 * model.links.size() + model.loads.size() + 2 * model.springs.size() + 2 * model.joints.size());
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
  for (std::size_t k = 0; k < beside_.size(); ++k) {
    const Joint& joint = model_->joints[k];
    if (modes_of(joint) == 0) continue;
    beside_[k] = beside(constraints_.pairs()[k], at_->reactions[k], length_);
    add_induced(joint.i, k, beside_[k], 1.0);
    add_induced(joint.j, k, beside_[k], -1.0);
  }
}

void Instant::add_induced(int link, std::size_t joint, const Reaction& acting, double sense) {
  if (link == ground) return;
  const auto k = static_cast<std::size_t>(link);
  const Vec arm = acting.at - Vec{at_->pose[k].x, at_->pose[k].y};
  active_.push_back({ActiveForce::Kind::induced, joint, k, arm, sense * acting.force, sense * acting.couple});
}

void Instant::find_motions() {
  const double norm = factors_ ? invert_sparse() : invert_dense();
  const std::size_t size = constraints_.rows();
  condition_ = size == 0 ? 1.0 : norm * largest_row_sum(motions_, size);
}

/// Column after column. The 1-norm of the Jacobian, NaN where it is singular.
double Instant::invert_sparse() {
  const std::size_t size = constraints_.rows();
  if (!factors_->factor(constraints_.jacobian())) return std::numeric_limits<double>::quiet_NaN();
  std::ranges::fill(motions_, 0.0);
  for (std::size_t row = 0; row < size; ++row) {
    const auto column = std::span(motions_).subspan(row * size, size);
    column[row] = 1.0;
    factors_->solve(column);
  }
  std::ranges::fill(column_sums_, 0.0);
  const auto pattern = constraints_.pattern();
  for (std::size_t n = 0; n < pattern.size(); ++n)
    column_sums_[static_cast<std::size_t>(pattern[n].column)] += std::abs(constraints_.jacobian()[n]);
  return *std::ranges::max_element(column_sums_);
}

/// Column after column, so that the largest sums of columns, the 1-norms, are those of what the inverse takes for rows.
double Instant::invert_dense() {
  const std::size_t size = constraints_.rows();
  std::ranges::fill(motions_, 0.0);
  const auto pattern = constraints_.pattern();
  for (std::size_t n = 0; n < pattern.size(); ++n) {
    const auto row = static_cast<std::size_t>(pattern[n].row), column = static_cast<std::size_t>(pattern[n].column);
    motions_[column * size + row] = constraints_.jacobian()[n];
  }
  const double norm = largest_row_sum(motions_, size);
  inverse_.invert(motions_);
  return norm;
}

double Instant::effort_arm(std::size_t driver) const {
  return model_->drivers[driver].kind == Driver::Kind::rotary ? length_ : 1.0;
}

double Instant::virtual_power(std::size_t row) const {
  double sum = 0.0;
  for (const ActiveForce& active : active_) sum += power(active, virtual_velocity(row, active.link));
  return sum;
}

}  // namespace loadpath::mechanism
