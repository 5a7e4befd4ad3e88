#include "lib/mechanism/groups/positions.hpp"

#include "lib/mechanism/model/whole_turn.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::mechanism {
namespace {

double side(double value) { return value < 0.0 ? -1.0 : 1.0; }

}  // namespace

GroupPositions::GroupPositions(const Plan& plan, double length)
    : plan_(plan),
      length_(length),
      links_(plan.links),
      hung_(plan.tree.size()),
      cuts_(plan.cuts.size()),
      branch_(plan.groups.size(), 1.0),
      target_(plan.drivers) {
  std::size_t most = 0;
  for (const GroupPlan& group : plan.groups) {
    loops_.emplace_back(group.unknowns.size());
    most = std::max(most, group.unknowns.size());
  }
  step_.resize(most);
  for (std::size_t k = 0; k < plan.cuts.size(); ++k) prepare(plan.cuts[k].shape, cuts_[k].pair);
}

// Inline as in motion.cpp.
inline void GroupPositions::place(std::size_t t) {
  const TreeJoint& tree = plan_.tree[t];
  const Placed& on = links_[tree.on];
  Placed& link = links_[tree.link];
  TreeJointPlace& hung = hung_[t];
  hung.lever = on.turned(tree.seat);
  if (tree.kind == TreeJoint::Kind::turn) {
    link.turned = on.turned * hung.turned;
    link.phi = on.phi + hung.value;
  } else {  // fixed: a slide of the length 0
    link.turned = on.turned * tree.turned;
    link.phi = on.phi + tree.angle;
    hung.along = on.turned(tree.along);
    hung.lever = hung.lever + hung.value * hung.along;
  }
  hung.pin = on.origin + hung.lever;
  hung.arm = -link.turned(tree.pin);
  link.origin = hung.pin + hung.arm;
}

void GroupPositions::place_tree(const GroupPlan& group) {
  for (std::size_t t = group.first_tree; t < group.last_tree; ++t) place(t);
}

inline void GroupPositions::place_cut(std::size_t k) {
  const Cut& cut = plan_.cuts[k];
  CutPlace& at = cuts_[k];
  mechanism::place(cut.shape, links_[cut.i], links_[cut.j], at.pair);
  at.arm_i = at.pair.at - links_[cut.i].origin;
  at.arm_j = at.pair.at - links_[cut.j].origin;
}

// The rotation decides; among angles that differ by full revolutions the one nearest to the previous angle.
inline void GroupPositions::set_turn(std::size_t t, Turn turned) {
  hung_[t].turned = turned;
  const double angle = angle_of(turned);
  hung_[t].value = angle + whole_turn * std::round((hung_[t].value - angle) / whole_turn);
}

void GroupPositions::adopt(std::span<const Pose> poses) {
  for (std::size_t k = 0; k < poses.size(); ++k) {
    links_[k] = {turn(poses[k].phi), {poses[k].x, poses[k].y}, poses[k].phi};
  }
  for (std::size_t t = plan_.tree.size(); t-- > 0;) read_value(t);
  for (std::size_t g = 0; g < plan_.groups.size(); ++g) {
    place_tree(plan_.groups[g]);
    take_side(g);
  }
  for (std::size_t k = 0; k < cuts_.size(); ++k) {
    const Cut& cut = plan_.cuts[k];
    place_cut(k);
    count_turns(cut.shape, links_[cut.i], links_[cut.j], cuts_[k].pair);
  }
}

void GroupPositions::read_value(std::size_t t) {
  const TreeJoint& tree = plan_.tree[t];
  const Placed& link = links_[tree.link];
  Placed& on = links_[tree.on];
  TreeJointPlace& hung = hung_[t];
  if (tree.kind == TreeJoint::Kind::fixed) return;
  if (tree.on > plan_.ground) on = {{}, link.origin, 0.0};
  if (tree.kind == TreeJoint::Kind::turn) {
    hung.value = link.phi - on.phi;
    hung.turned = turn(hung.value);
    return;
  }
  const Vec along = on.turned(tree.along);
  if (tree.on > plan_.ground) on.origin = on.origin - dot(along, on.origin) * along;
  hung.value = dot(along, link.point(tree.pin) - on.point(tree.seat));
}

