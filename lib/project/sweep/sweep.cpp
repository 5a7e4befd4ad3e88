#include "lib/project/sweep/sweep.hpp"

#include "lib/sweep/ordered.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

/// So many blocks go through one thread at once that none waits long for another at the end.
std::uint64_t blocks_of_part(const SweepWork& work) {
  constexpr std::uint64_t most = 64, parts_of_a_thread = 8;
  return std::clamp(work.blocks.count() / (parts_of_a_thread * work.jobs), std::uint64_t{1}, most);
}

}  // namespace

Found nothing_found(const SweepPlan& plan, const Project& project, const Keep& keep) {
  return {plan.inputs.size(), plan.columns.size(), verdict_columns(project).size(), keep};
}

void solve(const SweepWork& work, const std::function<bool(SweptPart&& part)>& take) {
  using Parts = sweep::Ordered<SweptPart>;
  const std::uint64_t size = blocks_of_part(work);
  Parts parts(0, (work.blocks.count() + size - 1) / size, work.jobs);
  parts.run(
      [&]() -> Parts::Worker {
        Project project = work.read();
        const Found none = nothing_found(work.plan, project, work.keep);
        const auto solver = std::make_shared<BlockSolver>(work.plan, std::move(project));
        return [&work, size, none, solver](std::uint64_t part) {
          const std::uint64_t first = work.blocks.first + part * size;
          SweptPart done{{first, std::min(first + size, work.blocks.last)}, none, {}};
          for (std::uint64_t block = done.blocks.first; block < done.blocks.last; ++block) {
            const SolvedBlock& solved = solver->solve(block);
            done.found.add(solved);
            if (work.rows) done.rows.push_back(solved);
          }
          return done;
        };
      },
      [&](std::uint64_t, SweptPart&& part) { return take(std::move(part)); });
}

}  // namespace loadpath::project
