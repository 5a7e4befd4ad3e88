#include "lib/mechanism/proof/opened_chain.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace loadpath::mechanism {
namespace {

using Triple = Eigen::Vector3d;  // force and moment; or velocity of the common point and angular speed
using View = Eigen::Map<const Triple>;

/// Motions in which a joint with these forces does no work: about a pin, along a guide; with one force both; none in a
/// rigid joint.
struct Freedoms {
  std::size_t count;
  std::array<Triple, 2> motion;
};

Freedoms freedoms(std::span<const Triple> forces) {
  if (forces.size() > 2) return {0, {}};
  if (forces.size() == 2) return {1, {forces[0].cross(forces[1]).normalized(), Triple::Zero()}};
  const Triple along = Triple(-forces[0][1], forces[0][0], 0.0).normalized();
  return {2, {along, forces[0].cross(along).normalized()}};
}

Vec place(std::span<const double> q, std::size_t link) { return {q[3 * link], q[3 * link + 1]}; }

/// From the origin of the first link, about which all moments are taken.
Vec from_reference(std::span<const double> q, std::size_t link) { return place(q, link) - place(q, 0); }

Reaction reaction_in(const Instant& instant, const Pair& pair, const Triple& on_i) {
  const Vec force{on_i[0], on_i[1]};
  const Vec from_first = pair.at.at - place(instant.q(), 0);
  return {instant.length() * pair.at.at, force, instant.length() * (on_i[2] - cross(from_first, force))};
}

}  // namespace

OpenedChain::OpenedChain(const Instant& instant)
    : links_(instant.model().links.size()), rows_(instant.constraints().rows()), acting_(3 * links_ * (rows_ + 1)) {
  const Constraints& constraints = instant.constraints();
  grow_tree(constraints);
  for (const std::size_t joint : opened_) {
    const Pair& pair = constraints.pairs()[joint];
    for (std::size_t n = 0; n < pair.shape.rows(); ++n) unknowns_.push_back(pair.row + n);
  }
  for (std::size_t row = constraints.first_driver_row(); row < rows_; ++row) unknowns_.push_back(row);
  on_part_.resize(3 * links_ * (unknowns_.size() + 1));
  forces_.resize(unknowns_.size());
  moments_.resize(forces_.size() * forces_.size());
  active_moments_.resize(forces_.size());
}

void OpenedChain::grow_tree(const Constraints& constraints) {
  const auto pairs = constraints.pairs();
  std::vector<bool> attached(links_ + 1, false), used(pairs.size(), false);
  attached[links_] = true;  // the ground
  for (std::size_t best = 0; best < pairs.size();) {
    best = pairs.size();
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (attached[pairs[k].i] == attached[pairs[k].j]) continue;
      if (best == pairs.size() || pairs[k].shape.rows() > pairs[best].shape.rows()) best = k;
    }
    if (best == pairs.size()) continue;
    const auto [i, j] = std::pair(pairs[best].i, pairs[best].j);
    branches_.push_back(attached[i] ? Branch{j, i, best} : Branch{i, j, best});
    attached[branches_.back().link] = used[best] = true;
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!used[k]) opened_.push_back(k);
  }
}

const double* OpenedChain::acting(std::size_t link, std::size_t column) const {
  return &acting_[3 * (column * links_ + link)];
}

const double* OpenedChain::on_part(std::size_t link, std::size_t column) const {
  return &on_part_[3 * (column * links_ + link)];
}

void OpenedChain::find_forces(const Instant& instant, Forces& forces) {
  std::ranges::fill(acting_, 0.0);
  add_constraints(instant);
  add_active_forces(instant);
  sum_up_parts();
  write_moments(instant.constraints());
  solve_moments();
  find_tree_reactions(instant, forces);
  find_opened_reactions(instant, forces);
  for (std::size_t k = 0; k < forces.effort.size(); ++k) {
    const double force = forces_[forces_.size() - forces.effort.size() + k];
    forces.effort[k] = instant.effort_arm(k) * force;
  }
}

