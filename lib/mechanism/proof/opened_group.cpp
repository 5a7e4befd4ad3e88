#include "lib/mechanism/proof/opened_group.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace loadpath::mechanism {
namespace {

using Triple = Eigen::Vector3d;
Eigen::Map<Triple> view(Acting& acting) { return Eigen::Map<Triple>(acting.data()); }
Eigen::Map<const Triple> view(const Acting& acting) { return Eigen::Map<const Triple>(acting.data()); }

/// Motions in which a joint with these forces does no work: about a pin, along a guide; with one force both; none in a
/// rigid joint. Velocity of the common point and angular velocity.
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

void add(double* to, Vec arm, Vec force, double couple) {
  Eigen::Map<Triple>(to) += Triple(force.x, force.y, cross(arm, force) + couple);
}

/// The reaction as forces and moments about the origin of the group's first link.
Reaction reaction_in(const Instant& instant, const Pair& pair, Vec first, const Triple& on_i) {
  const Vec force{on_i[0], on_i[1]};
  return {instant.length() * pair.at.at, force, instant.length() * (on_i[2] - cross(pair.at.at - first, force))};
}

}  // namespace

OpenedGroup::OpenedGroup(const Instant& instant, const GroupRows& group)
    : group_(&group),
      links_(group.links.size()),
      rows_(group.rows.size()),
      outside_(links_),
      acting_(links_ * (rows_ + 1)),
      inverse_(0) {
  list_joinings(instant);
  grow_tree(instant.constraints());
  for (std::size_t n = rows_ - group.drivers.size(); n < rows_; ++n) unknowns_.push_back(n);
  const std::size_t size = unknowns_.size();
  on_part_.resize(links_ * (size + 1));
  inverse_ = numerics::DenseInverse(size);
  moments_.resize(size * size);
  active_moments_.resize(size);
  forces_.resize(size);
}

void OpenedGroup::list_joinings(const Instant& instant) {
  const auto place_of = [&](std::size_t link) {
    const auto found = std::ranges::lower_bound(group_->links, link);
    const bool own = found != group_->links.end() && *found == link;
    return own ? static_cast<std::size_t>(found - group_->links.begin()) : outside_;
  };
  std::size_t row = 0;
  for (const std::size_t joint : group_->joints) {
    const Pair& pair = instant.constraints().pairs()[joint];
    joinings_.push_back({joint, row, place_of(pair.i), place_of(pair.j)});
    row += pair.shape.rows();
  }
}

void OpenedGroup::grow_tree(const Constraints& constraints) {
  const auto rows = [&](std::size_t k) { return constraints.pairs()[joinings_[k].joint].shape.rows(); };
  std::vector<bool> attached(links_ + 1, false), used(joinings_.size(), false);
  attached[outside_] = true;
  for (std::size_t best = 0; best < joinings_.size();) {
    best = joinings_.size();
    for (std::size_t k = 0; k < joinings_.size(); ++k) {
      if (attached[joinings_[k].i] == attached[joinings_[k].j]) continue;
      if (best == joinings_.size() || rows(k) > rows(best)) best = k;
    }
    if (best == joinings_.size()) continue;
    const auto [i, j] = std::pair(joinings_[best].i, joinings_[best].j);
    branches_.push_back(attached[i] ? Branch{j, i, best} : Branch{i, j, best});
    attached[branches_.back().link] = used[best] = true;
  }
  for (std::size_t k = 0; k < joinings_.size(); ++k) {
    if (used[k]) continue;
    opened_.push_back(joinings_[k].joint);
    for (std::size_t n = 0; n < rows(k); ++n) unknowns_.push_back(joinings_[k].row + n);
  }
}

Vec OpenedGroup::from_first(const Instant& instant, std::size_t link) const {
  return place(instant.q(), group_->links[link]) - place(instant.q(), group_->links.front());
}

void OpenedGroup::find_forces(const Instant& instant, std::span<double> on_links, Forces& forces) {
  std::ranges::fill(acting_, Acting{});
  add_constraints(instant);
  add_active_forces(instant, on_links);
  sum_up_parts();
  write_moments(instant.constraints());
  solve_moments();
  find_tree_reactions(instant, forces);
  find_opened_reactions(instant, forces);
  find_efforts(instant, forces);
  press_on_earlier(instant, on_links, forces);
}

// A row of the Jacobian holds, for each link, the force and the moment about its origin of a unit of the row's force.
void OpenedGroup::add_constraints(const Instant& instant) {
  for (const auto& entry : group_->own) {
    const double value = instant.constraints().jacobian()[entry.place];
    const Vec origin = from_first(instant, entry.column / 3);
    Acting& on_link = acting(entry.column / 3, entry.row);
    const std::size_t component = entry.column % 3;
    on_link[component] += value;
    if (component == 0) on_link[2] -= origin.y * value;
    if (component == 1) on_link[2] += origin.x * value;
  }
}

