// What the benchmarks of sweeps share: columns in SI, a calculator's sweep over them, and the time of its fastest run.
#pragma once

#include "lib/calculator/calculator.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace loadpath::bench {

constexpr std::size_t points = 1000;

inline std::vector<double> spread(double low, double high, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(low, high);
  std::vector<double> column(points);
  for (double& x : column) x = between(random);
  return column;
}

/// The place of a leaf inside its record.
inline std::size_t offset_of(const Record& record, const std::string& path) {
  const Leaf leaf = find_leaf(record, path);
  return static_cast<std::size_t>(reinterpret_cast<const char*>(leaf.field->address(leaf.owner)) -
                                  static_cast<const char*>(record.data.get()));
}

/// A calculator's sweep over columns of its input, with a column for each result.
class Sweep {
 public:
  struct Varied {
    std::string path;
    const std::vector<double>& column;
  };
  Sweep(const Calculator& calculator, Record input, const std::vector<Varied>& varied,
        const std::vector<std::string>& results, std::vector<std::vector<double>>& columns)
      : calculator_(calculator), input_(std::move(input)) {
    for (const auto& [path, column] : varied) in_.push_back({offset_of(input_, path), column.data()});
    const Record result(*calculator.result);
    columns.assign(results.size(), std::vector<double>(points));
    for (std::size_t k = 0; k < results.size(); ++k) out_.push_back({offset_of(result, results[k]), columns[k].data()});
  }
  void operator()() const { calculator_.sweep(input_.data.get(), in_, out_, points); }

 private:
  const Calculator& calculator_;
  Record input_;
  std::vector<InputColumn> in_;
  std::vector<ResultColumn> out_;
};

template <class C>
Record record_of(const typename C::Input& input) {
  Record record(*erased<C>().input);
  *static_cast<typename C::Input*>(record.data.get()) = input;
  return record;
}

template <class Run>
double ns_per_point(Run& run) {
  using clock = std::chrono::steady_clock;
  const auto start = clock::now();
  run();
  benchmark::ClobberMemory();
  return std::chrono::duration<double, std::nano>(clock::now() - start).count() / static_cast<double>(points);
}

/// Times `swept` beside `by_hand`. The fastest of many runs in turn: the machine may be busy with something else.
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

/// Beside a loop in wide registers too, which computes the same.
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
