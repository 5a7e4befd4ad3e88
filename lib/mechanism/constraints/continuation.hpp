// Closes a mechanism, and moves it along the drivers' coordinates without leaving its assembly.
#pragma once

#include "lib/mechanism/constraints/gap.hpp"
#include "lib/mechanism/equations/kinematics.hpp"
#include "lib/mechanism/model/position.hpp"
#include "lib/numerics/sparse_lu.hpp"

#include <span>
#include <vector>

namespace loadpath::mechanism {

/// The current coordinates, with the constraints factored there. Lengths in units of the mechanism's size.
class Continuation {
 public:
  explicit Continuation(const Model& model);

  /// For a model of the same structure, as if made from it.
  void take_dimensions(const Model& model);
  Status assemble(const Model& model);
  /// Takes over the poses of the model, closed at these coordinates of the drivers.
  void hold(const Model& model, std::span<const double> drives);
  /// Moves to these finite coordinates of the drivers; unchanged if that fails, as it does without an assembly.
  Status move(std::span<const double> goal);

  [[nodiscard]] std::span<const double> q() const { return q_; }
  [[nodiscard]] std::span<const double> drives() const { return held_; }
  [[nodiscard]] const Constraints& constraints() const { return constraints_; }
  [[nodiscard]] numerics::SparseLu& factors() { return factors_; }
  [[nodiscard]] Gap gap() const { return gap_; }

 private:
  [[nodiscard]] std::span<double> unknowns(std::vector<double>& x) const { return {x.data(), constraints_.columns()}; }
  void take_poses(const Model& model);
  void place() { constraints_.place(q_, target_); }
  bool find_newton_step();
  bool pull_together();
  bool search_along_newton_step(double& opening);
  [[nodiscard]] double opening() const;
  [[nodiscard]] Gap widest(double reached) const;

  void predict(std::span<const double> goal);
  [[nodiscard]] double longest_part() const;
  bool step_to(double part, std::span<const double> goal);
  bool correct(double most);
  Status give_up(double reached, std::span<const double> goal);

  Constraints constraints_;
  numerics::SparseLu factors_;
  std::vector<double> q_, base_, start_;
  std::vector<double> first_, second_;  // derivatives along the rest of a move
  std::vector<double> newton_;
  std::vector<double> held_, target_, held_at_start_;
  bool assembled_ = false;
  Gap gap_;
};

}  // namespace loadpath::mechanism
