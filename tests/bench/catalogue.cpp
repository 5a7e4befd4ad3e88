// Cost of one point of a sweep, for every calculator of the catalogue at the input of its example.
#include "calculators/catalogue.hpp"

#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/bench/sweep.hpp"

#include <cmath>

namespace {

using namespace loadpath;
using namespace loadpath::bench;

/// The input of the example, with what rows of tables have filled.
Record example_of(const Calculator& c) {
  std::vector<Issue> issues;
  project::Project p = project::read_project(c.example, "example.toml", catalogue(), issues);
  project::solve(p, issues);
  Record input = p.steps[0]->input().reading.record.clone();
  for (const account::Entry& e : p.steps[0]->account().inputs) {
    const Leaf leaf = find_leaf(input, e.path);
    if (leaf && leaf.field->get != nullptr && std::isnan(leaf.get()) && e.value.si.size() == 1) leaf.set(e.value.si[0]);
  }
  return input;
}

void point(benchmark::State& state, const Calculator* c) {
  const Record input = example_of(*c);
  for ([[maybe_unused]] auto _ : state) {
    c->sweep(input.data.get(), {}, {}, points);
    benchmark::ClobberMemory();
  }
  state.counters["points"] =
      benchmark::Counter(static_cast<double>(points), benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

int main(int argc, char** argv) {
  for (const Calculator* c : calculators()) {
    if (c->sweep != nullptr) benchmark::RegisterBenchmark(c->id, point, c);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
