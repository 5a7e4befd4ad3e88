// Solves any mechanism that `diagnose` accepts, those too that are held more than once: what is too much is released
// where the mechanism stands (release.hpp), and released anew where the chosen constraints lose their grip, so that a
// third crank carries a parallelogram over its change points as it does in the machine.
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

  // As those of GroupSystem. A position of a mechanism that is held more than once holds one of its possible sets of
  // reactions: `uniqueness` tells which of them are the only ones.
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
