#include "lib/project/sweep/blocks.hpp"

#include "lib/sweep/ordered.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

/// The solver of one thread.
class Solver {
 public:
  Solver(const SweepPlan& plan, Project project, const std::vector<std::string>& results)
      : plan_(plan), variants_(std::move(project), results) {}

  SolvedBlock solve(std::uint64_t block) {
    SolvedBlock solved;
    solved.first = block * block_size;
    solved.count = static_cast<std::size_t>(std::min(block_size, plan_.space.count() - solved.first));
    const std::vector<double*> in = columns(solved.inputs, variants_.inputs(), solved.count);
    const std::vector<double*> out = columns(solved.results, variants_.outputs(), solved.count);
    plan_.fill(solved.first, solved.count, in);
    const std::vector<const double*> given(in.begin(), in.end());
    variants_.evaluate(given, out, solved.count);
    solved.refusals = variants_.refusals();
    return solved;
  }

 private:
  static std::vector<double*> columns(std::vector<std::vector<double>>& all, std::size_t count, std::size_t rows) {
    all.assign(count, std::vector<double>(rows));
    std::vector<double*> starts;
    for (std::vector<double>& column : all) starts.push_back(column.data());
    return starts;
  }

  const SweepPlan& plan_;
  Variants variants_;
};

}  // namespace

BlockRange all_blocks(const SweepPlan& plan) { return {0, (plan.space.count() + block_size - 1) / block_size}; }

BlockRange shard_of(BlockRange all, std::uint64_t k, std::uint64_t n) {
  const std::uint64_t blocks = all.last - all.first, each = blocks / n, more = blocks % n;
  const auto start = [&](std::uint64_t i) { return all.first + i * each + std::min(i, more); };
  return {start(k - 1), start(k)};
}

void solve_blocks(const SweepPlan& plan, const ReadAgain& read, const std::vector<std::string>& results,
                  BlockRange blocks, unsigned jobs, const std::function<bool(const SolvedBlock& block)>& take) {
  using Parts = sweep::Ordered<SolvedBlock>;
  Parts parts(blocks.first, blocks.last, jobs);
  parts.run(
      [&]() -> Parts::Worker {
        const auto solver = std::make_shared<Solver>(plan, read(), results);
        return [solver](std::uint64_t block) { return solver->solve(block); };
      },
      [&](std::uint64_t, SolvedBlock&& block) { return take(block); });
}

}  // namespace loadpath::project
