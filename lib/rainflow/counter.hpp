// Counts the cycles of a series in chunks: turning points, a gate, elimination of local cycles, and a stack. It takes
// the memory of a block and of the residue, and finds the same cycles for any division of the series.
#pragma once

#include "lib/rainflow/cycle.hpp"
#include "lib/rainflow/elimination.hpp"
#include "lib/rainflow/gate.hpp"
#include "lib/rainflow/loops.hpp"
#include "lib/rainflow/rules.hpp"
#include "lib/rainflow/turning_points.hpp"
#include "lib/text/issue.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace loadpath::rainflow {

class Stack;

class Counter {
 public:
  /// The kind of input: a history, or one period that begins and ends at its largest magnitude.
  enum class Course { once, period };

  /// Rules without a contradiction; the consumer outlives the counter. The residue of a period needs no rule: by the
  /// four-point method the three remaining points are one cycle, by the others it has closed.
  Counter(const Rules& rules, Consumer& consumer, Course course = Course::once);
  Counter(Counter&&) = delete;
  ~Counter();

  /// A Fault whose `at` is the sample, counted from 0, if one is not finite or beyond 8e307: the counts are then
  /// void.
  std::optional<Fault> feed(std::span<const double> samples);
  /// The end of the series: its last value, and the residue by its rule.
  void finish();

  [[nodiscard]] std::uint64_t samples() const { return turning_points_.samples(); }
  /// The turning points that have not closed; of a finished series with their rule applied or not.
  [[nodiscard]] Points residue() const;

 private:
  void fill(std::size_t count);
  void count_block(std::size_t count);
  [[nodiscard]] std::uint64_t* places() { return rules_.placed ? at_.data() + filled_ : nullptr; }

  Rules rules_;
  Course course_;
  Consumer* consumer_;
  TurningPoints turning_points_;
  Gate gate_;
  Elimination elimination_;
  std::unique_ptr<Stack> stack_;
  std::vector<double> values_, next_values_;  // turning points that wait for a block of them
  std::vector<std::uint64_t> at_;             // their places
  std::size_t filled_ = 0;
};

/// Counts one period of a repeating history, from its largest magnitude round to it: only full cycles, by the method
/// and the omission level of the rules. Places are those of the period as given; a cycle over its end begins at a
/// later place than it ends.
std::optional<Fault> count_periodic(std::span<const double> period, const Rules& rules, Consumer& consumer);

}  // namespace loadpath::rainflow
