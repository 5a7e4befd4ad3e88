// A cycle of 720 positions through the general solver, beside closed forms written for the one linkage.
// Per position: coordinates, velocities, accelerations, all reactions, driving moment, equilibrium and power balance.
#include "tests/bench/hand_written_linkages.hpp"
#include "tests/lib/mechanism/models.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace {

using namespace loadpath::mechanism;

constexpr int positions = 720;
constexpr double speed = 100.0;
constexpr double step = 2.0 * std::numbers::pi / positions;

template <class Linkage>
double hand_written_cycle(Linkage& linkage) {
  double sum = 0.0;
  for (int k = 0; k < positions; ++k) {
    sum += linkage.solve(0.3 + k * step, speed);
    benchmark::DoNotOptimize(linkage);
  }
  return sum;
}

double ns_per_position(std::chrono::steady_clock::duration cycle) {
  return std::chrono::duration<double, std::nano>(cycle).count() / positions;
}

// The fastest of many cycles: the machine may be busy with something else.
template <class Cycle>
double fastest(Cycle cycle) {
  using clock = std::chrono::steady_clock;
  auto best = clock::duration::max();
  for (int k = 0; k < 200; ++k) {
    const auto start = clock::now();
    benchmark::DoNotOptimize(cycle());
    best = std::min(best, clock::now() - start);
  }
  return ns_per_position(best);
}

class GeneralCycle {
 public:
  explicit GeneralCycle(const Model& model) : system_(model), at_(system_.blank()) {
    closed_ = system_.assemble() == Status::closed;
  }
  double operator()() {
    double sum = 0.0;
    for (int k = 0; k < positions; ++k) sum += effort(start_ + k * step);
    start_ += positions * step;
    return sum;
  }
  double effort(double phi) {
    const Drive drive{phi, speed, 0.0};
    closed_ = closed_ && system_.solve({&drive, 1}, at_) == Status::closed;
    return at_.effort[0];
  }
  [[nodiscard]] bool closed() const { return closed_; }

 private:
  WholeSystem system_;
  Position at_;
  double start_ = 0.3;
  bool closed_ = false;
};

template <class Linkage>
void compare(benchmark::State& state, const Model& model) {
  GeneralCycle general(model);
  Linkage linkage;
  if (std::abs(general.effort(1.0) - linkage.solve(1.0, speed)) > 1e-9) {
    state.SkipWithError("the closed form and the solver disagree");
    return;
  }
  for (auto _ : state) benchmark::DoNotOptimize(general());
  if (!general.closed()) state.SkipWithError("the mechanism does not close");
  const double solver = fastest([&] { return general(); });
  const double floor = fastest([&] { return hand_written_cycle(linkage); });
  state.counters["ns"] = solver;
  state.counters["ns_by_hand"] = floor;
  state.counters["ratio"] = solver / floor;
}

void slider_crank(benchmark::State& state) { compare<hand_written::SliderCrank>(state, models::slider_crank()); }
void four_bar(benchmark::State& state) { compare<hand_written::FourBar>(state, models::four_bar()); }
void six_bar(benchmark::State& state) { compare<hand_written::SixBar>(state, models::six_bar()); }

}  // namespace

BENCHMARK(slider_crank);
BENCHMARK(four_bar);
BENCHMARK(six_bar);
BENCHMARK_MAIN();
