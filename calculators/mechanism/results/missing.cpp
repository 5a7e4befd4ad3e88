#include "calculators/mechanism/results/missing.hpp"

#include "calculators/mechanism/cycle/ranges.hpp"
#include "calculators/mechanism/input/model.hpp"
#include "lib/mechanism/model/spring.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

namespace {

bool any(const std::vector<bool>& positions) {
  return std::find(positions.begin(), positions.end(), true) != positions.end();
}

/// The first spring whose ends coincide at some position; empty where there is none.
std::string spring_without_direction(const Mechanism::Input& in, const Cycle& cycle) {
  const auto first = std::find(cycle.undirected.begin(), cycle.undirected.end(), true);
  if (first == cycle.undirected.end()) return {};
  const mechanism::Position& at = cycle.positions[static_cast<std::size_t>(first - cycle.undirected.begin())];
  for (const mechanism::Spring& spring : model_of(in).springs) {
    if (std::isnan(mechanism::spring_now(spring, at).effort)) return spring.name;
  }
  return {};
}

Message why_missing(const Mechanism::Input& in, const Cycle& cycle) {
  const bool one = cycle.positions.size() == 1;
  if (cycle.closes_but_at_change_points() && any(cycle.at_change_point))
    return say("the drive does not hold the mechanism at a change point");
  if (!cycle.closes_but_at_change_points())
    return one ? say("the mechanism does not close") : say("the mechanism does not close at every position");
  if (any(cycle.jams))
    return one ? say("friction jams the mechanism") : say("friction jams the mechanism at some positions");
  if (!any(cycle.undirected)) return {};
  const std::string spring = spring_without_direction(in, cycle);
  return one ? say("the ends of spring '{1}' coincide, and its force has no direction", spring)
             : say("the ends of spring '{1}' coincide at some positions, and its force has no direction there", spring);
}

bool misses_where_solved(const Cycle& cycle, const std::vector<double>& values) {
  for (std::size_t k = 0; k < std::min(values.size(), cycle.positions.size()); ++k) {
    if (std::isnan(values[k]) && cycle.has_forces(k)) return true;
  }
  return false;
}

}  // namespace

std::optional<account::Verdict> direction_of_springs(const std::string& step, const Mechanism::Input& in,
                                                     const Cycle& cycle, const Axis* axis) {
  const auto without = static_cast<std::size_t>(std::count(cycle.undirected.begin(), cycle.undirected.end(), true));
  if (without == 0) return std::nullopt;
  const std::string spring = spring_without_direction(in, cycle);
  const std::size_t all = cycle.undirected.size();
  return account::Verdict{
      .step = step,
      .symbol = "directed_" + spring,
      .meaning = say("the ends of spring '{1}' are apart: its force has a direction", spring),
      .value = say("{1} of {2}", std::to_string(all - without), std::to_string(all)),
      .bound = say("every position"),
      .state = account::State::fail,
      .note = axis == nullptr ? Message{} : say("they coincide {1}", range_of(cycle.undirected, true, *axis))};
}

void explain_missing(const Mechanism::Input& in, const Cycle& cycle, Output::Values& values) {
  const bool series = values.si.size() == cycle.positions.size();
  if (!cycle.unique.empty() && misses_where_solved(cycle, values.si)) {
    values.missing = say("not unique: other joints hold the same freedom");
    return;
  }
  bool here = false;  // a value is missing where the mechanism has no forces
  for (std::size_t k = 0; k < values.si.size(); ++k) {
    if (!std::isnan(values.si[k])) continue;
    if (series && cycle.has_forces(k) && !values.missing.empty()) return;  // it is missing elsewhere too
    here = here || !series || !cycle.has_forces(k);
  }
  const bool explained = !series && !values.missing.empty();
  if (!here || explained) return;
  if (Message reason = why_missing(in, cycle); !reason.empty()) values.missing = std::move(reason);
}

}  // namespace loadpath::planar
