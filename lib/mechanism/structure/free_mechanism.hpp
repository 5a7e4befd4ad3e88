// A mechanism at coordinates that may be anywhere, with any number of constraints, dependent or not: its rank, the
// motions that are left to it, and the forces that its joints can do to one another without any load.
#pragma once

#include "lib/mechanism/equations/kinematics.hpp"

#include <span>
#include <vector>

namespace loadpath::mechanism {

/// A basis of a null space with few entries per vector.
using NullSpace = std::vector<std::vector<double>>;
/// Whether an entry of a vector differs from zero by more than rounding.
bool in_support(const std::vector<double>& vector, std::size_t entry);

class FreeMechanism {
 public:
  /// At the stated poses. Rows and columns are about equally large in a model in its unit of length
  /// (`in_unit_of_length`).
  explicit FreeMechanism(const Model& model);

  /// Goes to these coordinates; its drivers are then where they should be.
  void go_to(std::span<const double> q);
  void shift(std::span<const double> by);
  /// Goes to the nearest coordinates at which all joints are closed and all drivers where they should be, by steps of
  /// least norm. False if there are none near.
  bool close() { return close_without({}, {}); }
  /// The same as if these rows of the constraints were not there; these coordinates stay where they are as long as
  /// others can do it.
  bool close_without(std::span<const std::size_t> rows, std::span<const std::size_t> reluctant);
  /// Moves along all of its motions at once, unequally, so that no symmetry is kept, by about this much (rad, or parts
  /// of the unit of length), and closes. False if that leads nowhere.
  bool move_on(double by);

  /// Motions that no constraint stops: 3 entries for each link.
  [[nodiscard]] NullSpace motions() const;
  /// Forces that are in equilibrium by themselves: an entry for each row of the constraints.
  [[nodiscard]] NullSpace self_stresses() const;
  /// The independence of this many constraints: a pivot of the constraints' matrix over the largest one, 0 to 1.
  [[nodiscard]] double grip(std::size_t rank) const;

  [[nodiscard]] const Constraints& constraints() const { return constraints_; }
  [[nodiscard]] std::span<const double> q() const { return std::span(q_).first(constraints_.columns()); }
  /// The poses of the links; `unit`: unit of the model's lengths, m.
  [[nodiscard]] std::vector<Pose> poses(double unit) const;

 private:
  /// Whether the rows of a large mechanism are independent by a sparse factorization; if not, they may still be.
  [[nodiscard]] bool clearly_independent() const;
  void place() { constraints_.place(q_, targets_); }

  Constraints constraints_;
  std::vector<double> targets_;
  std::vector<double> q_;  // with the ground's zeros
};

}  // namespace loadpath::mechanism
