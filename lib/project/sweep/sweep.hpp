// A running sweep: threads solve its points, and the results are merged in the order of the points.
#pragma once

#include "lib/project/sweep/statistics.hpp"

#include <atomic>
#include <functional>

namespace loadpath::project {

/// A part of a sweep that is done.
struct SweptPart {
  BlockRange blocks;
  SweepStatistics found;
  std::vector<SolvedBlock> rows;  // if requested
};

struct SweepWork {
  const SweepPlan& plan;
  ReadAgain read;
  Keep keep;
  BlockRange blocks;  // blocks to be solved
  unsigned jobs = 1;
  bool rows = false;                        // whether individual points are requested
  const std::atomic<bool>* stop = nullptr;  // ends the work between two blocks, once it is true
};

/// Solves parts in one thread, with a project that it has read itself.
class PartSolver {
 public:
  explicit PartSolver(const SweepWork& work);
  /// If stopped, the blocks finished so far: see `blocks` of the part.
  [[nodiscard]] SweptPart solve(BlockRange blocks);

 private:
  PartSolver(const SweepWork& work, Project project);

  bool rows_;
  const std::atomic<bool>* stop_;
  SweepStatistics none_;
  BlockSolver solver_;
};

/// An empty result.
SweepStatistics nothing_found(const SweepPlan& plan, const Project& project, const Keep& keep);

/// Solves the blocks; `take` is given the parts in their order, and ends the work with false.
void solve(const SweepWork& work, const std::function<bool(SweptPart&& part)>& take);

}  // namespace loadpath::project