// Takes the current assembly mode of the group.
void GroupPositions::take_side(std::size_t g) {
  const GroupPlan& group = plan_.groups[g];
  if (group.closing == Closing::nothing || group.closing == Closing::by_newton) return;
  place_cut(group.first_cut);
  const PairPlace closed = cuts_[group.first_cut].pair;
  std::array<double, 2> values{};
  std::array<Turn, 2> turns{};
  for (std::size_t u = 0; u < group.unknowns.size(); ++u) {
    values[u] = hung_[group.unknowns[u]].value;
    turns[u] = hung_[group.unknowns[u]].turned;
  }
  refer(group);
  if (group.closing == Closing::two_paths) branch_[g] = branch_of(path_of_i(group), path_of_j(group), closed.at);
  if (group.closing == Closing::slot_about_pin) branch_[g] = side(cross(from_pivot_of_j(group), normal(closed.along)));
  if (group.closing == Closing::slide_of_two_turns)
    branch_[g] = side(cross(between_pivots(group), normal(closed.along)));
  for (std::size_t u = 0; u < group.unknowns.size(); ++u) {
    hung_[group.unknowns[u]].value = values[u];
    hung_[group.unknowns[u]].turned = turns[u];
  }
  place_tree(group);
}

bool GroupPositions::move(std::span<const Drive> drives, double change, const Prediction& prediction) {
  least_sine_ = near_change + change;
  change_ = change;
  for (std::size_t d = 0; d < drives.size(); ++d) target_[d] = drives[d].coordinate;
  for (std::size_t g = 0; g < plan_.groups.size(); ++g) {
    const GroupPlan& group = plan_.groups[g];
    for (std::size_t t = group.first_tree; t < group.last_tree; ++t) {
      const TreeJoint& tree = plan_.tree[t];
      if (tree.driver == none) continue;
      hung_[t].value = tree.sense * (target_[tree.driver] - tree.offset);
      if (tree.kind == TreeJoint::Kind::turn) hung_[t].turned = turn(hung_[t].value);
    }
    if (!close(g, prediction)) return false;
  }
  return true;
}

bool GroupPositions::close(std::size_t g, const Prediction& prediction) {
  const GroupPlan& group = plan_.groups[g];
  if (group.closing == Closing::by_newton) return close_by_newton(g, prediction);
  if (group.closing != Closing::nothing) {
    refer(group);
    if (!close_in_closed_form(group, branch_[g])) return false;
  }
  place_tree(group);
  return true;
}

bool GroupPositions::close_in_closed_form(const GroupPlan& group, double branch) {
  switch (group.closing) {
    case Closing::two_paths:
      return close_two_paths(group, branch);
    case Closing::slot_along_slide:
      return group.mover_i == none ? slide_to_line(group, group.mover_j, -1.0)
                                   : slide_to_line(group, group.mover_i, 1.0);
    case Closing::slot_about_pin:
      return close_slot_about_pin(group, branch);
    case Closing::slide_of_two_turns:
      return close_slide_of_two_turns(group, branch);
    case Closing::slide_of_turn:
      return close_slide_of_turn(group);
    case Closing::nothing:
    case Closing::by_newton:
      break;
  }
  return true;
}

// The coordinates that are sought go to zero: from there the closed forms count.
void GroupPositions::refer(const GroupPlan& group) {
  for (const std::size_t t : group.unknowns) {
    hung_[t].turned = {};
    if (plan_.tree[t].kind == TreeJoint::Kind::slide) hung_[t].value = 0.0;
  }
  place_tree(group);
  place_cut(group.first_cut);
}

inline Locus GroupPositions::path(std::size_t mover, Vec point) const {
  const TreeJointPlace& hung = hung_[mover];
  if (plan_.tree[mover].kind == TreeJoint::Kind::slide) return {true, point, hung.along};
  const Vec arm = point - hung.pin;
  return {false, hung.pin, {}, std::sqrt(dot(arm, arm))};
}

