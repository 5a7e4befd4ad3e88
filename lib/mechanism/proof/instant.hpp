// A mechanism at one position, as input of the proofs: its constraints there, its loads, and the virtual velocities
// of its drivers. Poses, velocities and accelerations are taken from the position, reactions and efforts are not,
// except for the part of a reaction that its constraints cannot supply: friction, separating force of teeth, slack
// sides.
#pragma once

#include "lib/mechanism/equations/kinematics.hpp"
#include "lib/mechanism/inverse/group_inverse.hpp"
#include "lib/mechanism/proof/active_forces.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

class Instant {
 public:
  /// The model is referred to: its loads may change between positions.
  explicit Instant(const Model& model);
  /// Takes over the dimensions of a model of the same structure, which is referred to from now on.
  void take_dimensions(const Model& model);
  /// Goes to this position, which is referred to. `statics`: without inertia. Takes no memory.
  void take(const Position& at, bool statics);
  /// The same without virtual velocities, the inverse and the condition number.
  void take_forces(const Position& at, bool statics);

  [[nodiscard]] const Model& model() const { return *model_; }
  [[nodiscard]] const Position& at() const { return *at_; }
  [[nodiscard]] bool statics() const { return statics_; }
  [[nodiscard]] std::span<const ActiveForce> active() const { return active_; }
  /// The part of `active` that reactions induce, and the rest.
  [[nodiscard]] std::span<const ActiveForce> induced() const { return active().subspan(external_); }
  [[nodiscard]] std::span<const ActiveForce> external() const { return active().first(external_); }
  /// The part of a joint's reaction that does not come from its constraints.
  [[nodiscard]] const Reaction& unconstrained_reaction(std::size_t joint) const { return unconstrained_[joint]; }

  /// The unit of length of constraints and coordinates, m: it makes moments comparable with forces.
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] const Constraints& constraints() const { return constraints_; }
  [[nodiscard]] std::span<const double> q() const { return q_; }

  /// A driver's effort over the force that is compared with others: that unit for a moment, 1 for a force.
  [[nodiscard]] double effort_arm(std::size_t driver) const;

  /// The velocity of this link, m/s and 1/s, when only this driver moves, at 1 rad or one unit of length per second.
  [[nodiscard]] Pose virtual_velocity(std::size_t driver, std::size_t link) const {
    const double* v = &motions_[driver * constraints_.columns() + 3 * link];
    return {length_ * v[0], length_ * v[1], v[2]};
  }
  /// The rate of a driver in its virtual velocities, rad/s or m/s.
  [[nodiscard]] double virtual_rate(std::size_t driver) const { return length_ / effort_arm(driver); }
  /// W, of everything that acts, in the virtual velocities of this driver.
  [[nodiscard]] double virtual_power(std::size_t driver) const;
  /// The inverse of the constraints' Jacobian here, with its groups.
  [[nodiscard]] const GroupInverse& inverse() const { return inverse_; }

  /// The condition number of the position's constraint equations with this unit of length, 1-norm, as GroupInverse
  /// finds it.
  [[nodiscard]] double condition() const { return condition_; }
  /// To rounding: at most three digits of the inverse remain.
  [[nodiscard]] bool is_singular() const { return !(condition_ <= 1e13); }

 private:
  void place();
  void find_induced_forces();
  void add_induced(int link, std::size_t joint, const Reaction& acting, double sense);
  void find_motions();

  const Model* model_;
  const Position* at_ = nullptr;
  bool statics_ = false;
  bool has_wheels_;
  double length_;
  Model scaled_;  // in the unit of length
  Constraints constraints_;
  std::vector<double> q_, no_targets_;
  std::vector<ActiveForce> active_;
  std::size_t external_ = 0;
  std::vector<Reaction> unconstrained_;
  GroupInverse inverse_;
  std::vector<double> rates_;
  std::vector<double> motions_;  // motions of all links for one driver after the other
  double condition_ = 0.0;
};

}  // namespace loadpath::mechanism
