// Cycles that close locally: a range smaller than the one before it, and not larger than the one after it.
// Eliminating these block by block, without unpredictable branches, leaves only a few for the stack of a counter.
#pragma once

#include "lib/rainflow/comparisons.hpp"
#include "lib/rainflow/cycle.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace loadpath::rainflow {

class Elimination {
 public:
  /// For blocks of up to `largest` turning points.
  Elimination(std::size_t largest, Instructions instructions);

  /// Returns how many of `points`, alternately rising and falling, are left; they stay in their order. `points` has
  /// room for 128 more, which are overwritten. `closed` gets the eliminated loops.
  std::size_t reduce(double* points, std::size_t count);
  [[nodiscard]] std::span<const Loop> closed() const { return {closed_.data(), closed_count_}; }

 private:
  std::size_t pass(double* points, std::size_t count);

  Instructions instructions_;
  std::vector<std::uint64_t> smaller_;  // a bit for each range
  std::vector<Loop> closed_;
  std::size_t closed_count_ = 0;
};

}  // namespace loadpath::rainflow