Locus GroupPositions::path_of_i(const GroupPlan& group) const {
  return path(group.mover_i, cuts_[group.first_cut].pair.at);
}

Locus GroupPositions::path_of_j(const GroupPlan& group) const {
  const PairPlace& cut = cuts_[group.first_cut].pair;
  return group.mover_j == none ? Locus{true, cut.seat, cut.along} : path(group.mover_j, cut.seat);
}

inline void GroupPositions::reach(std::size_t mover, Vec from, Vec to) {
  const TreeJointPlace& hung = hung_[mover];
  if (plan_.tree[mover].kind == TreeJoint::Kind::slide) {
    hung_[mover].value = dot(to - from, hung.along);
  } else {
    set_turn(mover, turn(from - hung.pin, to - hung.pin));
  }
}

bool GroupPositions::close_two_paths(const GroupPlan& group, double branch) {
  const Meeting meeting = meet(path_of_i(group), path_of_j(group), branch);
  if (!is_clear(meeting.sine)) return false;
  const PairPlace& cut = cuts_[group.first_cut].pair;
  reach(group.mover_i, cut.at, meeting.at);
  if (group.mover_j != none) reach(group.mover_j, cut.seat, meeting.at);
  return true;
}

Vec GroupPositions::from_pivot_of_j(const GroupPlan& group) const {
  return cuts_[group.first_cut].pair.at - hung_[group.mover_j].pin;
}

bool GroupPositions::close_slot_about_pin(const GroupPlan& group, double branch) {
  const PairPlace& cut = cuts_[group.first_cut].pair;
  const Vec across = normal(cut.along);
  const double distance = dot(across, cut.seat - hung_[group.mover_j].pin);
  const Meeting turned = unit_vector_with_projection(from_pivot_of_j(group), distance, branch);
  if (!is_clear(turned.sine)) return false;
  set_turn(group.mover_j, turn(across, turned.at));
  return true;
}

Vec GroupPositions::between_pivots(const GroupPlan& group) const {
  return hung_[group.mover_i].pin - hung_[group.mover_j].pin;
}

// The turn of link i that puts it at its angle against link j.
Turn GroupPositions::turn_into_line(const GroupPlan& group) const {
  const Cut& cut = plan_.cuts[group.first_cut];
  return links_[cut.j].turned * cut.shape.turned * links_[cut.i].turned.back();
}

// With link i at its angle to link j both rotate together, until the line of j passes through the pin of i.
bool GroupPositions::close_slide_of_two_turns(const GroupPlan& group, double branch) {
  const PairPlace& cut = cuts_[group.first_cut].pair;
  const Turn aligned = turn_into_line(group);
  const Vec across = normal(cut.along);
  const Vec arm_i = aligned(cut.at - hung_[group.mover_i].pin), arm_j = cut.seat - hung_[group.mover_j].pin;
  const Meeting turned = unit_vector_with_projection(between_pivots(group), dot(across, arm_j - arm_i), branch);
  if (!is_clear(turned.sine)) return false;
  const Turn together = turn(across, turned.at);
  set_turn(group.mover_i, together * aligned);
  set_turn(group.mover_j, together);
  return true;
}

bool GroupPositions::close_slide_of_turn(const GroupPlan& group) {
  const Turn aligned = turn_into_line(group);
  const bool turns_i = plan_.tree[group.mover_i].kind == TreeJoint::Kind::turn;
  set_turn(turns_i ? group.mover_i : group.mover_j, turns_i ? aligned : aligned.back());
  place_tree(group);
  place_cut(group.first_cut);
  return turns_i ? slide_to_line(group, group.mover_j, -1.0) : slide_to_line(group, group.mover_i, 1.0);
}

// Along its slide, until the pin of i lies on the line of j.
bool GroupPositions::slide_to_line(const GroupPlan& group, std::size_t mover, double side) {
  const PairPlace& cut = cuts_[group.first_cut].pair;
  const Vec across = normal(cut.along);
  const double sine = side * dot(across, hung_[mover].along);
  if (!is_clear(std::abs(sine))) return false;
  hung_[mover].value += dot(across, cut.seat - cut.at) / sine;
  return true;
}

