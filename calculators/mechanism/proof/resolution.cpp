// Whether the positions of a turn are close enough to show the largest reactions: near a dead point a force rises and
// falls within a few degrees.
#include "calculators/mechanism/cycle/ranges.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/mechanism/columns/largest.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace loadpath::planar {

namespace {

constexpr double most_bend = 0.1;     // over the largest: a wave of 20 positions has as much
constexpr double most_missed = 0.02;  // by which the largest reaction may be larger between the positions
constexpr std::size_t parts = 32;     // parts of the two steps next to the largest one

double largest_reaction(const mechanism::Position& at) {
  double most = 0.0;
  for (const auto& reaction : at.reactions) most = std::max(most, mechanism::length(reaction.force));
  return most;
}

/// Of each position; empty if some have no forces.
std::vector<double> largest_reactions(const Cycle& cycle) {
  std::vector<double> force(cycle.positions.size());
  for (std::size_t k = 0; k < force.size(); ++k) {
    if (!cycle.has_forces(k)) return {};
    force[k] = largest_reaction(cycle.positions[k]);
  }
  return force;
}

struct Top {
  std::size_t position = 0;
  double reaction = 0.0;
};

/// The position of the largest reaction, where its neighbours show it as a peak of few positions.
std::optional<Top> sharp_peak(const Cycle& cycle) {
  const std::vector<double> found = cycle.largest_reactions.empty() ? largest_reactions(cycle) : std::vector<double>();
  const std::vector<double>& force = cycle.largest_reactions.empty() ? found : cycle.largest_reactions;
  if (force.empty()) return std::nullopt;
  const std::size_t count = force.size();
  const double most = mechanism::largest_size(force);
  const auto top = static_cast<std::size_t>(std::ranges::find(force, most) - force.begin());
  if (top == count) return std::nullopt;
  const double before = force[(top + count - 1) % count], after = force[(top + 1) % count];
  const bool sharp = std::abs(before - 2.0 * most + after) > most_bend * most;
  return sharp ? std::optional(Top{top, most}) : std::nullopt;
}

double largest_effort(const mechanism::Position& at) {
  double most = 0.0;
  for (const double effort : at.effort) most = std::max(most, std::abs(effort));
  return most;
}

struct Peak {
  double force = 0.0;
  double at = 0.0;
  void take(double other, double place) {
    if (other > force) force = other, at = place;
  }
};
struct Peaks {
  Peak reaction, effort;
};

Peaks peaks_of(const Cycle& cycle, const Axis& axis) {
  Peaks peaks;
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    if (!cycle.has_forces(k)) continue;
    peaks.reaction.take(largest_reaction(cycle.positions[k]), axis.at[k]);
    peaks.effort.take(largest_effort(cycle.positions[k]), axis.at[k]);
  }
  return peaks;
}

/// The same mechanism at these crank angles.
Peaks peaks_at(const Solved& solved, const std::vector<double>& angles) {
  const auto other = std::make_unique<Mechanism::Input>(solved.in);
  other->crank.at = {};
  for (const double angle : angles) other->crank.at.push_back({angle});
  Axis axis = *solved.axis;
  return peaks_of(solve_cycle(*other, solved.given, !solved.structure.redundant.empty(), &axis), axis);
}

/// The largest reaction between the neighbours of a position.
Peak adjacent_peak(const Solved& solved, std::size_t top) {
  const Axis& axis = *solved.axis;
  const std::size_t last = axis.at.size() - 1;
  const double before = top == 0 ? axis.at[last] - axis.period : axis.at[top - 1];
  const double after = top == last ? axis.at[0] + axis.period : axis.at[top + 1];
  std::vector<double> angles;
  for (std::size_t i = 0; i <= parts; ++i) {
    const double share = 2.0 * static_cast<double>(i) / static_cast<double>(parts) - 1.0;
    angles.push_back(axis.at[top] + (share < 0.0 ? share * (axis.at[top] - before) : share * (after - axis.at[top])));
  }
  return peaks_at(solved, angles).reaction;
}

