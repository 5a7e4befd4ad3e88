// Whether the mechanism closes, moves and comes back to where it began, and its springs have a direction.
#include "calculators/mechanism/cycle/either_way.hpp"
#include "calculators/mechanism/cycle/ranges.hpp"
#include "calculators/mechanism/proof/stops.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/missing.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace loadpath::planar {

namespace {

using account::Quantity;

Message why_open(const Mechanism::Input& in, const Cycle& cycle) {
  if (cycle.first_failure == mechanism::Status::singular) return say("the drive cannot hold the mechanism there");
  if (cycle.gap.joint < 0) return say("the drive could not be moved to its position");
  const auto type = in.joints[static_cast<std::size_t>(cycle.gap.joint)].type;
  if (type == planar::Type::belt || type == planar::Type::crossed_belt) {
    return say("the belt '{1}' keeps its length, and its centres would have to move apart or together",
               std::string(in.joints[static_cast<std::size_t>(cycle.gap.joint)].name.view()));
  }
  return say("the parts of joint '{1}' come no closer than {2}",
             std::string(in.joints[static_cast<std::size_t>(cycle.gap.joint)].name.view()),
             format_quantity(cycle.gap.size, "mm", 4));
}

/// Where the drives do not hold the mechanism, and nothing else is wrong.
Message change_points(const Cycle& cycle, const Axis& axis) {
  std::string places;
  for (std::size_t k = 0; k < cycle.at_change_point.size(); ++k) {
    if (cycle.at_change_point[k]) places += (places.empty() ? "" : ", ") + place_of(k, axis);
  }
  if (!axis.cyclic())
    return say("change point at {1}: the drive does not determine the motion there; choose other positions", places);
  const double half = 0.5 * (axis.at[1] - axis.at[0]);
  return say(
      "change point at {1}: the drive does not determine the motion there; choose other "
      "positions, crank = { start = \"{2}\" }",
      places, format_quantity(axis.at[0] + half, axis.unit, 5));
}

account::Verdict closing(const Solved& solved) {
  const Mechanism::Input& in = solved.in;
  const Cycle& cycle = solved.proved;
  const Axis* const axis = solved.axis;
  const auto closed = static_cast<std::size_t>(std::count(cycle.closed.begin(), cycle.closed.end(), true));
  account::Verdict v{.step = solved.step,
                     .symbol = "closes",
                     .meaning = say("the mechanism closes at every position"),
                     .value = say("{1} of {2}", std::to_string(closed), std::to_string(cycle.closed.size())),
                     .bound = say("every position"),
                     .state = account::pass_if(closed == cycle.closed.size())};
  if (v.state == account::State::pass) return v;
  if (axis != nullptr && cycle.closes_but_at_change_points()) {
    v.note = change_points(cycle, *axis);
    return v;
  }
  v.note = why_open(in, cycle);
  if (axis == nullptr) return v;
  const auto stops = solved.in_words ? stops_of(solved) : std::nullopt;
  v.note = say("{1}: {2}", stops ? *stops : say("not {1}", range_of(cycle.closed, false, *axis)), v.note);
  if (is_whole_turn(in) && cycle.first_failure == mechanism::Status::does_not_close) {
    v.note =
        say("{1}; the crank does not turn round: change the lengths, or give it angles where the mechanism closes, "
            "crank = { at = [...] }",
            v.note);
  }
  return v;
}

/// Means over the turn are those of a cycle only if the mechanism is back then where it began.
account::Verdict no_return(const std::string& step, const Mechanism::Input& in) {
  return {.step = step,
          .symbol = "returns",
          .meaning = say("after the cycle the mechanism is in its initial position"),
          .value = say("elsewhere"),
          .bound = say("after {1} turns", std::to_string(static_cast<int>(in.crank.turns))),
          .state = account::State::fail,
          .note = say("give the revolutions of the crank per cycle, crank = { turns = ... }; if these are too many, "
                      "give crank angles in place of a cycle, crank = { at = [...] }, without mean values")};
}

/// Whether no drive moves or gives its impending direction: then friction could act in either direction.
bool is_at_rest(const Mechanism::Input& in) {
  const auto rests = [](const auto& drive) {
    return in_si(drive.speed) == 0.0 && drive.impending == planar::Impending::either;
  };
  return !has_law(in) && rests(in.crank) && std::all_of(in.cylinders.begin(), in.cylinders.end(), rests);
}

/// Whether there is a position where no effort of the only drive starts it in this direction.
bool holds_against(const Cycle& cycle, double sense) {
  for (std::size_t k = 0; k < cycle.standing.size(); ++k) {
    const StandingEffort& effort = cycle.standing[k];
    if (effort.known && std::isnan(sense > 0.0 ? effort.forward : effort.backward)) return true;
  }
  return false;
}

/// The positions where friction blocks a mechanism at rest against any effort in one direction or the other.
std::vector<bool> held_one_way(const Cycle& cycle) {
  std::vector<bool> held(cycle.positions.size());
  for (std::size_t k = 0; k < cycle.either_way.size(); ++k) {
    const auto& ways = cycle.either_way[k];
    held[k] = std::any_of(ways.begin(), ways.end(), [](const auto& way) { return way.pose.empty(); });
  }
  return held;
}

/// A turning spring whose angle does not come back is wound up further with every cycle.
account::Verdict wound_up(const std::string& step, const Mechanism::Input& in, const Cycle::Winding& winding) {
  const std::string name(in.springs[winding.spring].name.view());
  return {.step = step,
          .symbol = "returns_" + name,
          .meaning = say("after the cycle the spring '{1}' has its initial length", name),
          .value = Quantity{winding.by, "deg", 4},
          .bound = say("the same angle"),
          .state = account::State::fail,
          .note = say("it is wound up further in every cycle; these are the results of the first")};
}

/// Said only of a mechanism with friction.
void add_jamming(const std::string& step, const Mechanism::Input& in, const mechanism::Model& model, const Cycle& cycle,
                 const Axis* axis, std::vector<account::Verdict>& verdicts) {
  const auto jams = static_cast<std::size_t>(std::count(cycle.jams.begin(), cycle.jams.end(), true));
  if (!has_dry_friction(model) && jams == 0) return;
  account::Verdict v{
      .step = step,
      .symbol = "moves",
      .meaning = say("friction does not jam the mechanism"),
      .value = say("{1} of {2}", std::to_string(cycle.jams.size() - jams), std::to_string(cycle.jams.size())),
      .bound = say("every position"),
      .state = account::pass_if(jams == 0)};
  if (jams > 0 && axis != nullptr) v.note = say("jams {1}", range_of(cycle.jams, true, *axis));
  if (is_at_rest(in)) {
    const std::vector<bool> held = held_one_way(cycle);
    const bool nowhere = std::find(held.begin(), held.end(), true) == held.end();
    v.state = account::State::not_covered;
    const bool one_drive = !cycle.standing.empty();
    v.note = nowhere ? say("at rest friction acts in either direction: the results exclude it, and the effort lies "
                           "between M_min and M_max, F_min and F_max; state 'impending' for one direction")
             : one_drive && holds_against(cycle, 1.0)  ? say("at rest friction acts in either direction, and no effort "
                                                              "of the drive starts it forward; state 'impending'")
             : one_drive && holds_against(cycle, -1.0) ? say("at rest friction acts in either direction, and no effort "
                                                             "of the drive starts it backward; state 'impending'")
                                                       : say("at rest friction acts in either direction, and in one "
                                                             "direction no effort starts it; state 'impending'");
  }
  verdicts.push_back(std::move(v));
}

void judge_closing(const Solved& solved, std::vector<account::Verdict>& verdicts) {
  const Cycle& cycle = solved.proved;
  verdicts.push_back(closing(solved));
  add_jamming(solved.step, solved.in, solved.given, cycle, solved.axis, verdicts);
  if (auto directed = direction_of_springs(solved.step, solved.in, cycle, solved.axis))
    verdicts.push_back(std::move(*directed));
  if (!cycle.returns) verdicts.push_back(no_return(solved.step, solved.in));
  for (const Cycle::Winding& winding : cycle.windings) verdicts.push_back(wound_up(solved.step, solved.in, winding));
}

}  // namespace

constinit const Aspect aspects::closing{.judge = &judge_closing};

}  // namespace loadpath::planar
