#include "lib/mechanism/inverse/group_inverse.hpp"

#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace loadpath::mechanism {

GroupInverse::GroupInverse(const Constraints& constraints, std::span<const Group> groups)
    : groups_(rows_of_groups(constraints, groups)),
      pattern_(constraints.pattern().begin(), constraints.pattern().end()),
      jacobian_(pattern_.size()),
      probe_(constraints.rows()),
      rates_(constraints.rows()) {
  blocks_.reserve(groups_.size());
  for (const GroupRows& group : groups_) blocks_.emplace_back(group.rows.size());
}

// Transposed, so that a row of the inverse is the motion of one constraint.
void GroupInverse::invert(const Constraints& constraints) {
  std::ranges::copy(constraints.jacobian(), jacobian_.begin());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    Block& block = blocks_[g];
    const std::size_t size = groups_[g].rows.size();
    assert(size == 3 * groups_[g].links.size());
    std::ranges::fill(block.motions, 0.0);
    for (const auto& entry : groups_[g].own) block.motions[entry.column * size + entry.row] = jacobian_[entry.place];
    block.inverse.invert(block.motions);
  }
}

void GroupInverse::find_motion(std::span<double> rates, std::span<double> motion, std::size_t first_group) const {
  std::ranges::fill(motion, 0.0);
  for (std::size_t g = first_group; g < groups_.size(); ++g) {
    const GroupRows& group = groups_[g];
    const std::size_t size = group.rows.size();
    for (const auto& entry : group.earlier) {
      rates[group.rows[entry.row]] -= jacobian_[entry.place] * motion[entry.column];
    }
    for (std::size_t n = 0; n < size; ++n) {
      const double rate = rates[group.rows[n]];
      if (rate == 0.0) continue;
      const double* of_row = &blocks_[g].motions[n * size];
      for (std::size_t c = 0; c < size; ++c) motion[3 * group.links[c / 3] + c % 3] += rate * of_row[c];
    }
  }
}

void GroupInverse::find_supply(std::span<double> acting, std::span<double> supply) const {
  for (std::size_t g = groups_.size(); g-- > 0;) {
    const GroupRows& group = groups_[g];
    const std::size_t size = group.rows.size();
    for (std::size_t n = 0; n < size; ++n) {
      const double* of_row = &blocks_[g].motions[n * size];
      double power = 0.0;
      for (std::size_t c = 0; c < size; ++c) power += of_row[c] * acting[3 * group.links[c / 3] + c % 3];
      supply[group.rows[n]] = power;
    }
    for (const auto& entry : group.earlier) {
      acting[entry.column] -= jacobian_[entry.place] * supply[group.rows[entry.row]];
    }
  }
}

double GroupInverse::condition() {
  constexpr std::size_t most_exact = 60;  // rows: the work for all columns grows with their square
  if (probe_.empty()) return 1.0;
  const double found = norm() * (probe_.size() > most_exact ? estimated_norm_of_inverse() : norm_of_inverse());
  return found < 1.0 ? 1.0 : found;  // NaN propagates
}

// Column by column: each is the motion of a constraint.
double GroupInverse::norm_of_inverse() {
  double most = 0.0;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (const std::size_t row : groups_[g].rows) {
      std::ranges::fill(rates_, 0.0);
      rates_[row] = 1.0;
      find_motion(rates_, probe_, g);
      double sum = 0.0;
      for (const double x : probe_) sum += std::abs(x);
      most = numerics::larger_magnitude(most, sum);
    }
  }
  return most;
}

double GroupInverse::estimated_norm_of_inverse() {
  const auto motion = [this](std::span<double> x) {
    std::ranges::copy(x, rates_.begin());
    find_motion(rates_, x);
  };
  const auto supply = [this](std::span<double> x) {
    std::ranges::copy(x, rates_.begin());
    find_supply(rates_, x);
  };
  return numerics::estimated_inverse_norm(probe_, motion, supply);
}

// The largest sum of a column.
double GroupInverse::norm() {
  std::ranges::fill(probe_, 0.0);
  for (std::size_t n = 0; n < pattern_.size(); ++n) {
    probe_[static_cast<std::size_t>(pattern_[n].column)] += std::abs(jacobian_[n]);
  }
  double most = 0.0;
  for (const double sum : probe_) most = numerics::larger_magnitude(most, sum);
  return most;
}

}  // namespace loadpath::mechanism
