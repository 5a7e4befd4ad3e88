#include "lib/project/sweep/sweep.hpp"

#include "lib/sweep/ordered.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

/// The number of blocks per part: few enough that no thread waits long for another at the end.
std::uint64_t blocks_of_part(const SweepWork& work) {
  constexpr std::uint64_t most = 64, parts_of_a_thread = 8;
  return std::clamp(work.blocks.count() / (parts_of_a_thread * work.jobs), std::uint64_t{1}, most);
}

}  // namespace

SweepStatistics nothing_found(const SweepPlan& plan, const Project& project, const Keep& keep) {
  const bool compares = plan.space.count() > plan.space.samples();
  return {plan.inputs.size(), plan.columns.size(), verdict_columns(project).size(), compares ? plan.space.samples() : 0,
          keep};
}

PartSolver::PartSolver(const SweepWork& work) : PartSolver(work, work.read()) {}

PartSolver::PartSolver(const SweepWork& work, Project project)
    : rows_(work.rows),
      stop_(work.stop),
      none_(nothing_found(work.plan, project, work.keep)),
      solver_(work.plan, std::move(project)) {}

SweptPart PartSolver::solve(BlockRange blocks) {
  SweptPart done{blocks, none_, {}};
  for (std::uint64_t block = blocks.first; block < blocks.last; ++block) {
    if (stop_ != nullptr && *stop_) {
      done.blocks.last = block;
      break;
    }
    const SolvedBlock& solved = solver_.solve(block);
    done.found.add(solved);
    if (rows_) done.rows.push_back(solved);
  }
  return done;
}

void solve(const SweepWork& work, const std::function<bool(SweptPart&& part)>& take) {
  using Parts = sweep::Ordered<SweptPart>;
  const std::uint64_t size = blocks_of_part(work);
  Parts parts(0, (work.blocks.count() + size - 1) / size, work.jobs);
  parts.run(
      [&]() -> Parts::Worker {
        const auto solver = std::make_shared<PartSolver>(work);
        return [&work, size, solver](std::uint64_t part) {
          const std::uint64_t first = work.blocks.first + part * size;
          return solver->solve({first, std::min(first + size, work.blocks.last)});
        };
      },
      [&](std::uint64_t, SweptPart&& part) {
        const bool whole = part.blocks.count() == size || part.blocks.last == work.blocks.last;
        return take(std::move(part)) && whole;
      });
}

}  // namespace loadpath::project
