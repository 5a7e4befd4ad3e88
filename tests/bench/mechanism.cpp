// A cycle of 720 positions through the general solvers, by groups and by the full system at once, next to closed
// forms written for the one linkage. Per position: coordinates, velocities, accelerations, all reactions, driving
// moment; in lanes all reactions and the driving moment, in columns. By groups at most 4 times as long as by hand.
#include "lib/mechanism/accuracy/sensitivity.hpp"
#include "lib/mechanism/columns/cycle.hpp"
#include "lib/mechanism/constraints/system.hpp"
#include "lib/mechanism/groups/system.hpp"
#include "lib/mechanism/studies/causes.hpp"
#include "tests/bench/hand_written_linkages.hpp"
#include "tests/lib/mechanism/models.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <vector>

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

template <class System>
class GeneralCycle {
 public:
  explicit GeneralCycle(const Model& model) : system_(model), at_(blank_position(model)) {
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
  [[nodiscard]] const Position& at() const { return at_; }
  [[nodiscard]] bool closed() const { return closed_; }

 private:
  System system_;
  Position at_;
  double start_ = 0.3;
  bool closed_ = false;
};

template <class System>
double measure(benchmark::State& state, GeneralCycle<System>& cycle) {
  const double ns = fastest([&] { return cycle(); });
  if (!cycle.closed()) state.SkipWithError("the mechanism does not close");
  return ns;
}

/// In the drive's effort and all joint forces, at some positions.
template <class System, class Linkage>
bool agree(GeneralCycle<System>& cycle, Linkage& linkage) {
  for (const double phi : {1.0, 1.5, 2.2, 3.0}) {
    if (!(std::abs(cycle.effort(phi) - linkage.solve(phi, speed)) < 1e-9)) return false;
    for (std::size_t k = 0; k < linkage.forces.size(); ++k) {
      const Vec apart = cycle.at().reactions[k].force - linkage.forces[k];
      if (!(length(apart) < 1e-9 * (1.0 + length(linkage.forces[k])))) return false;
    }
  }
  return true;
}

std::vector<Drive> whole_turn() {
  std::vector<Drive> drives;
  for (int k = 0; k < positions; ++k) drives.push_back({1.0 + k * step, speed, 0.0});
  return drives;
}

/// Cost of a variant: before the first position, and each position with all joint forces in columns.
struct InColumns {
  double ns_position = 0.0, ns_variant = 0.0;
  bool in_lanes = true;
};

InColumns in_columns(const Model& model) {
  InColumns result;
  const std::vector<Drive> drives = whole_turn();
  CycleColumns columns(model, drives.size());
  const double both = fastest([&] {
    const Status status = columns.take(model);
    result.in_lanes = columns.solve(drives) == Status::closed && columns.in_lanes() && result.in_lanes;
    return status;
  });
  result.ns_variant = positions * fastest([&] { return columns.take(model); });
  result.ns_position = both - result.ns_variant / positions;
  return result;
}

template <class Linkage>
void compare(benchmark::State& state, const Model& model) {
  GeneralCycle<GroupSystem> groups(model);
  GeneralCycle<WholeSystem> whole(model);
  Linkage linkage;
  if (!agree(groups, linkage) || !agree(whole, linkage)) {
    state.SkipWithError("the closed form and the solver disagree");
    return;
  }
  for (auto _ : state) benchmark::DoNotOptimize(groups());
  const double by_hand = fastest([&] { return hand_written_cycle(linkage); });
  const double by_groups = measure(state, groups);
  const double at_once = measure(state, whole);
  state.counters["ns_by_hand"] = by_hand;
  state.counters["ns_by_groups"] = by_groups;
  state.counters["ns_at_once"] = at_once;
  state.counters["groups_by_hand"] = by_groups / by_hand;
  state.counters["at_once_by_hand"] = at_once / by_hand;
  const InColumns columns = in_columns(model);
  if (!columns.in_lanes) state.SkipWithError("not in lanes");
  state.counters["ns_in_lanes"] = columns.ns_position;
  state.counters["lanes_by_hand"] = columns.ns_position / by_hand;
  state.counters["ns_of_variant"] = columns.ns_variant;
}

void slider_crank(benchmark::State& state) { compare<hand_written::SliderCrank>(state, models::slider_crank()); }
void four_bar(benchmark::State& state) { compare<hand_written::FourBar>(state, models::four_bar()); }
void six_bar(benchmark::State& state) { compare<hand_written::SixBar>(state, models::six_bar()); }

// Against the hand-written slider-crank, as these are not written by hand.
void alone(benchmark::State& state, const Model& model) {
  GeneralCycle<GroupSystem> groups(model);
  for (auto _ : state) benchmark::DoNotOptimize(groups());
  hand_written::SliderCrank linkage;
  const double by_hand = fastest([&] { return hand_written_cycle(linkage); });
  const double by_groups = measure(state, groups);
  state.counters["ns_by_groups"] = by_groups;
  state.counters["slider_cranks_by_hand"] = by_groups / by_hand;
  state.counters["ns_per_link"] = by_groups / static_cast<double>(model.links.size());
}

// Additional results of a design: all derivatives, the split by cause.
void six_bar_design(benchmark::State& state) {
  const Model model = models::six_bar();
  GeneralCycle<GroupSystem> groups(model);
  groups.effort(1.0);
  Sensitivity sensitivity(model);
  CauseSplit split(model);
  bool found = true;
  for (auto _ : state) found = sensitivity.find(groups.at()) == Status::closed && found;
  const auto derivatives = [&] { return sensitivity.find(groups.at()) == Status::closed; };
  const auto causes = [&] { return split.find(groups.at()); };
  state.counters["ns_all_derivatives"] = positions * fastest(derivatives);
  state.counters["ns_by_cause"] = positions * fastest(causes);
  state.counters["parameters"] = static_cast<double>(sensitivity.parameters().size());
  if (!found || !causes()) state.SkipWithError("no derivatives");
}

void class_three(benchmark::State& state) { alone(state, models::class_three()); }
void chain_of_5(benchmark::State& state) { alone(state, models::chain(5)); }
void chain_of_50(benchmark::State& state) { alone(state, models::chain(50)); }

}  // namespace

BENCHMARK(slider_crank);
BENCHMARK(four_bar);
BENCHMARK(six_bar);
BENCHMARK(six_bar_design);
BENCHMARK(class_three);
BENCHMARK(chain_of_5);
BENCHMARK(chain_of_50);
BENCHMARK_MAIN();
