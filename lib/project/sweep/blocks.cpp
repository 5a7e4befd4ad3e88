#include "lib/project/sweep/blocks.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

std::vector<double*> starts_of(std::vector<std::vector<double>>& columns, std::size_t rows) {
  std::vector<double*> starts;
  for (std::vector<double>& column : columns) {
    column.resize(rows);
    starts.push_back(column.data());
  }
  return starts;
}

std::vector<std::string> texts_of(const SweepPlan& plan) {
  std::vector<std::string> texts;
  for (const SweptResult& column : plan.columns) texts.push_back(column.name + " = " + column.text);
  return texts;
}

}  // namespace

BlockRange all_blocks(const SweepPlan& plan) { return {0, (plan.space.count() + block_size - 1) / block_size}; }

sweep::Threaded in_threads(Variants& variants, const Searching& searching, std::vector<std::string> results) {
  return {variants,
          [read = searching.read, results = std::move(results)] { return std::make_unique<Variants>(read(), results); },
          searching.jobs, searching.show};
}

BlockSolver::BlockSolver(const SweepPlan& plan, Project project)
    : plan_(plan), variants_(std::move(project), texts_of(plan)) {
  solved_.inputs.resize(variants_.inputs());
  solved_.results.resize(variants_.outputs());
}

const SolvedBlock& BlockSolver::solve(std::uint64_t block) {
  solved_.first = block * block_size;
  solved_.count = static_cast<std::size_t>(std::min(block_size, plan_.space.count() - solved_.first));
  const std::vector<double*> in = starts_of(solved_.inputs, solved_.count);
  const std::vector<double*> out = starts_of(solved_.results, solved_.count);
  plan_.fill(solved_.first, solved_.count, in);
  const std::vector<const double*> given(in.begin(), in.end());
  variants_.evaluate(given, out, solved_.count);
  solved_.refusals = variants_.refusals();
  return solved_;
}

}  // namespace loadpath::project
