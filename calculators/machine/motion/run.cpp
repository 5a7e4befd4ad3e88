#include "calculators/machine/motion/run.hpp"

#include "calculators/machine/motion/by_angle.hpp"
#include "calculators/machine/motion/by_time.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loadpath::machine {

namespace {

using Machine = DrivenMachine;
using End = MachineRun::End;

constexpr int most_cycles = 10'000, most_secants = 40;
constexpr double nearly_steady = 1e-4;  // change of the energy in a cycle, at which the limit is extrapolated
constexpr double closed = 1e-8;         // of the energy of the steady cycle
constexpr double alike_by_time = 1e-5;  // of the two integrations
constexpr std::size_t most_points = 40'000;

/// The energy after a cycle; none if the machine stops, or becomes too fast.
class CycleMap {
 public:
  explicit CycleMap(const Machine& machine) : machine_(machine) {}
  std::optional<double> operator()(double E) const {
    RunState state{E};
    for (const PeriodCell& cell : machine_.cells) {
      if (cross(machine_, cell, state) != Crossing::done) return std::nullopt;
    }
    return state.E;
  }

 private:
  const Machine& machine_;
};

struct FixedPoint {
  double E = 0.0, error = 0.0;
};

/// The fixed point near two energies of which the map is known, by secants.
std::optional<FixedPoint> fixed_point(const CycleMap& map, double E_1, double next_1, double E_2, double next_2) {
  double q = (next_2 - next_1) / (E_2 - E_1);
  for (int k = 0; k < most_secants; ++k) {
    if (!(std::abs(q) < 1.0)) return std::nullopt;
    const double E = E_2 + (next_2 - E_2) / (1.0 - q);
    if (!(E > 0.0)) return std::nullopt;
    const auto next = map(E);
    if (!next) return std::nullopt;
    const double error = std::abs(*next - E) / (1.0 - q);
    if (error <= 1e-11 * E) return FixedPoint{E, error / E};
    const bool is_apart = std::abs(E - E_2) > 1e-9 * E;  // else the slope of the last two is only rounding
    if (!is_apart && error <= closed * E) return FixedPoint{E, error / E};
    if (is_apart) q = (*next - next_2) / (E - E_2);
    E_2 = E, next_2 = *next;
  }
  return std::nullopt;
}

/// Whether a run from `low` gets to the fixed point: the energy grows everywhere between, so that no other one is near.
bool is_reached(const CycleMap& map, double low, double high) {
  constexpr int places = 6;
  for (int k = 1; k < places; ++k) {
    const double E = low + (high - low) * k / places;
    const auto next = map(E);
    if (!next || !((*next - E) * (high - low) > 0.0)) return false;
  }
  return true;
}

/// Load over the torque of the motor at rest where the machine is at rest, also if both are equal: above 1.
double beyond_rest(double load, double drive) { return std::max(load / drive, 1.0 + closed); }

class RunUpToSteady {
 public:
  RunUpToSteady(const Machine& machine, bool records) : machine_(machine), map_(machine), records_(records) {}

  MachineRun run() {
    if (!start()) return std::move(run_);
    if (const auto fixed = find_steady()) {
      run_.closure = fixed->error;
      take_cycle(fixed->E);
      find_end();
    }
    return std::move(run_);
  }

 private:
  /// The first cell, from rest.
  bool start() {
    const PeriodCell& first = machine_.cells.front();
    const double drive = machine_.drive(0.0), load = first.M.v_0;
    if (!(drive > load)) {
      run_.end = End::no_start;
      if (drive > 0.0) run_.stall = beyond_rest(load, drive);
      return false;
    }
    starts_.push_back(RunState{});
    return true;
  }

  /// One cycle more; false if it is not completed.
  bool advance() {
    RunState state = starts_.back();
    for (const PeriodCell& cell : machine_.cells) {
      const bool at_rest = state.E == 0.0;
      const Crossing crossing = at_rest ? leave(machine_, cell, state) : cross(machine_, cell, state);
      if (crossing == Crossing::stops) {
        run_.end = End::stalled;
        const double drive = machine_.drive(0.0), load = std::max(cell.M.v_0, cell.M.v_1);
        if (drive > 0.0) run_.stall = beyond_rest(load, drive);
      }
      if (crossing == Crossing::too_fast) run_.end = End::runs_away;
      if (crossing != Crossing::done) return false;
      record(state, cell);
    }
    starts_.push_back(state);
    return true;
  }

