// The equilibrium with forces that the reactions bring with them (induced_source.hpp): they change the reactions that
// induce them.
#pragma once

#include "lib/mechanism/forces/induced_source.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"
#include "lib/numerics/small_lu.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// The modes at these amounts.
struct Induced {
  std::span<const InducedMode> modes = {};
  std::span<const double> amounts = {};
};

class InducedForces {
 public:
  /// The model must outlive this.
  explicit InducedForces(const Model& model);

  [[nodiscard]] bool none() const { return modes_.empty(); }
  /// The result of the last `solve`.
  [[nodiscard]] Induced found() const { return {modes_, amounts_}; }
  [[nodiscard]] std::span<const InducedSource> sources() const { return sources_; }
  /// Whether a joint with friction was at rest there, so that `FrictionTaken` determined its direction, or nothing
  /// did.
  [[nodiscard]] bool some_rest() const { return some_rest_; }

  /// Finds the amounts at a position whose poses and velocities are known, and adds them to its reactions.
  /// `find_forces(induced)` fills its reactions and efforts in equilibrium with the induced forces. False if the
  /// mechanism jams: as friction grows from nothing, beyond some point no force of the drives moves it.
  /// `friction.resting`: for the joints that rest while others move. In a mechanism entirely at rest without
  /// impending motion, there is no friction, because its direction is not known.
  template <class FindForces>
  [[nodiscard]] bool solve(Position& at, FindForces find_forces, FrictionTaken friction = {}) {
    start(at, friction.resting);
    find_influences(at, find_forces);
    for (int part = 1; part <= parts_; ++part) {
      if (!find_amounts(friction.share * static_cast<double>(part) / parts_)) return false;
    }
    find_forces(Induced{modes_, amounts_});
    add_to(at);
    return true;
  }

 private:
  void start(const Position& at, Resting resting);
  [[nodiscard]] RestLimits limits(const Position& at) const;

  /// Reactions are linear in the amounts: those without any, and the effect of one more of each.
  template <class FindForces>
  void find_influences(const Position& at, FindForces find_forces) {
    find_forces(Induced{modes_, amounts_});
    const double unit = take_free(at);
    for (std::size_t m = 0; m < amounts_.size(); ++m) {
      amounts_[m] = unit;
      find_forces(Induced{modes_, amounts_});
      take_influence(at, m);
      amounts_[m] = 0.0;
    }
  }
  double take_free(const Position& at);
  void take_influence(const Position& at, std::size_t mode);
  [[nodiscard]] std::span<const Reaction> influence(std::size_t mode) const {
    return std::span(influences_).subspan(mode * sources_.size(), sources_.size());
  }

  [[nodiscard]] bool find_amounts(double share);
  void find_reactions();
  void induce(std::span<const Reaction> by, double share);
  [[nodiscard]] bool is_settled() const;
  void fill_newton(double share);
  [[nodiscard]] bool step();
  void add_to(Position& at) const;
  [[nodiscard]] double largest(std::span<const Reaction> reactions) const;

  const Model& model_;
  std::vector<InducedSource> sources_;
  std::vector<InducedMode> modes_;
  std::vector<double> amounts_, induced_, before_;
  std::vector<Reaction> free_, by_, moved_;  // by source: at zero, at these, at neighbouring amounts
  std::vector<Reaction> influences_;         // per mode, the effect of a unit amount on each source
  double scale_ = 0.0;                       // N, of the reactions
  numerics::SmallLu newton_{0};
  double size_ = 1.0;  // size of the mechanism, m
  bool some_rest_ = false;
  int parts_ = 1;  // in which friction grows
};

}  // namespace loadpath::mechanism
