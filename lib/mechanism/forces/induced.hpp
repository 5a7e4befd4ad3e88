// The equilibrium with forces that the reactions bring with them (induced_source.hpp): they change the reactions that
// induce them.
#pragma once

#include "lib/mechanism/forces/induced_source.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"
#include "lib/numerics/small_lu.hpp"

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// Of the modes, at these amounts.
struct Induced {
  std::span<const InducedMode> modes = {};
  std::span<const double> amounts = {};
};

class InducedForces {
 public:
  /// The model must outlive this.
  explicit InducedForces(const Model& model);

  [[nodiscard]] bool none() const { return modes_.empty(); }
  /// Of the last `solve`.
  [[nodiscard]] Induced found() const { return {modes_, amounts_}; }
  [[nodiscard]] std::span<const InducedSource> sources() const { return sources_; }
  /// Whether a joint with friction was at rest there, so that `FrictionTaken` told its sense, or nothing did.
  [[nodiscard]] bool some_rest() const { return some_rest_; }

  /// Finds the amounts at a position whose poses and velocities are there, and adds them to its reactions.
  /// `find_forces(induced)` fills its reactions and efforts in equilibrium with what is induced. False where the
  /// mechanism jams: as friction grows from nothing, there comes a point from which on no force of the drives moves it.
  /// `friction.resting`: for the joints that rest while others move. In a mechanism that rests as a whole and is not
  /// about to move either, there is no friction, for its direction is not known.
  template <class FindForces>
  [[nodiscard]] bool solve(Position& at, FindForces find_forces, FrictionTaken friction = {}) {
    start(at, friction.resting);
    for (int part = 1; part <= parts_; ++part) {
      const double share = friction.share * static_cast<double>(part) / parts_;
      const auto induce_anew = [&] {
        find_forces(Induced{modes_, amounts_});
        induce(at, share);
      };
      if (!find_amounts(at, induce_anew)) return false;
    }
    add_to(at);
    return true;
  }

 private:
  void start(const Position& at, Resting resting);
  [[nodiscard]] RestLimits limits(const Position& at) const;
  void induce(const Position& at, double share);
  void add_to(Position& at) const;
  [[nodiscard]] bool is_settled(const Position& at) const;
  [[nodiscard]] bool step();

  /// Newton's iteration for amounts that induce themselves; what they induce is linear in them but for the signs.
  template <class InduceAnew>
  bool find_amounts(const Position& at, InduceAnew induce_anew) {
    constexpr int most_steps = 30;
    for (int k = 0; k < most_steps; ++k) {
      induce_anew();
      if (is_settled(at)) return true;
      before_ = induced_;
      const double little = 1e-6 * largest_force(at);
      for (std::size_t m = 0; m < amounts_.size(); ++m) {
        amounts_[m] += little;
        induce_anew();
        amounts_[m] -= little;
        for (std::size_t r = 0; r < amounts_.size(); ++r) {
          newton_.at(r, m) = (r == m ? 1.0 : 0.0) - (induced_[r] - before_[r]) / little;
        }
      }
      if (!step()) return false;
    }
    return false;
  }
  [[nodiscard]] static double largest_force(const Position& at);

  const Model& model_;
  std::vector<InducedSource> sources_;
  std::vector<InducedMode> modes_;
  std::vector<double> amounts_, induced_, before_;
  SmallLu newton_{0};
  double size_ = 1.0;  // of the mechanism, m
  bool some_rest_ = false;
  int parts_ = 1;  // in which friction grows
};

}  // namespace loadpath::mechanism
