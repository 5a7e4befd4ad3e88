// The points of a sweep block by block, on several threads, in their order.
#pragma once

#include "lib/project/sweep/plan.hpp"
#include "lib/project/sweep/variants.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace loadpath::project {

/// Points of a block. It does not follow from the machine: what is added up is added up by blocks.
constexpr std::uint64_t block_size = 128;

struct SolvedBlock {
  std::uint64_t first = 0;  // point
  std::size_t count = 0;
  std::vector<std::vector<double>> inputs, results;  // column by column
  std::vector<Refusal> refusals;
};

/// Reads the project again: every thread has one of its own.
using ReadAgain = std::function<Project()>;

struct BlockRange {
  std::uint64_t first = 0, last = 0;  // blocks
};
/// All blocks of a plan.
BlockRange all_blocks(const SweepPlan& plan);
/// The share K of N, counted from 1: as many blocks in each as in any other, but for one.
BlockRange shard_of(BlockRange all, std::uint64_t k, std::uint64_t n);

/// Solves the blocks with `jobs` threads; `take` is given them in their order, and ends the sweep with false.
void solve_blocks(const SweepPlan& plan, const ReadAgain& read, const std::vector<std::string>& results,
                  BlockRange blocks, unsigned jobs, const std::function<bool(const SolvedBlock& block)>& take);

}  // namespace loadpath::project
