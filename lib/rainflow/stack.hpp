// A method of counting with its residue, without its type.
#pragma once

#include "lib/rainflow/cycle.hpp"
#include "lib/rainflow/loops.hpp"
#include "lib/rainflow/rules.hpp"

#include <memory>

namespace loadpath::rainflow {

class Stack {
 public:
  explicit Stack(Consumer& consumer) : loops_(consumer) {}
  Stack(Stack&&) = delete;
  virtual ~Stack() = default;

  virtual void push(const Points& points) = 0;
  [[nodiscard]] virtual Points residue() const = 0;
  /// Counts the residue by a rule that suits the method.
  virtual void count_residue(Residue rule) = 0;
  void hand_over() { loops_.hand_over(); }

  static std::unique_ptr<Stack> by(const Rules& rules, bool period, Consumer& consumer);

 protected:
  Loops loops_;
};

}  // namespace loadpath::rainflow
