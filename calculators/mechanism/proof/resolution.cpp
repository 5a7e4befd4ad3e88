// Whether the positions of a turn are close enough to show the largest reactions: near a dead point a force rises and
// falls within a few degrees.
#include "calculators/mechanism/cycle/ranges.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace loadpath::planar {

namespace {

constexpr double most_bend = 0.1;     // of neighbouring values over the largest: a wave of 20 positions has as much
constexpr double most_missed = 0.02;  // by which the largest reaction may be larger between the positions
constexpr std::size_t parts = 32;     // of the two steps beside the largest one

double largest_reaction(const mechanism::Position& at) {
  double most = 0.0;
  for (const auto& reaction : at.reactions) most = std::max(most, mechanism::length(reaction.force));
  return most;
}

/// The position of the largest reaction, where its neighbours show it as a peak of few positions.
std::optional<std::size_t> sharp_peak(const Cycle& cycle) {
  const std::size_t count = cycle.positions.size();
  std::size_t top = 0;
  std::vector<double> force(count);
  for (std::size_t k = 0; k < count; ++k) {
    if (!cycle.has_forces(k)) return std::nullopt;
    force[k] = largest_reaction(cycle.positions[k]);
    if (force[k] > force[top]) top = k;
  }
  const double before = force[(top + count - 1) % count], after = force[(top + 1) % count];
  const bool sharp = std::abs(before - 2.0 * force[top] + after) > most_bend * force[top];
  return sharp ? std::optional(top) : std::nullopt;
}

struct Peak {
  double force = 0.0;
  double at = 0.0;
};

/// The largest reaction between the neighbours of a position.
Peak peak_beside(const Solved& solved, std::size_t top) {
  const auto closer = std::make_unique<Mechanism::Input>(solved.in);
  const double step = solved.axis->at[1] - solved.axis->at[0];
  closer->crank.at = {};
  for (std::size_t i = 0; i <= parts; ++i) {
    const double share = 2.0 * static_cast<double>(i) / static_cast<double>(parts) - 1.0;
    closer->crank.at.push_back({solved.axis->at[top] + share * step});
  }
  Axis axis = *solved.axis;
  const Cycle cycle = solve_cycle(*closer, solved.given, !solved.structure.redundant.empty(), &axis);
  Peak peak;
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    if (!cycle.has_forces(k)) continue;
    const double force = largest_reaction(cycle.positions[k]);
    if (force > peak.force) peak = {force, axis.at[k]};
  }
  return peak;
}

void judge(const Solved& solved, std::vector<account::Verdict>& verdicts) {
  if (solved.axis == nullptr || !is_whole_turn(solved.in) || !solved.in.cylinders.empty()) return;
  const auto top = sharp_peak(solved.cycle);
  if (!top) return;
  const Peak peak = peak_beside(solved, *top);
  const double shown = largest_reaction(solved.cycle.positions[*top]);
  const bool enough = peak.force <= (1.0 + most_missed) * shown;
  verdicts.push_back({.step = solved.step,
                      .symbol = "resolution",
                      .meaning = say("the largest reaction between the positions over the one at them"),
                      .value = account::Quantity{std::max(1.0, peak.force / shown), "-", 4},
                      .bound = say("covered up to {1}", format_quantity(1.0 + most_missed, "-")),
                      .state = enough ? account::State::pass : account::State::not_covered,
                      .note = say("{1} at {2}, {3} at the positions; more of them show it: crank = { positions = ... }",
                                  format_quantity(peak.force, "N", 4), format_quantity(peak.at, solved.axis->unit, 5),
                                  format_quantity(shown, "N", 4))});
}

}  // namespace

constinit const Aspect aspects::resolution{.judge = &judge};

}  // namespace loadpath::planar
