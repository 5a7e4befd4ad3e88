// Whether the assembly that is followed is kept over the cycle.
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/mechanism/groups/closing.hpp"
#include "lib/quantity/format.hpp"

#include <string>

namespace loadpath::planar {

namespace {

/// The intervals between positions: from, to, and the distance along the axis between them.
template <class See>
void for_each_interval(const Cycle& cycle, const Axis& axis, See see) {
  const std::size_t count = cycle.positions.size();
  for (std::size_t k = 0; k < (axis.cyclic() ? count : count - 1); ++k) {
    const std::size_t next = (k + 1) % count;
    if (!cycle.closed[k] || !cycle.closed[next]) continue;
    see(k, next, axis.at[next] - axis.at[k] + (next == 0 ? axis.period : 0.0));
  }
}

std::string place(double at, const Axis& axis) { return format_quantity(at, axis.unit, 4); }

/// Where dyads go through their change points: the sine of the closing angle through zero.
void add_dyads(const mechanism::Model& model, const Cycle& cycle, const Axis& axis, std::vector<Message>& found) {
  for (const mechanism::DyadClosing& dyad : dyad_closings(model, plan_of(model))) {
    const auto sine = [&](std::size_t k) { return closing_angle(model, dyad, cycle.positions[k].pose).sine; };
    for_each_interval(cycle, axis, [&](std::size_t k, std::size_t next, double way) {
      const double before = sine(k), after = sine(next);
      if (before * after >= 0.0) return;
      const double at = axis.at[k] + way * before / (before - after);
      found.push_back(say("{1} at {2}", model.joints[dyad.joint].name, place(at, axis)));
    });
  }
}

void add_iterated(const mechanism::Model& model, const Cycle& cycle, const Kinematics& kinematics, const Axis& axis,
                  std::vector<Message>& found) {
  for (const Kinematics::Iterated& group : kinematics.iterated) {
    for_each_interval(cycle, axis, [&](std::size_t k, std::size_t next, double way) {
      if (group.signs[k] * group.signs[next] >= 0.0) return;
      found.push_back(say("{1} between {2} and {3}", model.links[group.link].name, place(axis.at[k], axis),
                          place(axis.at[k] + way, axis)));
    });
  }
}

/// Reported only where a group passes to another of its assemblies, and no overconstrained joint prevents it: at the
/// change point the drive does not determine the direction of motion.
void judge_changes(const Solved& solved, std::vector<account::Verdict>& verdicts) {
  if (solved.axis == nullptr || !solved.cycle.unique.empty()) return;
  std::vector<Message> found;
  add_dyads(solved.model, solved.cycle, *solved.axis, found);
  add_iterated(solved.model, solved.cycle, solved.kinematics, *solved.axis, found);
  if (found.empty()) return;
  Message places = found.front();
  for (std::size_t n = 1; n < found.size(); ++n) places = say("{1}, {2}", places, found[n]);
  verdicts.push_back({.step = solved.step,
                      .symbol = "assembly",
                      .meaning = say("every group keeps its assembly"),
                      .value = say("passed {1} times", std::to_string(found.size())),
                      .bound = say("no change point"),
                      .state = account::State::not_covered,
                      .note = say("change point: direction of motion not determined by the drive: {1}", places)});
}

}  // namespace

constinit const Aspect aspects::changes_of_assembly{.judge = &judge_changes};

}  // namespace loadpath::planar
