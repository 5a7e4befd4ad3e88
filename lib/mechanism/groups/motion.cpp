#include "lib/mechanism/groups/motion.hpp"

#include "lib/mechanism/model/spring.hpp"

#include <algorithm>

namespace loadpath::mechanism {
namespace {

std::size_t most_unknowns(const Plan& plan) {
  std::size_t most = 0;
  for (const GroupPlan& group : plan.groups) most = std::max(most, group.unknowns.size());
  return most;
}

}  // namespace

GroupMotion::GroupMotion(const Model& model, const Plan& plan, GroupPositions& at)
    : model_(model),
      plan_(plan),
      at_(at),
      moving_(plan.links),
      rate_(plan.tree.size()),
      second_(plan.tree.size()),
      right_(most_unknowns(plan)),
      above_(plan.links) {}

// Functions called once for every link of a position are inline: the calls would cost as much as the work.

// A link moves with the pin of the carrying link, and rotates or slides against it.
inline void GroupMotion::carry_velocity(std::size_t t) {
  const TreeJoint& tree = plan_.tree[t];
  const TreeJointPlace& hung = at_.hung(t);
  const Moving& base = moving_[tree.on];
  Moving& link = moving_[tree.link];
  const bool turns = tree.kind == TreeJoint::Kind::turn;
  link.omega = turns ? base.omega + rate_[t] : base.omega;
  link.velocity = base.velocity + base.omega * normal(hung.lever) + link.omega * normal(hung.arm);
  if (!turns) link.velocity = link.velocity + rate_[t] * hung.along;
}

inline void GroupMotion::carry_acceleration(std::size_t t) {
  const TreeJoint& tree = plan_.tree[t];
  const TreeJointPlace& hung = at_.hung(t);
  const Moving& base = moving_[tree.on];
  Moving& link = moving_[tree.link];
  const bool turns = tree.kind == TreeJoint::Kind::turn;
  link.epsilon = turns ? base.epsilon + second_[t] : base.epsilon;
  link.acceleration = base.acceleration + base.gained(hung.lever) + link.gained(hung.arm);
  if (!turns) {
    link.acceleration = link.acceleration + 2.0 * base.omega * rate_[t] * normal(hung.along) + second_[t] * hung.along;
  }
}

// The speed at which a cut opens along its equations.
inline void GroupMotion::opening_speed(std::size_t k, std::span<double> out) const {
  const Cut& cut = plan_.cuts[k];
  const CutPlace& at = at_.cut(k);
  const Moving &i = moving_[cut.i], &j = moving_[cut.j];
  const Vec apart = i.velocity + i.omega * normal(at.arm_i) - j.velocity - j.omega * normal(at.arm_j);
  for (std::size_t r = 0; r < out.size(); ++r) {
    const PairRow& row = at.pair.rows[r];
    out[r] = dot(row.e, apart) + row.m * (i.omega - j.omega);
  }
}

// The same for the acceleration, apart from the part that the joint permits.
inline void GroupMotion::opening_acceleration(std::size_t k, std::span<double> out) const {
  const Cut& cut = plan_.cuts[k];
  const CutPlace& at = at_.cut(k);
  const Moving &i = moving_[cut.i], &j = moving_[cut.j];
  const Vec apart = i.acceleration + i.gained(at.arm_i) - j.acceleration - j.gained(at.arm_j);
  held_acceleration(cut.shape, at.pair, at_.link(cut.i), at_.link(cut.j), {i.velocity, i.omega}, {j.velocity, j.omega},
                    out);
  for (std::size_t r = 0; r < out.size(); ++r) {
    const PairRow& row = at.pair.rows[r];
    out[r] = dot(row.e, apart) + row.m * (i.epsilon - j.epsilon) - out[r];
  }
}

/// The coordinates of a group whose links `carry` moves: as `given` by the drives, the unknown ones such that none of
/// its cuts opens.
template <class Carry, class Open, class Given>
void GroupMotion::close(std::size_t g, std::span<double> rates, Carry carry, Open open, Given given) {
  const GroupPlan& group = plan_.groups[g];
  for (std::size_t t = group.first_tree; t < group.last_tree; ++t) {
    const TreeJoint& tree = plan_.tree[t];
    rates[t] = tree.driver == none ? 0.0 : tree.sense * given(tree.driver);
    carry(t);
  }
  if (group.unknowns.empty()) return;
  for (std::size_t k = group.first_cut; k < group.last_cut; ++k) {
    const Cut& cut = plan_.cuts[k];
    const std::span<double> rows = std::span(right_).subspan(cut.row, cut.rows);
    open(k, rows);
    for (double& speed : rows) speed = -speed;
    if (cut.driver != none) rows[0] += given(cut.driver);
  }
  const std::span<double> right = std::span(right_).first(group.unknowns.size());
  at_.loops(g).solve(right);
  for (std::size_t u = 0; u < right.size(); ++u) rates[group.unknowns[u]] = right[u];
  for (std::size_t t = group.first_tree; t < group.last_tree; ++t) carry(t);
}

void GroupMotion::find_velocities(std::span<const Drive> drives) {
  for (std::size_t g = 0; g < plan_.groups.size(); ++g) {
    close(
        g, rate_, [&](std::size_t t) { carry_velocity(t); },
        [&](std::size_t k, std::span<double> rows) { opening_speed(k, rows); },
        [&](std::size_t d) { return drives[d].speed; });
  }
}

void GroupMotion::find_accelerations(std::span<const Drive> drives) {
  for (std::size_t g = 0; g < plan_.groups.size(); ++g) {
    close(
        g, second_, [&](std::size_t t) { carry_acceleration(t); },
        [&](std::size_t k, std::span<double> rows) { opening_acceleration(k, rows); },
        [&](std::size_t d) { return drives[d].acceleration; });
  }
}

void GroupMotion::find_forces(bool statics, const Induced& induced, Position& out) {
  for (std::size_t k = 0; k < model_.links.size(); ++k) {
    const Moving& m = moving_[k];
    const Acceleration of_link = statics ? Acceleration{} : Acceleration{m.acceleration, m.omega, m.epsilon};
    moving_[k].needed = inertia_less_weight(model_.links[k], at_.link(k).turned, of_link, model_.gravity);
  }
  for (std::size_t k = plan_.ground; k < plan_.links; ++k) moving_[k].needed = {};
  for (const Load& load : model_.loads) {
    const auto k = static_cast<std::size_t>(load.link);
    moving_[k].needed.subtract(wrench_of(load, at_.link(k).turned));
  }
  for (const Spring& spring : model_.springs) {
    const std::size_t i = index(spring.i), j = index(spring.j);
    const Moving &on_i = moving_[i], &on_j = moving_[j];
    const SpringNow now =
        spring_now(spring, at_.link(i), at_.link(j), {on_i.velocity, on_i.omega}, {on_j.velocity, on_j.omega});
    supply(i, {now.at_i, now.force, now.couple}, 1.0);
    supply(j, {now.at_j, now.force, now.couple}, -1.0);
  }
  for (std::size_t m = 0; m < induced.modes.size(); ++m) {
    const InducedMode& mode = induced.modes[m];
    const Joint& joint = model_.joints[mode.joint];
    const Reaction acting{mode.at, induced.amounts[m] * mode.force, induced.amounts[m] * mode.couple};
    supply(index(joint.i), acting, 1.0);
    supply(index(joint.j), acting, -1.0);
  }
  for (std::size_t g = plan_.groups.size(); g-- > 0;) {
    const GroupPlan& group = plan_.groups[g];
    if (!group.unknowns.empty()) find_cut_forces(g, out);
    for (std::size_t t = group.last_tree; t-- > group.first_tree;) find_tree_force(t, out);
  }
}

// The cuts take the forces along the unknown coordinates.
inline void GroupMotion::find_cut_forces(std::size_t g, Position& out) {
  const GroupPlan& group = plan_.groups[g];
  const std::span<double> right = std::span(right_).first(group.unknowns.size());
  sum_up(group, right);
  at_.loops(g).solve_transposed(right);
  for (std::size_t k = group.first_cut; k < group.last_cut; ++k) {
    const Cut& cut = plan_.cuts[k];
    const CutPlace& at = at_.cut(k);
    Reaction reaction{.at = at.pair.at, .force = {}, .touch = at.pair.touch.parameter};
    for (std::size_t r = 0; r < cut.rows; ++r) {
      const PairRow& row = at.pair.rows[r];
      reaction.force = reaction.force + right[cut.row + r] * row.e;
      reaction.couple += right[cut.row + r] * row.m;
    }
    moving_[cut.i].needed.subtract({reaction.force, reaction.couple + cross(at.arm_i, reaction.force)});
    moving_[cut.j].needed.add({reaction.force, reaction.couple}, at.arm_j);
    if (cut.joint != none) out.reactions[cut.joint] = reaction;
    if (cut.driver != none) out.effort[cut.driver] = right[cut.row];
  }
}

// Sums the forces required by the links above each unknown coordinate, along that coordinate.
inline void GroupMotion::sum_up(const GroupPlan& group, std::span<double> along) {
  for (std::size_t t = group.first_tree; t < group.last_tree; ++t) {
    const std::size_t k = plan_.tree[t].link;
    above_[k] = moving_[k].needed;
  }
  for (std::size_t t = group.last_tree; t-- > group.first_tree;) {
    const TreeJoint& tree = plan_.tree[t];
    const TreeJointPlace& hung = at_.hung(t);
    const Wrench& needed = above_[tree.link];
    const double about_pin = needed.moment + cross(hung.arm, needed.force);
    if (tree.unknown != none) {
      along[tree.unknown] = tree.kind == TreeJoint::Kind::turn ? about_pin : dot(needed.force, hung.along);
    }
    if (!tree.based) above_[tree.on].add({needed.force, about_pin}, hung.lever);
  }
}

// A reaction supplies part of the force on a link.
inline void GroupMotion::supply(std::size_t link, const Reaction& reaction, double sense) {
  Wrench& needed = moving_[link].needed;
  needed.force = needed.force - sense * reaction.force;
  needed.moment -= sense * (reaction.couple + cross(reaction.at - at_.link(link).origin, reaction.force));
}

inline std::size_t GroupMotion::index(int link) const {
  return link == ground ? plan_.ground : static_cast<std::size_t>(link);
}

// The remaining force on a link passes through its tree joint to the link that carries it.
inline void GroupMotion::find_tree_force(std::size_t t, Position& out) {
  const TreeJoint& tree = plan_.tree[t];
  const TreeJointPlace& hung = at_.hung(t);
  const Vec force = moving_[tree.link].needed.force;
  const double about_pin = moving_[tree.link].needed.moment + cross(hung.arm, force);
  moving_[tree.on].needed.add({force, about_pin}, hung.lever);
  if (tree.joint == none) return;
  Reaction through{hung.pin, force};
  double effort = about_pin;
  if (tree.kind != TreeJoint::Kind::turn) {
    effort = tree.kind == TreeJoint::Kind::slide ? dot(force, hung.along) : 0.0;
    const Vec slid = tree.link_is_i ? Vec{} : hung.value * hung.along;  // the pin of link i lies at the seat then
    through = {hung.pin - slid, force - effort * hung.along, about_pin + cross(slid, force)};
  }
  const double sense = tree.link_is_i ? 1.0 : -1.0;
  out.reactions[tree.joint] = {through.at, sense * through.force, sense * through.couple};
  if (tree.driver != none) out.effort[tree.driver] = tree.sense * effort;
}

}  // namespace loadpath::mechanism