// From the predicted coordinates; a step not much smaller than the one before leads to another assembly.
bool GroupPositions::close_by_newton(std::size_t g, const Prediction& prediction) {
  constexpr double longest_move = 0.5, largest_correction = 0.2, exact = 1e-13, quadratic = 1e-7;
  constexpr double setting_out = 0.3;  // by the drives' change: a follower leaves a dwell faster than predicted
  constexpr int most_steps = 8;
  const GroupPlan& group = plan_.groups[g];
  double way = 0.0;
  for (const std::size_t t : group.unknowns) {
    way = std::max(way, std::abs(in_own_unit(t, prediction.first[t])));
    hung_[t].value += prediction.first[t] + 0.5 * prediction.second[t];
  }
  if (!(way < longest_move)) return false;
  const double beyond = group.on_cam ? setting_out * change_ : 0.0;
  double most = largest_correction * (way + beyond) + quadratic, previous = most;
  for (int k = 0; k < most_steps; ++k) {
    const double size = newton_step(g);
    if (!(size <= most)) return false;
    if (size <= exact || (k > 0 && previous <= quadratic)) {
      place_turned(group);
      return true;
    }
    most = std::max(0.25 * size, quadratic);
    previous = size;
  }
  return false;
}

double GroupPositions::in_own_unit(std::size_t t, double value) const {
  return plan_.tree[t].kind == TreeJoint::Kind::slide ? value / length_ : value;
}

void GroupPositions::place_turned(const GroupPlan& group) {
  for (const std::size_t t : group.unknowns) {
    if (plan_.tree[t].kind == TreeJoint::Kind::turn) hung_[t].turned = turn(hung_[t].value);
  }
  place_tree(group);
}

/// The largest change that it makes; no number if the closing equations are singular.
double GroupPositions::newton_step(std::size_t g) {
  const GroupPlan& group = plan_.groups[g];
  place_turned(group);
  if (!factor(g)) return std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = group.first_cut; k < group.last_cut; ++k) {
    const Cut& cut = plan_.cuts[k];
    open(cut.shape, cuts_[k].pair, links_[cut.i], links_[cut.j], cut.driver == none ? 0.0 : target_[cut.driver],
         std::span(step_).subspan(cut.row, cut.rows));
  }
  loops_[g].solve(std::span(step_).first(group.unknowns.size()));
  double size = 0.0;
  for (std::size_t u = 0; u < group.unknowns.size(); ++u) {
    hung_[group.unknowns[u]].value -= step_[u];
    size = std::max(size, std::abs(in_own_unit(group.unknowns[u], step_[u])));
  }
  return size;
}

bool GroupPositions::factor() {
  bool good = true;
  for (std::size_t g = 0; g < plan_.groups.size(); ++g) good = factor(g) && good;
  return good;
}

bool GroupPositions::factor(std::size_t g) {
  const GroupPlan& group = plan_.groups[g];
  numerics::SmallLu& loops = loops_[g];
  if (loops.size() == 0) return true;
  loops.clear();
  for (std::size_t k = group.first_cut; k < group.last_cut; ++k) {
    place_cut(k);
    const Cut& cut = plan_.cuts[k];
    const PairPlace& at = cuts_[k].pair;
    for (const Mover& mover : cut.movers) {
      const TreeJoint& tree = plan_.tree[mover.tree];
      const bool turns = tree.kind == TreeJoint::Kind::turn;
      const double omega = turns ? mover.side : 0.0;  // at the coordinate's unit speed
      const Vec speed = mover.side * (turns ? normal(at.at - hung_[mover.tree].pin) : hung_[mover.tree].along);
      for (std::size_t r = 0; r < cut.rows; ++r) {
        loops.at(cut.row + r, tree.unknown) = dot(speed, at.rows[r].e) + omega * at.rows[r].m;
      }
    }
  }
  return loops.factor();
}

}  // namespace loadpath::mechanism
