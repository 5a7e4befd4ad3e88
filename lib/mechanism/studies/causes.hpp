// Causes of the forces: every reaction and effort at a position, split exactly into the shares of all weights, of the
// inertia of each link, of each load and spring, and of the forces induced by each joint's reaction (friction, tooth
// forces, slack sides). The equations of equilibrium are linear in the loads, so the shares sum to the total.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"
#include "lib/mechanism/proof/forces.hpp"
#include "lib/mechanism/proof/virtual_motions.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

struct Cause {
  enum class Kind { weights, inertia, load, spring, induced };
  Kind kind = Kind::weights;
  std::size_t index = 0;  // index of the link, the load, the spring, or the joint that induces it
};

class CauseSplit {
 public:
  /// The model is referred to: its loads may change between positions.
  explicit CauseSplit(const Model& model);

  /// All that the model can have: weights first, then links, loads, springs and joints in their order.
  [[nodiscard]] std::span<const Cause> causes() const { return causes_; }
  /// Splits a solved position. False if the position is singular to rounding. Takes no memory.
  [[nodiscard]] bool find(const Position& at, bool statics = false);
  /// The reactions, at the position's pins, and the efforts due to one cause. Induced forces are taken at their
  /// amounts there, and count with the joint that induces them.
  [[nodiscard]] const Forces& share(std::size_t cause) const { return shares_[cause]; }

 private:
  [[nodiscard]] std::size_t cause_of(const ActiveForce& force) const;
  void find_share(std::size_t cause);

  Instant instant_;
  VirtualMotions motions_;
  std::vector<Cause> causes_;
  std::size_t first_load_ = 0, first_spring_ = 0;
  std::vector<std::size_t> induced_;  // by joint, among the causes
  std::vector<Forces> shares_;
  std::vector<double> multipliers_;
};

}  // namespace loadpath::mechanism
