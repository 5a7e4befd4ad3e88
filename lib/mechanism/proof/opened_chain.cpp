#include "lib/mechanism/proof/opened_chain.hpp"

#include <Eigen/Dense>

#include <algorithm>

namespace loadpath::mechanism {
namespace {

using Triple = Eigen::Vector3d;  // force and moment; or velocity of the common point and angular speed
using View = Eigen::Map<const Triple>;

std::size_t rows_of(const Pair& pair) { return static_cast<std::size_t>(constraint_count(pair.kind)); }

/// Motions in which a joint with these forces does no work: about a pin, along a guide; with one force both.
struct Freedoms {
  std::size_t count;
  Triple motion[2];
};

Freedoms freedoms(const Triple& force, const Triple* second) {
  if (second != nullptr) return {1, {force.cross(*second).normalized(), {}}};
  const Triple along = Triple(-force[1], force[0], 0.0).normalized();
  return {2, {along, force.cross(along).normalized()}};
}

Vec place(std::span<const double> q, std::size_t link) { return {q[3 * link], q[3 * link + 1]}; }

/// From the origin of the first link, about which all moments are taken.
Vec from_reference(std::span<const double> q, std::size_t link) { return place(q, link) - place(q, 0); }

Reaction reaction_at(Vec at, const Triple& force, Vec reference, double length) {
  const Vec f{force[0], force[1]};
  return {length * at, f, length * (force[2] - cross(at - reference, f))};
}

}  // namespace

OpenedChain::OpenedChain(const Instant& instant)
    : links_(instant.model().links.size()), rows_(instant.constraints().rows()), acting_(3 * links_ * (rows_ + 1)) {
  const Constraints& constraints = instant.constraints();
  grow_tree(instant.model(), constraints);
  for (const std::size_t joint : opened_) {
    const Pair& pair = constraints.pairs()[joint];
    for (std::size_t n = 0; n < rows_of(pair); ++n) unknowns_.push_back(pair.row + n);
  }
  for (std::size_t row = constraints.first_driver_row(); row < rows_; ++row) unknowns_.push_back(row);
  on_part_.resize(3 * links_ * (unknowns_.size() + 1));
  forces_.resize(unknowns_.size());
}

void OpenedChain::grow_tree(const Model& model, const Constraints& constraints) {
  std::vector<bool> attached(links_ + 1, false), used(model.joints.size(), false);
  attached[links_] = true;  // the ground
  for (std::size_t grown = 0; grown < links_; ++grown) {
    std::size_t best = used.size();
    for (std::size_t k = 0; k < used.size(); ++k) {
      const Pair& pair = constraints.pairs()[k];
      if (attached[pair.i] == attached[pair.j]) continue;
      if (best == used.size() || rows_of(pair) > rows_of(constraints.pairs()[best])) best = k;
    }
    if (best == used.size()) break;
    const Pair& pair = constraints.pairs()[best];
    branches_.push_back(attached[pair.i] ? Branch{pair.j, pair.i, best} : Branch{pair.i, pair.j, best});
    attached[branches_.back().link] = used[best] = true;
  }
  for (std::size_t k = 0; k < used.size(); ++k) {
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
  find_actions(instant);
  sum_up_parts();
  solve(instant.constraints());
  find_reactions(instant, forces);
}

void OpenedChain::find_actions(const Instant& instant) {
  std::ranges::fill(acting_, 0.0);
  add_constraints(instant);
  add_active_forces(instant);
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

void OpenedChain::solve(const Constraints& constraints) {
  const auto size = static_cast<Eigen::Index>(unknowns_.size());
  if (size == 0) return;
  Eigen::MatrixXd moments(size, size);
  Eigen::VectorXd active(size);
  Eigen::Index equation = 0;
  for (const Branch& branch : branches_) {
    const Pair& pair = constraints.pairs()[branch.joint];
    const Triple first = View(acting(branch.link, pair.row));
    const Triple second = View(acting(branch.link, std::min(pair.row + 1, rows_)));
    const Freedoms free = freedoms(first, rows_of(pair) == 2 ? &second : nullptr);
    for (std::size_t n = 0; n < free.count; ++n, ++equation) {
      for (std::size_t u = 0; u < unknowns_.size(); ++u) {
        moments(equation, static_cast<Eigen::Index>(u)) = free.motion[n].dot(View(on_part(branch.link, u)));
      }
      active[equation] = free.motion[n].dot(View(on_part(branch.link, unknowns_.size())));
    }
  }
  Eigen::Map<Eigen::VectorXd>(forces_.data(), size) = moments.partialPivLu().solve(-active);
}

void OpenedChain::find_reactions(const Instant& instant, Forces& forces) const {
  const Constraints& constraints = instant.constraints();
  const Vec reference = place(instant.q(), 0);
  const auto store = [&](std::size_t joint, const Triple& on_link, bool on_i) {
    const Pair& pair = constraints.pairs()[joint];
    forces.reactions[joint] = reaction_at(place(instant.q(), pair.i) + pair.arm_i, on_i ? on_link : Triple(-on_link),
                                          reference, instant.length());
  };
  for (const Branch& branch : branches_) {
    Triple sum = View(on_part(branch.link, unknowns_.size()));
    for (std::size_t u = 0; u < forces_.size(); ++u) sum += forces_[u] * View(on_part(branch.link, u));
    store(branch.joint, -sum, constraints.pairs()[branch.joint].i == branch.link);
  }
  std::size_t u = 0;
  for (const std::size_t joint : opened_) {
    const Pair& pair = constraints.pairs()[joint];
    const bool on_i = pair.i != links_;
    Triple sum = Triple::Zero();
    for (std::size_t n = 0; n < rows_of(pair); ++n)
      sum += forces_[u++] * View(acting(on_i ? pair.i : pair.j, pair.row + n));
    store(joint, sum, on_i);
  }
  for (std::size_t k = 0; k < forces.effort.size(); ++k) {
    const bool rotary = instant.model().drivers[k].kind == Driver::Kind::rotary;
    forces.effort[k] = (rotary ? instant.length() : 1.0) * forces_[u++];
  }
}

}  // namespace loadpath::mechanism
