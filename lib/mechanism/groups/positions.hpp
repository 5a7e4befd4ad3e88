// Positions of a mechanism group by group: closed forms for dyads, Newton's iteration for other groups.
#pragma once

#include "lib/mechanism/groups/loci.hpp"
#include "lib/mechanism/groups/plan.hpp"
#include "lib/mechanism/model/position.hpp"
#include "lib/mechanism/model/vec.hpp"
#include "lib/numerics/small_lu.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// A tree joint where the mechanism is, global axes.
struct TreeJointPlace {
  double value = 0.0;  // its coordinate, rad or m
  Turn turned;         // turn: of link against `on`
  Vec pin, along;
  Vec lever, arm;  // from the origin of `on` to the pin, and on to that of link
};

/// A cut where the mechanism is, with the arms from the origins of its links to where its forces act, global axes.
struct CutPlace {
  PairPlace pair;
  Vec arm_i, arm_j;
};

/// A guess of where the unknown coordinates go in a move, by tree joints: their change and, halved, its curvature.
struct Prediction {
  std::span<const double> first, second;
};

class GroupPositions {
 public:
  /// The plan must outlive this; `length`: the size of the mechanism, m.
  GroupPositions(const Plan& plan, double length);

  /// The size of the mechanism, where the plan has taken other dimensions.
  void take_length(double length) { length_ = length; }
  /// Takes over an assembly: from now on the groups are closed on its side.
  void adopt(std::span<const Pose> poses);
  /// Moves to the drives' coordinates; `change`: the largest of theirs, rad or parts of the mechanism's size. False
  /// if a group does not close or comes so near to its change point that the move has to be followed in small steps;
  /// the state is then not an assembly.
  [[nodiscard]] bool move(std::span<const Drive> drives, double change, const Prediction& prediction);
  /// Sets up the closing equations where the mechanism is. False if they are singular.
  [[nodiscard]] bool factor();
  /// Of one group.
  [[nodiscard]] bool factor(std::size_t g);

  /// The search of assemblies (search.cpp): the drives' coordinates; then the groups one after the other, each
  /// on its side +1 or -1 where it has a closed form, else by iteration from these unknown coordinates. False if
  /// that leads to no assembly.
  void aim(std::span<const Drive> drives);
  [[nodiscard]] bool close_on_side(std::size_t g, double branch);
  [[nodiscard]] bool close_from(std::size_t g, std::span<const double> start);
  /// The side of the assembly held, +1 or -1.
  [[nodiscard]] double branch(std::size_t g) const { return branch_[g]; }

  [[nodiscard]] const Placed& link(std::size_t k) const { return links_[k]; }
  [[nodiscard]] const TreeJointPlace& hung(std::size_t tree) const { return hung_[tree]; }
  [[nodiscard]] const CutPlace& cut(std::size_t k) const { return cuts_[k]; }
  /// The closing equations of a group: rows by its cuts, columns by its unknown coordinates.
  [[nodiscard]] numerics::SmallLu& loops(std::size_t group) { return loops_[group]; }

 private:
  void place(std::size_t tree);
  void place_tree(const GroupPlan& group);
  void place_cut(std::size_t k);
  void set_turn(std::size_t tree, Turn turned);
  void read_value(std::size_t tree);
  void take_side(std::size_t g);

  bool close(std::size_t g, const Prediction& prediction);
  bool close_in_closed_form(const GroupPlan& group, double branch);
  void refer(const GroupPlan& group);
  [[nodiscard]] Locus path(std::size_t mover, Vec point) const;
  [[nodiscard]] Locus path_of_i(const GroupPlan& group) const;
  [[nodiscard]] Locus path_of_j(const GroupPlan& group) const;
  void reach(std::size_t mover, Vec from, Vec to);
  bool close_two_paths(const GroupPlan& group, double branch);
  [[nodiscard]] Vec from_pivot_of_j(const GroupPlan& group) const;
  bool close_slot_about_pin(const GroupPlan& group, double branch);
  [[nodiscard]] Vec between_pivots(const GroupPlan& group) const;
  [[nodiscard]] Turn turn_into_line(const GroupPlan& group) const;
  bool close_slide_of_two_turns(const GroupPlan& group, double branch);
  bool close_slide_of_turn(const GroupPlan& group);
  bool slide_to_line(const GroupPlan& group, std::size_t mover, double side);
  [[nodiscard]] bool is_clear(double sine) const { return sine > least_sine_; }

  void unwind(const GroupPlan& group);

  bool close_by_newton(std::size_t g, const Prediction& prediction);
  [[nodiscard]] double in_own_unit(std::size_t tree, double value) const;
  void place_turned(const GroupPlan& group);
  double newton_step(std::size_t g);

  const Plan& plan_;
  double length_;
  std::vector<Placed> links_;
  std::vector<TreeJointPlace> hung_;
  std::vector<CutPlace> cuts_;
  std::vector<double> branch_;            // sides of groups
  std::vector<numerics::SmallLu> loops_;  // equations of groups
  std::vector<double> target_;            // coordinates of drives
  std::vector<double> step_;
  double least_sine_ = 0.0;
  double change_ = 0.0;  // change of the drives, in a move
};

}  // namespace loadpath::mechanism
