// The search of the section tables (at most 5 ms) and that of the lightest column, the rows being read.
#include "calculators/column/lightest/lightest.hpp"
#include "lib/table/library.hpp"
#include "lib/table/search.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace loadpath;

void where_and_sort(benchmark::State& state) {
  const auto tables = table::tables_in("sections");
  std::size_t found = 0;
  for ([[maybe_unused]] auto _ : state) {
    const auto condition = table::read_condition("I_min >= 300 cm^4 and h <= 200 mm", tables);
    const auto order = table::read_order("mass", tables);
    found = table::search(tables, *condition, *order).size();
    benchmark::DoNotOptimize(found);
  }
  state.counters["found"] = static_cast<double>(found);
}

column::Lightest::Input column_of(std::initializer_list<const char*> families) {
  column::Lightest::Input in;
  for (const char* family : families) in.families.push_back({family});
  in.P = 900.0 * kN, in.l = 4.5 * m, in.ends = column::Ends::pinned_pinned;
  in.E = 210.0 * GPa, in.R_e = 235.0 * MPa;
  in.method = column::Method::ec3, in.gamma_M1 = in.gamma_F = 1.0;
  return in;
}

void lightest(benchmark::State& state, std::initializer_list<const char*> families) {
  const auto in = column_of(families);
  NoTrace trace;
  double tried = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    const auto r = column::Lightest::evaluate(in, trace);
    tried = r.sections;
    benchmark::DoNotOptimize(r.u);
  }
  state.counters["sections"] = tried;
}

}  // namespace

BENCHMARK(where_and_sort);
BENCHMARK_CAPTURE(lightest, one_family, {"HEA"});
BENCHMARK_CAPTURE(lightest, all_families, {"IPE", "HEA", "HEB", "HEM", "UPN", "UPE", "L", "RHS", "SHS", "W"});
BENCHMARK_MAIN();
