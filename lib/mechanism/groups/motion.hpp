// Velocities, accelerations and forces group by group at a position. The closing equations of a group serve all
// three: motions go forward from the first group attached, forces back from the last, by the transposed equations.
#pragma once

#include "lib/mechanism/equations/kinetostatics.hpp"
#include "lib/mechanism/forces/induced.hpp"
#include "lib/mechanism/groups/positions.hpp"
#include "lib/mechanism/model/model.hpp"

#include <span>
#include <vector>

namespace loadpath::mechanism {

/// The motion of a link, its frame and itself, and the wrench that its joints must supply, about its origin.
struct Moving {
  Vec velocity, acceleration;
  double omega = 0.0, epsilon = 0.0;
  Wrench needed;

  /// The acceleration of a point of the link, at `arm` from its origin, relative to the origin.
  [[nodiscard]] Vec gained(Vec arm) const { return epsilon * normal(arm) - omega * omega * arm; }
};

class GroupMotion {
 public:
  /// All of them must outlive this.
  GroupMotion(const Model& model, const Plan& plan, GroupPositions& at);

  void find_velocities(std::span<const Drive> drives);
  /// After the velocities.
  void find_accelerations(std::span<const Drive> drives);
  /// After both; `statics`: as if the accelerations were zero. Reactions and efforts in equilibrium with the induced
  /// forces are written to `out`.
  void find_forces(bool statics, const Induced& induced, Position& out);

  [[nodiscard]] const Moving& link(std::size_t k) const { return moving_[k]; }
  /// The rates of the tree joints' coordinates, from the velocities and accelerations found last.
  [[nodiscard]] Prediction rates() const { return {rate_, second_}; }

 private:
  void carry_velocity(std::size_t tree);
  void carry_acceleration(std::size_t tree);
  void opening_speed(std::size_t cut, std::span<double> out) const;
  void opening_acceleration(std::size_t cut, std::span<double> out) const;
  template <class Carry, class Open, class Given>
  void close(std::size_t g, std::span<double> rates, Carry carry, Open open, Given given);

  void find_cut_forces(std::size_t g, Position& out);
  void sum_up(const GroupPlan& group, std::span<double> along);
  void supply(std::size_t link, const Reaction& reaction, double sense);
  [[nodiscard]] std::size_t index(int link) const;
  void find_tree_force(std::size_t tree, Position& out);

  const Model& model_;
  const Plan& plan_;
  GroupPositions& at_;
  std::vector<Moving> moving_;
  std::vector<double> rate_, second_;  // rates of the tree joints
  std::vector<double> right_;          // right-hand side of the closing equations
  std::vector<Wrench> above_;          // wrenches of the links
};

}  // namespace loadpath::mechanism