void OpenedGroup::add_active_forces(const Instant& instant, std::span<const double> on_links) {
  for (std::size_t link = 0; link < links_; ++link) {
    const double* const on_link = &on_links[3 * group_->links[link]];
    add(acting(link, rows_).data(), from_first(instant, link), {on_link[0], on_link[1]}, on_link[2]);
  }
}

void OpenedGroup::sum_up_parts() {
  for (std::size_t u = 0; u <= unknowns_.size(); ++u) {
    const std::size_t column = u < unknowns_.size() ? unknowns_[u] : rows_;
    Acting* const part = &on_part_[u * links_];
    std::copy_n(&acting(0, column), links_, part);
    for (auto branch = branches_.rbegin(); branch != branches_.rend(); ++branch) {
      if (branch->parent != outside_) view(part[branch->parent]) += view(part[branch->link]);
    }
  }
}

void OpenedGroup::write_moments(const Constraints& constraints) {
  const std::size_t size = unknowns_.size();
  std::size_t equation = 0;
  for (const Branch& branch : branches_) {
    const Joining& joining = joinings_[branch.joining];
    const std::size_t count = constraints.pairs()[joining.joint].shape.rows();
    std::array<Triple, 3> held;
    for (std::size_t r = 0; r < count; ++r) held[r] = view(acting(branch.link, joining.row + r));
    const Freedoms free = freedoms(std::span(held).first(count));
    for (std::size_t n = 0; n < free.count; ++n, ++equation) {
      for (std::size_t u = 0; u < size; ++u) {
        moments_[equation * size + u] = free.motion[n].dot(view(on_part(branch.link, u)));
      }
      active_moments_[equation] = free.motion[n].dot(view(on_part(branch.link, size)));
    }
  }
  assert(equation == size);
}

void OpenedGroup::solve_moments() {
  const std::size_t size = forces_.size();
  inverse_.invert(moments_);
  for (std::size_t u = 0; u < size; ++u) {
    forces_[u] = 0.0;
    for (std::size_t n = 0; n < size; ++n) forces_[u] -= moments_[u * size + n] * active_moments_[n];
  }
}

// The forces on a part are in equilibrium with the joint that connects it.
void OpenedGroup::find_tree_reactions(const Instant& instant, Forces& forces) const {
  const Vec first = place(instant.q(), group_->links.front());
  for (const Branch& branch : branches_) {
    Triple sum = view(on_part(branch.link, unknowns_.size()));
    for (std::size_t u = 0; u < unknowns_.size(); ++u) sum += forces_[u] * view(on_part(branch.link, u));
    const Joining& joining = joinings_[branch.joining];
    const Pair& pair = instant.constraints().pairs()[joining.joint];
    forces.reactions[joining.joint] = reaction_in(instant, pair, first, joining.i == branch.link ? Triple(-sum) : sum);
  }
}

void OpenedGroup::find_opened_reactions(const Instant& instant, Forces& forces) const {
  const Vec first = place(instant.q(), group_->links.front());
  std::size_t u = 0;
  auto joining = joinings_.begin();
  for (const std::size_t joint : opened_) {
    while (joining->joint != joint) ++joining;
    const Pair& pair = instant.constraints().pairs()[joint];
    const bool on_i = joining->i != outside_;  // otherwise not of this group, whose columns are empty
    Triple sum = Triple::Zero();
    for (std::size_t n = 0; n < pair.shape.rows(); ++n, ++u) {
      sum += forces_[u] * view(acting(on_i ? joining->i : joining->j, joining->row + n));
    }
    forces.reactions[joint] = reaction_in(instant, pair, first, on_i ? sum : Triple(-sum));
  }
}

void OpenedGroup::find_efforts(const Instant& instant, Forces& forces) const {
  const std::size_t first = unknowns_.size() - group_->drivers.size();
  for (std::size_t n = 0; n < group_->drivers.size(); ++n) {
    const std::size_t driver = group_->drivers[n];
    forces.effort[driver] = instant.effort_arm(driver) * forces_[first + n];
  }
}

void OpenedGroup::press_on_earlier(const Instant& instant, std::span<double> on_links, const Forces& forces) const {
  const double shrink = 1.0 / instant.length();
  const auto press = [&](std::size_t link, const Reaction& reaction, double sense) {
    if (3 * link == on_links.size()) return;  // the ground
    const Vec arm = shrink * reaction.at - place(instant.q(), link);
    add(&on_links[3 * link], arm, sense * reaction.force, sense * shrink * reaction.couple);
  };
  for (const Joining& joining : joinings_) {
    const Pair& pair = instant.constraints().pairs()[joining.joint];
    const Reaction& reaction = forces.reactions[joining.joint];
    if (joining.i == outside_) press(pair.i, reaction, 1.0);
    if (joining.j == outside_) press(pair.j, reaction, -1.0);
  }
  for (const auto& entry : group_->earlier) {
    const std::size_t first = rows_ - group_->drivers.size();
    if (entry.row < first) continue;
    const std::size_t driver = group_->drivers[entry.row - first];
    const double force = forces.effort[driver] / instant.effort_arm(driver);
    on_links[entry.column] += force * instant.constraints().jacobian()[entry.place];
  }
}

}  // namespace loadpath::mechanism
