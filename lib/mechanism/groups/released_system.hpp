// Solves any mechanism that `diagnose` accepts, including overconstrained ones: redundant constraints are released at
// the current position (release.hpp), and chosen again where the remaining ones become nearly dependent, so that a
// third crank carries a parallelogram over its change points as in reality.
#pragma once

#include "lib/mechanism/groups/system.hpp"

#include <memory>
#include <span>

namespace loadpath::mechanism {

class ReleasedSystem {
 public:
  /// `redundant`: whether `analyse` has found joints that hold too much.
  ReleasedSystem(const Model& model, bool redundant);
  ~ReleasedSystem();
  ReleasedSystem(ReleasedSystem&&) noexcept;

  // As those of GroupSystem. A position of an overconstrained mechanism has one of its possible sets of reactions:
  // `uniqueness` states which of them are unique.
  Status assemble();
  [[nodiscard]] double coordinate(std::size_t driver) const;
  Status solve(std::span<const Drive> drives, Position& out, bool statics = false);
  [[nodiscard]] bool followed_in_steps() const;
  void take_friction(FrictionTaken taken);
  [[nodiscard]] bool some_joint_rests() const;
  void set_load(std::size_t load, Vec force, double moment);
  [[nodiscard]] Gap gap() const;

  /// The determinate mechanism that the last position was solved as, its loads as they are now.
  [[nodiscard]] const Model& model() const;
  /// Changes whenever `model` has become another one.
  [[nodiscard]] int release_number() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace loadpath::mechanism
