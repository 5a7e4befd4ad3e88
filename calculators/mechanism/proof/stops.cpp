#include "calculators/mechanism/proof/stops.hpp"

#include "calculators/mechanism/cycle/ranges.hpp"
#include "calculators/mechanism/input/law.hpp"
#include "lib/mechanism/studies/drive_range.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

namespace {

/// Limits on the axis of a series, in SI; infinite where there is none.
struct Limits {
  double least, most;
};

/// The range in which the drive can be moved from where the mechanism was assembled, as far as the positions go.
std::optional<Limits> limits_of(const Solved& solved) {
  const Axis& axis = *solved.axis;
  const bool one_drive = solved.given.drivers.size() == 1 && solved.structure.redundant.empty();
  if (!one_drive || has_law(solved.in) || axis.at.empty()) return std::nullopt;
  const auto known = mechanism::drive_range(solved.given, 0.0, 0.0);
  if (!known) return std::nullopt;
  const double turn = 2.0 * pi;
  const double ahead = has_crank(solved.in) ? turn * std::round((known->assembled - axis.at.front()) / turn) : 0.0;
  const double assembled = known->assembled - ahead;
  const auto [first, last] = std::minmax({axis.at.front(), axis.at.back()});
  const double whole = std::abs(axis.period);
  const auto range = mechanism::drive_range(solved.given, axis.cyclic() ? whole : assembled - first,
                                            axis.cyclic() ? whole : last - assembled);
  return range ? std::optional(Limits{range->least - ahead, range->most - ahead}) : std::nullopt;
}

/// Whether a place lies within them; in a cycle, at any revolution.
bool is_within(const Limits& limits, double at, double period) {
  constexpr double slack = 1e-6;  // rad or m
  const auto holds = [&](double x) { return x >= limits.least - slack && x <= limits.most + slack; };
  if (period == 0.0) return holds(at);
  const double whole = std::abs(period);
  return holds(at + whole * std::ceil((limits.least - slack - at) / whole));
}

/// Whether some positions lie beyond the limits, and these are open. Others may be open too, if they are reached only
/// through these.
bool explain(const Limits& limits, const Cycle& cycle, const Axis& axis) {
  bool some_beyond = false;
  for (std::size_t k = 0; k < axis.at.size(); ++k) {
    if (is_within(limits, axis.at[k], axis.period)) continue;
    if (cycle.closed[k]) return false;
    some_beyond = true;
  }
  return some_beyond;
}

/// In the order of the positions, in the revolution that they lie in.
Message stops_in_a_turn(const Limits& limits, const Axis& axis) {
  const double whole = std::abs(axis.period), sense = std::copysign(1.0, axis.period), first = axis.at.front();
  const auto after = [&](double at) {
    const double way = sense * (at - first);
    return way - whole * std::floor(way / whole);
  };
  const auto place = [&](double way) { return limit_text(first + sense * way, axis.unit); };
  const double stopped = after(sense > 0.0 ? limits.most : limits.least);
  const double again = after(sense > 0.0 ? limits.least : limits.most);
  return stopped < again ? say("not between {1} and {2}", place(stopped), place(again))
                         : say("only between {1} and {2}", place(again), place(stopped));
}

Message stops_on_a_line(const Limits& limits, const Axis& axis) {
  const auto [first, last] = std::minmax({axis.at.front(), axis.at.back()});
  const std::string least = limit_text(limits.least, axis.unit), most = limit_text(limits.most, axis.unit);
  if (first >= limits.least) return say("not above {1}", most);
  return last <= limits.most ? say("not below {1}", least) : say("not below {1} and above {2}", least, most);
}

}  // namespace

std::optional<Message> stops_of(const Solved& solved) {
  const auto limits = limits_of(solved);
  if (!limits || !explain(*limits, solved.proved, *solved.axis)) return std::nullopt;
  if (!solved.axis->cyclic()) return stops_on_a_line(*limits, *solved.axis);
  const bool both = std::isfinite(limits->least) && std::isfinite(limits->most);
  return both ? std::optional(stops_in_a_turn(*limits, *solved.axis)) : std::nullopt;
}

}  // namespace loadpath::planar
