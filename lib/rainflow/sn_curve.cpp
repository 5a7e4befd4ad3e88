#include "lib/rainflow/sn_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace loadpath::rainflow {

namespace {

constexpr double least_slope = 1.0, largest_slope = 64.0, most = std::numeric_limits<double>::max();

bool is_positive(double x) { return x > 0.0 && std::isfinite(x); }

Fault refused(Message message, Message hint = {}) { return {0, 1, std::move(message), std::move(hint)}; }

std::string ordinal(std::size_t i) { return std::to_string(i + 1); }

/// The rule that branch i breaks.
std::optional<Fault> fault_of(std::span<const SnCurve::Branch> branches, std::size_t i) {
  const auto& [slope, until] = branches[i];
  if (!(slope >= least_slope && slope <= largest_slope))
    return refused(say("the slope of branch {1} must be between 1 and 64", ordinal(i)));
  if (until == SnCurve::Branch::endless) {
    if (i + 1 == branches.size()) return std::nullopt;
    return refused(say("branch {1} must end: another follows", ordinal(i)));
  }
  const double before = i == 0 ? 0.0 : branches[i - 1].until;
  if (!std::isfinite(until) || !(until > before))
    return refused(say("branch {1} must end at more cycles than what is before it", ordinal(i)));
  return std::nullopt;
}

/// The one branch of a curve, with its end at `from`; none if the curve is another.
const SnCurve::Segment* one_branch(const SnCurve& curve) {
  const auto segments = curve.segments();
  return segments.size() == 1 && segments[0].from > 0.0 ? segments.data() : nullptr;
}

Fault not_one_branch() {
  return refused(say("Miner's rules are for a curve of one branch that ends at the fatigue limit"),
                 say("a curve of several branches defines the range below its knee: use it unchanged"));
}

}  // namespace

Outcome<SnCurve> SnCurve::make(Measure measure, Point point, std::span<const Branch> branches) {
  if (!is_positive(point.stress) || !is_positive(point.cycles))
    return refused(say("the point of an S-N curve must have a stress and cycles above 0"));
  if (branches.empty()) return refused(say("an S-N curve has one branch or more"));
  SnCurve curve;
  curve.measure_ = measure;
  for (std::size_t i = 0; i < branches.size(); ++i) {
    if (auto fault = fault_of(branches, i)) return *fault;
    const auto& [slope, until] = branches[i];
    Segment segment{0.0, slope, point};
    if (until != Branch::endless) {
      segment.from = point.stress * std::pow(point.cycles / until, 1.0 / slope);
      if (!is_positive(segment.from)) return refused(say("branch {1} ends beyond all stresses", ordinal(i)));
      segment.point = {segment.from, until};  // the knee, where both branches give the same to the bit
      point = segment.point;
    }
    curve.segments_.push_back(segment);
  }
  return curve;
}

double SnCurve::damage(double stress) const {
  for (const Segment& segment : segments_) {
    if (stress >= segment.from && stress > 0.0)
      return std::min(std::pow(stress / segment.point.stress, segment.slope) / segment.point.cycles, most);
  }
  return 0.0;
}

std::optional<double> SnCurve::cycles(double stress) const {
  for (const Segment& segment : segments_) {
    if (!(stress >= segment.from && stress > 0.0)) continue;
    const double life = segment.point.cycles * std::pow(segment.point.stress / stress, segment.slope);
    return std::isfinite(life) ? std::optional(life) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<double> SnCurve::stress(double cycles) const {
  constexpr double rounding = 1.0 + 1e-9;  // summed lives: the end of a curve still belongs to it
  if (!is_positive(cycles)) return std::nullopt;
  for (const Segment& segment : segments_) {
    if (segment.from > 0.0 && cycles > rounding * segment.point.cycles) continue;
    const double on_branch = segment.point.stress * std::pow(segment.point.cycles / cycles, 1.0 / segment.slope);
    const double found = std::max(on_branch, segment.from);
    return is_positive(found) ? std::optional(found) : std::nullopt;
  }
  return std::nullopt;
}

Outcome<SnCurve> by_miner(const SnCurve& curve, Miner rule, double largest) {
  const SnCurve::Segment* const branch = one_branch(curve);
  if (branch == nullptr) return not_one_branch();
  const double k = branch->slope;
  const SnCurve::Point limit = branch->point;
  using Branches = std::vector<SnCurve::Branch>;
  const auto made = [&](const SnCurve::Point& point, const Branches& branches) {
    return SnCurve::make(curve.measure(), point, branches);
  };
  switch (rule) {
    case Miner::original:
      break;
    case Miner::elementary:
      return made(limit, {{k}});
    case Miner::modified:
      return made(limit, {{k, limit.cycles}, {2.0 * k - 1.0}});
    case Miner::liu_zenner: {
      constexpr double m = 3.6;
      if (!(largest >= limit.stress)) return SnCurve{};
      const auto life = curve.cycles(largest);
      if (!life) return refused(say("the largest cycle has no life on the curve"));
      const double slope = (k + m) / 2.0;
      return made({largest, *life}, {{slope, *life * std::pow(2.0 * largest / limit.stress, slope)}});
    }
  }
  return curve;
}

Outcome<double> consistent_damage(const SnCurve& curve, std::vector<Level> collective) {
  const SnCurve::Segment* const branch = one_branch(curve);
  if (branch == nullptr) return not_one_branch();
  const double k = branch->slope, q = k - 1.0;
  std::erase_if(collective, [](const Level& level) { return !(level.stress > 0.0 && level.count > 0.0); });
  std::sort(collective.begin(), collective.end(), [](const Level& a, const Level& b) { return a.stress > b.stress; });
  // While the limit falls from one level to the next, the damage of a collective stays the same.
  double borne = 0.0, per_collective = 0.0, damage = 0.0;
  for (std::size_t i = 0; i < collective.size(); ++i) {
    const double x = collective[i].stress / branch->point.stress;
    const double reached = x >= 1.0 ? 0.0 : 1.0 - std::pow(x, q);
    if (reached > damage) {
      if (per_collective == 0.0) return 0.0;  // nothing above the limit would lower it
      borne += (reached - damage) / per_collective;
      damage = reached;
    }
    per_collective += collective[i].count * std::pow(x, k) / branch->point.cycles;
  }
  if (per_collective == 0.0) return 0.0;
  borne += (1.0 - damage) / per_collective;
  const double share = 1.0 / borne;
  if (!std::isfinite(share)) return refused(say("the damage exceeds the range of numbers"));
  return share;
}

}  // namespace loadpath::rainflow