  void record(const RunState& state, const PeriodCell& cell) {
    if (records_ && run_.start.size() < most_points) run_.start.push_back({state.t, speed_of(state.E, cell.J.v_1)});
  }

  std::optional<FixedPoint> find_steady() {
    for (int k = 0; k < most_cycles; ++k) {
      if (!advance()) return std::nullopt;
      const std::size_t n = starts_.size();
      if (n < 3) continue;
      const double a = starts_[n - 3].E, b = starts_[n - 2].E, c = starts_[n - 1].E;
      // Smaller changes are rounding, and say nothing about the rate of convergence.
      if (std::abs(b - a) > 1e-8 * c) rate_ = std::abs(c - b) / std::abs(b - a);
      const double error = std::abs(c - b) / (1.0 - rate_);
      if (rate_ < 1.0 && error <= 1e-9 * c) return FixedPoint{c, error / c};
      if (std::abs(c - b) > nearly_steady * c || k % 16 != 0) continue;
      const auto fixed = fixed_point(map_, a, b, b, c);
      if (fixed && is_reached(map_, c, fixed->E)) return fixed;
    }
    return std::nullopt;
  }

  void take_cycle(double E) {
    RunState state{E};
    run_.cycle.push_back(state);
    for (const PeriodCell& cell : machine_.cells) {
      if (cross(machine_, cell, state) != Crossing::done) return;
      run_.cycle.push_back(state);
    }
    run_.by_time = difference_by_time(machine_, run_.cycle.front().E, state.t);
    if (run_.closure <= closed && run_.by_time <= alike_by_time) run_.end = End::steady;
  }

  /// How far the speed is from that of the steady cycle, as a share of it.
  [[nodiscard]] double shortfall(double E, std::size_t place) const {
    return std::abs(std::sqrt(E / run_.cycle[place].E) - 1.0);
  }

  /// The end of the run-up, in the first cycle at whose end the speed is near that of the steady cycle.
  void find_end() {
    if (run_.end != End::steady) return;
    std::size_t n = 1;
    while (true) {
      if (n >= starts_.size() && (n > most_cycles || !advance())) return;
      if (shortfall(starts_[n].E, 0) <= MachineRun::settled) break;
      ++n;
    }
    RunState state = starts_[n - 1];
    for (std::size_t k = 0; k < machine_.cells.size(); ++k) {
      const PeriodCell& cell = machine_.cells[k];
      const RunState before = state;
      if ((before.E == 0.0 ? leave(machine_, cell, state) : cross(machine_, cell, state)) != Crossing::done) return;
      const double from = shortfall(before.E, k), to = shortfall(state.E, k + 1);
      if (to <= MachineRun::settled) return end_between(before, state, from, to, n - 1, k);
    }
  }
  void end_between(const RunState& a, const RunState& b, double from, double to, std::size_t turns, std::size_t k) {
    // The distance from the steady cycle decays as an exponential of the time.
    const double share = from > to && to > 0.0 ? std::log(from / MachineRun::settled) / std::log(from / to) : 1.0;
    const double part = std::clamp(share, 0.0, 1.0);
    run_.t = a.t + part * (b.t - a.t);
    run_.heat = a.slip_heat + part * (b.slip_heat - a.slip_heat);
    run_.angle = static_cast<double>(turns) * machine_.period + machine_.cells[k].from + part * machine_.cells[k].width;
  }

  const Machine& machine_;
  CycleMap map_;
  bool records_;
  double rate_ = 0.0;  // at which the changes from cycle to cycle decrease
  MachineRun run_;
  std::vector<RunState> starts_;  // at the beginnings of the cycles of the run-up
};

}  // namespace

MachineRun run_up(const DrivenMachine& machine, bool records) { return RunUpToSteady(machine, records).run(); }

}  // namespace loadpath::machine