// A row of the Jacobian holds, for each link, the force and the moment about its origin of a unit of the row's force.
void OpenedChain::add_constraints(const Instant& instant) {
  const auto pattern = instant.constraints().pattern();
  for (std::size_t n = 0; n < pattern.size(); ++n) {
    const auto row = static_cast<std::size_t>(pattern[n].row), column = static_cast<std::size_t>(pattern[n].column);
    const double value = instant.constraints().jacobian()[n];
    const std::size_t link = column / 3;
    const Vec origin = from_reference(instant.q(), link);
    double* on_link = &acting_[3 * (row * links_ + link)];
    on_link[column % 3] += value;
    if (column % 3 == 0) on_link[2] -= origin.y * value;
    if (column % 3 == 1) on_link[2] += origin.x * value;
  }
}

void OpenedChain::add_active_forces(const Instant& instant) {
  const double shrink = 1.0 / instant.length();
  for (const ActiveForce& active : instant.active()) {
    const Vec point = from_reference(instant.q(), active.link) + shrink * active.arm;
    double* on_link = &acting_[3 * (rows_ * links_ + active.link)];
    on_link[0] += active.force.x;
    on_link[1] += active.force.y;
    on_link[2] += cross(point, active.force) + shrink * active.couple;
  }
}

void OpenedChain::sum_up_parts() {
  for (std::size_t u = 0; u <= unknowns_.size(); ++u) {
    const std::size_t column = u < unknowns_.size() ? unknowns_[u] : rows_;
    double* part = &on_part_[3 * u * links_];
    std::copy_n(acting(0, column), 3 * links_, part);
    for (auto branch = branches_.rbegin(); branch != branches_.rend(); ++branch) {
      if (branch->parent == links_) continue;
      for (std::size_t c = 0; c < 3; ++c) part[3 * branch->parent + c] += part[3 * branch->link + c];
    }
  }
}

void OpenedChain::write_moments(const Constraints& constraints) {
  const std::size_t size = forces_.size();
  std::size_t equation = 0;
  for (const Branch& branch : branches_) {
    const Pair& pair = constraints.pairs()[branch.joint];
    std::array<Triple, 3> held;
    for (std::size_t r = 0; r < pair.shape.rows(); ++r) held[r] = View(acting(branch.link, pair.row + r));
    const Freedoms free = freedoms(std::span(held).first(pair.shape.rows()));
    for (std::size_t n = 0; n < free.count; ++n, ++equation) {
      for (std::size_t u = 0; u < size; ++u) {
        moments_[u * size + equation] = free.motion[n].dot(View(on_part(branch.link, u)));
      }
      active_moments_[equation] = free.motion[n].dot(View(on_part(branch.link, size)));
    }
  }
  assert(equation == size);
}

void OpenedChain::solve_moments() {
  const auto size = static_cast<Eigen::Index>(forces_.size());
  if (size == 0) return;
  const Eigen::Map<const Eigen::MatrixXd> moments(moments_.data(), size, size);
  const Eigen::Map<const Eigen::VectorXd> active(active_moments_.data(), size);
  Eigen::Map<Eigen::VectorXd>(forces_.data(), size) = moments.partialPivLu().solve(-active);
}

// Whatever acts on a part is held by the joint that it hangs on.
void OpenedChain::find_tree_reactions(const Instant& instant, Forces& forces) const {
  for (const Branch& branch : branches_) {
    Triple sum = View(on_part(branch.link, forces_.size()));
    for (std::size_t u = 0; u < forces_.size(); ++u) sum += forces_[u] * View(on_part(branch.link, u));
    const Pair& pair = instant.constraints().pairs()[branch.joint];
    forces.reactions[branch.joint] = reaction_in(instant, pair, pair.i == branch.link ? Triple(-sum) : sum);
  }
}

void OpenedChain::find_opened_reactions(const Instant& instant, Forces& forces) const {
  std::size_t u = 0;
  for (const std::size_t joint : opened_) {
    const Pair& pair = instant.constraints().pairs()[joint];
    const bool on_i = pair.i != links_;  // else on the ground, of which the rows hold nothing
    Triple sum = Triple::Zero();
    for (std::size_t n = 0; n < pair.shape.rows(); ++n, ++u) {
      sum += forces_[u] * View(acting(on_i ? pair.i : pair.j, pair.row + n));
    }
    forces.reactions[joint] = reaction_in(instant, pair, on_i ? sum : Triple(-sum));
  }
}

}  // namespace loadpath::mechanism
