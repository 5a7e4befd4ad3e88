// A shaft of twelve pieces with eight notches: once through, and its diameters found together.
#include "calculators/catalogue.hpp"
#include "calculators/shaft/design/design.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace {

using namespace loadpath;

constexpr std::array lengths{40, 30, 25, 40, 30, 60, 30, 40, 25, 30, 30, 40};  // mm
constexpr std::array stepped{1, 2, 3, 4, 6, 7, 8, 9};                          // pieces that end with a shoulder

/// Diameters that are searched for, or from 40 mm at the ends up to the middle.
std::string shaft(bool sought, const std::string& more) {
  std::string pieces, notches;
  int x = 0, d = 40;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const std::string size = sought ? "?" : std::to_string(d) + " mm";
    pieces += "{ l = \"" + std::to_string(lengths[i]) + " mm\", d = \"" + size + "\" }, ";
    x += lengths[i];
    if (std::find(stepped.begin(), stepped.end(), static_cast<int>(i)) == stepped.end()) continue;
    notches += "{ x = \"" + std::to_string(x) + " mm\", kind = \"shoulder\", r = \"1 mm\" }, ";
    d += i < 5 ? 4 : -4;
  }
  return "[axle]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\nn = \"500 "
         "rpm\"\npieces = [" +
         pieces + "]\nnotches = [" + notches +
         "]\nsupports = [{ x = \"55 mm\", holds = \"both\" }, { x = \"365 mm\" }]\nseats = [{ x = \"20 mm\", way = "
         "\"balances\", mass = \"3 kg\", J = \"0.01 kg*m^2\" }, { x = \"190 mm\", T = \"400 N*m\", F_x = \"-2400 N\", "
         "F_y = "
         "\"6400 N\", x_w = \"62.5 mm\", mass = \"4 kg\", J = \"0.01 kg*m^2\" }]\nS_F = 1.5\nS_D = 1.5\nr_T = 0\nv_adm "
         "= "
         "\"0.1 mm\"\n" +
         more;
}

project::Project read(bool sought, const std::string& more = "") {
  std::vector<Issue> issues;
  return project::read_project(shaft(sought, more), "bench.toml", catalogue(), issues);
}

/// The input as it is solved, with the strengths that the material has.
Record solved_input(const std::string& more = "") {
  project::Project project = read(false, more);
  std::vector<Issue> issues;
  project::solve(project, issues);
  Record in = project.find("axle")->input().reading.record.clone();
  for_each_leaf(in, [&](const std::string& path, const Leaf& leaf) {
    const Value* const known = leaf.field->is_number() ? project.value("axle." + path) : nullptr;
    if (known != nullptr) leaf.set(known->si[0]);
  });
  return in;
}

void once_through(benchmark::State& state) {
  const Calculator& design = erased<shaft::Design>();
  const Record in = solved_input();
  Record out(*design.result);
  for (auto _ : state) design.evaluate(in.data.get(), out.data.get());
}

void all_schools_with_trace(benchmark::State& state) {
  const Calculator& design = erased<shaft::Design>();
  const Record in = solved_input("R_z = \"6.3 um\"\n");
  Record out(*design.result);
  for (auto _ : state) {
    Trace trace;
    design.explain(in.data.get(), out.data.get(), trace);
  }
}

/// With all that solving does in addition to the search; the search alone is the difference to given_sizes.
void solve(benchmark::State& state, bool sought) {
  for (auto _ : state) {
    project::Project project = read(sought);
    std::vector<Issue> issues;
    project::solve(project, issues);
    benchmark::DoNotOptimize(project.value("axle.mass"));
  }
}
void all_sizes(benchmark::State& state) { solve(state, true); }
void given_sizes(benchmark::State& state) { solve(state, false); }

BENCHMARK(once_through)->Unit(benchmark::kMicrosecond);
BENCHMARK(all_schools_with_trace)->Unit(benchmark::kMicrosecond);
BENCHMARK(given_sizes)->Unit(benchmark::kMillisecond);
BENCHMARK(all_sizes)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
