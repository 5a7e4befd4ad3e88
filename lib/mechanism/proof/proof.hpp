// The proof of a position: its reactions and efforts found again by methods that share neither equations nor unknowns
// with one another, and the residuals of the equilibrium of each link and of the power balance.
#pragma once

#include "lib/mechanism/proof/all_equations.hpp"
#include "lib/mechanism/proof/balance.hpp"
#include "lib/mechanism/proof/motion.hpp"
#include "lib/mechanism/proof/opened_chain.hpp"
#include "lib/mechanism/proof/virtual_work.hpp"
#include "lib/mechanism/proof/zhukovsky.hpp"

#include <array>
#include <span>

namespace loadpath::mechanism {

struct Proof {
  enum Method { whole_system, virtual_power, zhukovsky, released_constraints, opened_chain };
  static constexpr std::size_t methods = 5;
  /// Up to this share of the largest force times the condition number, residuals are rounding errors.
  static constexpr double tolerance = 1e-10;

  /// Largest difference between a method and the position, N; moments over the mechanism's characteristic length.
  std::array<double, methods> disagreement{};
  Residuals residuals;
  double unbalanced = 0.0;     // the largest residual of a link, N, moments likewise
  double motion = 0.0;         // maximum error of positions, velocities and accelerations, `motion.hpp`
  double largest_force = 0.0;  // largest of reactions, efforts and active forces, N, moments likewise
  double condition = 1.0;      // number of the position, 1-norm, at least 1

  /// A fraction of the largest force times the condition number. Unknown values are NaN.
  [[nodiscard]] double part(double force) const;
  [[nodiscard]] double part(Method method) const { return part(disagreement[method]); }
  /// Whether the motion, all methods and the equilibrium of every link agree within the tolerance.
  [[nodiscard]] bool trustworthy() const;
};

/// Proves positions of one model, one after the other. The model is referred to: its loads may change in between.
class Prover {
 public:
  explicit Prover(const Model& model);
  /// Takes positions of this model, of the same structure, from now on.
  void take_dimensions(const Model& model) { instant_.take_dimensions(model); }
  /// `statics`: without inertia.
  Proof prove(std::span<const Drive> drives, bool statics, const Position& at);

 private:
  void compare(Proof::Method method, Proof& proof) const;
  void compare_effort(Proof::Method method, std::size_t driver, double effort, Proof& proof) const;
  [[nodiscard]] double largest_force(const Position& at) const;
  [[nodiscard]] double largest_residual(const Residuals& residuals) const;

  Instant instant_;
  MotionProof motion_;
  AllEquations equations_;
  ReleasedConstraints released_;
  OpenedChain chain_;
  ZhukovskyLever lever_;
  Forces forces_;
};

}  // namespace loadpath::mechanism
