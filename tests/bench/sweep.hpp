// The time of the fastest run of a sweep, compared with that of a handwritten loop.
#pragma once

#include "tests/bench/columns.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

namespace loadpath::bench {

template <class Run>
double ns_per_point(Run& run) {
  using clock = std::chrono::steady_clock;
  const auto start = clock::now();
  run();
  benchmark::ClobberMemory();
  return std::chrono::duration<double, std::nano>(clock::now() - start).count() / static_cast<double>(points);
}

/// Times `swept` and `by_hand` alternately. The fastest of many runs: the computer may be busy with other work.
template <class Swept, class ByHand>
void compare(benchmark::State& state, Swept swept, ByHand by_hand) {
  for (auto _ : state) {
    swept();
    benchmark::ClobberMemory();
  }
  double general = ns_per_point(swept), floor = ns_per_point(by_hand);
  for (int k = 0; k < 500; ++k) {
    general = std::min(general, ns_per_point(swept));
    floor = std::min(floor, ns_per_point(by_hand));
  }
  state.counters["ns"] = general;
  state.counters["ns_by_hand"] = floor;
  state.counters["ratio"] = general / floor;
  state.counters["M_per_s"] = 1e3 / general;
}

/// Compares with a loop in wide registers too, which computes the same.
template <class InLanes>
void compare_in_lanes(benchmark::State& state, InLanes in_lanes) {
  double floor = ns_per_point(in_lanes);
  for (int k = 0; k < 500; ++k) floor = std::min(floor, ns_per_point(in_lanes));
  state.counters["ns_in_lanes"] = floor;
  state.counters["ratio_in_lanes"] = state.counters["ns"] / floor;
}

/// Columns of results agree to a part of their value.
struct Agree {
  double within;
  bool operator()(const std::vector<double>& a, const std::vector<double>& b) const {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](double x, double y) { return x > 0.0 && std::abs(x - y) <= within * y; });
  }
};
/// To rounding.
inline constexpr Agree agree{1e-14};

}  // namespace loadpath::bench