/// Crank angles of the turn on both sides of those at which the share of a load bends or jumps, rising.
std::vector<double> corners_of_loads(const Solved& solved) {
  constexpr double offset = 1e-7;  // rad
  const double first = solved.axis->at.front(), period = std::abs(solved.axis->period);
  std::vector<double> corners;
  for (const auto& load : solved.in.loads) {
    for (const auto& corner : load.over) {
      for (const double angle : {corner.angle - offset, corner.angle + offset})
        corners.push_back(angle - period * std::floor((angle - first) / period));
    }
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

account::Verdict verdict_of(const Solved& solved, Message meaning, double over, Message note) {
  return {.step = solved.step,
          .symbol = "resolution",
          .meaning = std::move(meaning),
          .value = account::Quantity{std::max(1.0, over), "-", 4},
          .bound = say("covered up to {1}", format_quantity(1.0 + most_missed, "-")),
          .state = over <= 1.0 + most_missed ? account::State::pass : account::State::not_covered,
          .note = std::move(note)};
}

Message more_positions(const Solved& solved, const Peak& peak, double shown, const char* unit) {
  return say("{1} at {2}, {3} at the positions; more of them show it: crank = { positions = ... }",
             format_quantity(peak.force, unit, 4), format_quantity(peak.at, solved.axis->unit, 5),
             format_quantity(shown, unit, 4));
}

/// Part of the peak of a load that is hidden between two positions; none if it is small.
std::optional<account::Verdict> hidden_corner(const Solved& solved) {
  constexpr double no_arm = 1e-6;  // m
  const std::vector<double> corners = corners_of_loads(solved);
  if (corners.empty()) return std::nullopt;
  const Peaks shown = peaks_of(solved.cycle, *solved.axis), there = peaks_at(solved, corners);
  const auto over = [](const Peak& one, const Peak& other) {
    return other.force > 0.0 ? one.force / other.force : 0.0;
  };
  const bool driven = there.effort.force > no_arm * there.reaction.force;
  const double by_reaction = over(there.reaction, shown.reaction);
  const double by_effort = driven ? over(there.effort, shown.effort) : 0.0;
  if (std::max(by_reaction, by_effort) <= 1.0 + most_missed) return std::nullopt;
  const Message meaning = say("maximum reaction or effort between the positions / at the positions");
  return by_effort > by_reaction
             ? verdict_of(solved, meaning, by_effort, more_positions(solved, there.effort, shown.effort.force, "N*m"))
             : verdict_of(solved, meaning, by_reaction,
                          more_positions(solved, there.reaction, shown.reaction.force, "N"));
}

/// Behaviour of laws between the positions, if it requires more than can be inserted.
account::Verdict unresolved(const Solved& solved) {
  const Between& between = solved.proved.between;
  const std::size_t asked = positions_of(solved.in);
  const Message note =
      between.needed == 0
          ? say("{1} varies too fast between the positions: smooth it, or give it by points", between.missed)
          : say("{1} varies between the {2} positions more than they resolve: use {3} positions", between.missed,
                std::to_string(asked), std::to_string(between.needed));
  return {.step = solved.step,
          .symbol = "resolution",
          .meaning = say("laws of loads, drives and cams between the positions"),
          .value = say("{1} of {2}", std::to_string(asked),
                       between.needed == 0 ? std::string("too many") : std::to_string(between.needed)),
          .bound = say("every extreme value and every corner"),
          .state = account::State::not_judged,
          .note = note};
}

/// The positions that were inserted show what laws do between the others.
account::Verdict inserted(const Solved& solved) {
  const Between& between = solved.proved.between;
  return {.step = solved.step,
          .symbol = "resolution",
          .meaning = say("laws of loads, drives and cams between the positions"),
          .value = say("{1} positions inserted", std::to_string(between.inserted)),
          .bound = say("every extreme value and every corner"),
          .state = account::State::pass};
}

void judge_resolution(const Solved& solved, std::vector<account::Verdict>& verdicts) {
  if (solved.axis != nullptr && !solved.proved.between.missed.empty()) {
    verdicts.push_back(unresolved(solved));
    return;
  }
  if (solved.axis != nullptr && solved.proved.between.inserted > 0) verdicts.push_back(inserted(solved));
  if (solved.axis == nullptr || !is_whole_turn(solved.in) || !solved.in.cylinders.empty()) return;
  if (auto hidden = hidden_corner(solved)) {
    verdicts.push_back(std::move(*hidden));
    return;
  }
  const auto top = sharp_peak(solved.cycle);
  if (!top) return;
  const Peak peak = adjacent_peak(solved, top->position);
  const double shown = top->reaction;
  verdicts.push_back(verdict_of(solved, say("maximum reaction between the positions / at the positions"),
                                peak.force / shown, more_positions(solved, peak, shown, "N")));
}

}  // namespace

constinit const Aspect aspects::resolution{.judge = &judge_resolution};

}  // namespace loadpath::planar
