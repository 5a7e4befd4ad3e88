// The points of a sweep on several threads: blocks of them, in parts that are handed on in their order.
#pragma once

#include "lib/project/sweep/plan.hpp"
#include "lib/project/sweep/variants.hpp"
#include "lib/sweep/threaded.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace loadpath::project {

/// Points of a block. Independent of the computer, because sums are accumulated by blocks.
constexpr std::uint64_t block_size = 256;

struct SolvedBlock {
  std::uint64_t first = 0;  // point
  std::size_t count = 0;
  std::vector<std::vector<double>> inputs, results;  // column by column; requested results, then verdicts
  std::vector<Refusal> refusals;
};

/// Reads the project again: every thread has a project.
using ReadAgain = std::function<Project()>;

/// How a search evaluates its points.
struct Searching {
  ReadAgain read;
  unsigned jobs = 1;                                         // threads
  std::function<void(std::uint64_t points)> show = nullptr;  // progress: the points evaluated so far
};

struct BlockRange {
  std::uint64_t first = 0, last = 0;  // blocks
  [[nodiscard]] std::uint64_t count() const { return last - first; }
};
/// All blocks of a plan.
BlockRange all_blocks(const SweepPlan& plan);

/// The points of a search in its threads; `variants` works in the caller's, with these columns of results.
sweep::Threaded in_threads(Variants& variants, const Searching& searching, std::vector<std::string> results);

/// The solver of one thread.
class BlockSolver {
 public:
  BlockSolver(const SweepPlan& plan, Project project);
  /// The same object at every call.
  const SolvedBlock& solve(std::uint64_t block);

 private:
  const SweepPlan& plan_;
  Variants variants_;
  SolvedBlock solved_;
};

}  // namespace loadpath::project
