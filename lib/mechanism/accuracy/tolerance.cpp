#include "lib/mechanism/accuracy/tolerance.hpp"

#include "lib/mechanism/constraints/system.hpp"
#include "lib/mechanism/model/pair.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

namespace loadpath::mechanism {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-12;

double square(double x) { return x * x; }

/// Whether the dimension moves the point of the output on its link.
bool follows(const Output& output, const Tolerance& tolerance) {
  const bool is_place = output.kind == Output::Kind::x || output.kind == Output::Kind::y;
  return is_place && tolerance.moved && tolerance.moved->link == output.index &&
         length(tolerance.moved->point - output.point) == 0.0;
}

}  // namespace

double Output::value(const Position& at) const {
  switch (kind) {
    case Kind::effort:
      return at.effort[index];
    case Kind::reaction:
      return length(at.reactions[index].force);
    case Kind::phi:
      return at.pose[index].phi;
    case Kind::x:
    case Kind::y:
      break;
  }
  const Pose& pose = at.pose[index];
  const Vec arm = turn(pose.phi)(point);
  return kind == Kind::x ? pose.x + arm.x : pose.y + arm.y;
}

double Output::change(const Position& at, const Position& by) const {
  switch (kind) {
    case Kind::effort:
      return by.effort[index];
    case Kind::reaction: {
      const Vec force = at.reactions[index].force;
      return dot(force, by.reactions[index].force) / length(force);
    }
    case Kind::phi:
      return by.pose[index].phi;
    case Kind::x:
    case Kind::y:
      break;
  }
  const Pose& change = by.pose[index];
  const Vec moved = change.phi * normal(turn(at.pose[index].phi)(point));
  return kind == Kind::x ? change.x + moved.x : change.y + moved.y;
}

/// Mechanisms with their numbers at the ends of the tolerances, solved again from a position.
class ToleranceAnalysis::Corners {
 public:
  Corners(const Model& model, const Position& at, std::span<const Drive> drives, const Output& output,
          std::span<const Tolerance> tolerances, bool statics)
      : model_(model), at_(at), drives_(drives), output_(output), tolerances_(tolerances), statics_(statics) {
    for (std::size_t n = 0; n < model_.loads.size(); ++n) {
      model_.loads[n].force = at.loads[n].force;
      model_.loads[n].moment = at.loads[n].moment;
    }
  }

  [[nodiscard]] std::span<const Tolerance> tolerances() const { return tolerances_; }
  /// `side`: of each tolerance, in half widths.
  [[nodiscard]] std::optional<double> solve(std::span<const double> side) const {
    Model corner = model_;
    Output output = output_;
    for (std::size_t k = 0; k < tolerances_.size(); ++k) {
      const double by = side[k] * tolerances_[k].half_width;
      for (const Tolerance::Term& term : tolerances_[k].terms) number(corner, term.parameter) += by * term.weight;
      if (follows(output_, tolerances_[k])) output.point = output.point + by * tolerances_[k].moved->by;
    }
    take_phases(corner);
    for (std::size_t k = 0; k < corner.links.size(); ++k) corner.links[k].pose = at_.pose[k];
    WholeSystem system(corner);
    Position at = system.blank();
    if (system.assemble() != Status::closed || system.solve(drives_, at, statics_) != Status::closed) {
      return std::nullopt;
    }
    return output.value(at);
  }

 private:
  Model model_;
  const Position& at_;
  std::span<const Drive> drives_;
  const Output& output_;
  std::span<const Tolerance> tolerances_;
  bool statics_;
};

namespace {

/// Takes an output of a corner into the worst cases.
void include(const std::optional<double>& value, OutputError& error) {
  if (!value) {
    error.status = Status::does_not_close;
    return;
  }
  error.worst_high = std::max(error.worst_high, *value - error.nominal);
  error.worst_low = std::min(error.worst_low, *value - error.nominal);
}

/// The effects of the two ends of one tolerance.
struct Ends {
  double low_side = 0.0, high_side = 0.0;  // -1, 0 or 1: where the output is least and largest
  double span = 0.0;                       // range of the output
};

Ends ends_of(double nominal, const std::optional<double>& minus, const std::optional<double>& plus) {
  Ends ends;
  double low = nominal, high = nominal;
  const auto take = [&](const std::optional<double>& value, double side) {
    if (value && *value < low) low = *value, ends.low_side = side;
    if (value && *value > high) high = *value, ends.high_side = side;
  };
  take(minus, -1.0);
  take(plus, 1.0);
  ends.span = high - low;
  return ends;
}

}  // namespace

ToleranceAnalysis::ToleranceAnalysis(const Model& model) : model_(model), sensitivity_(model) {}

OutputError ToleranceAnalysis::find(const Position& at, std::span<const Drive> drives, const Output& output,
                                    std::span<const Tolerance> tolerances, std::span<const Clearance> clearances,
                                    bool statics) {
  OutputError error;
  error.nominal = output.value(at);
  error.status = sensitivity_.find(at, statics);
  if (error.status != Status::closed) return error;
  add_linear(output, at, tolerances, error);

  const Corners corners(model_, at, drives, output, tolerances, statics);
  std::vector<double> side(tolerances.size());
  const auto miss = [&](double sense, double linear) {
    for (std::size_t k = 0; k < side.size(); ++k) side[k] = std::copysign(sense, sense * error.shares[k]);
    const std::optional<double> value = corners.solve(side);
    return value ? std::abs(*value - error.nominal - linear) : infinite;
  };
  const double missed = std::max(miss(1.0, error.worst_high), miss(-1.0, error.worst_low));
  const bool is_rounding = missed <= rounding * std::abs(error.nominal);
  error.curvature = is_rounding ? 0.0 : (error.worst_high > 0.0 ? missed / error.worst_high : infinite);
  if (!(error.curvature <= most_curvature)) recompute(corners, error);

  add_clearances(output, at, clearances, error);
  error.deviation = std::sqrt(error.deviation);
  return error;
}

// The deviation is still a variance.
void ToleranceAnalysis::add_linear(const Output& output, const Position& at, std::span<const Tolerance> tolerances,
                                   OutputError& error) const {
  for (const Tolerance& tolerance : tolerances) {
    const double part = share(output, at, tolerance);
    error.shares.push_back(part);
    error.worst_high += std::abs(part);
    error.worst_low -= std::abs(part);
    error.deviation += square(part / tolerance.sigmas);
  }
}

double ToleranceAnalysis::share(const Output& output, const Position& at, const Tolerance& tolerance) const {
  double slope = 0.0;
  for (const Tolerance::Term& term : tolerance.terms) {
    const std::size_t p = sensitivity_.find_parameter(term.parameter);
    if (p < sensitivity_.parameters().size()) slope += term.weight * output.change(at, sensitivity_.by(p));
  }
  if (follows(output, tolerance)) {
    const Vec by = turn(at.pose[output.index].phi)(tolerance.moved->by);
    slope += output.kind == Output::Kind::x ? by.x : by.y;
  }
  return slope * tolerance.half_width;
}

void ToleranceAnalysis::recompute(const Corners& corners, OutputError& error) {
  const std::size_t count = corners.tolerances().size();
  error.recomputed = true;
  error.worst_low = error.worst_high = error.deviation = 0.0;
  std::vector<Ends> ends;
  std::vector<double> side(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto at_end = [&](double of) {
      side[k] = of;
      const std::optional<double> value = corners.solve(side);
      include(value, error);
      side[k] = 0.0;
      return value;
    };
    const auto minus = at_end(-1.0), plus = at_end(1.0);
    ends.push_back(ends_of(error.nominal, minus, plus));
    error.deviation += square(0.5 * ends[k].span / corners.tolerances()[k].sigmas);
  }
  std::vector<std::size_t> by_span(count);
  std::iota(by_span.begin(), by_span.end(), std::size_t{0});
  std::ranges::sort(by_span, std::greater{}, [&](std::size_t k) { return ends[k].span; });
  const std::size_t varied = std::min(count, most_varied);
  for (const bool high : {false, true}) {
    for (std::size_t k = 0; k < count; ++k) side[k] = high ? ends[k].high_side : ends[k].low_side;
    for (std::size_t corner = 0; corner < std::size_t{1} << varied; ++corner) {
      for (std::size_t n = 0; n < varied; ++n) side[by_span[n]] = (corner >> n & 1U) != 0U ? 1.0 : -1.0;
      include(corners.solve(side), error);
    }
    if (varied == count) break;
  }
}

void ToleranceAnalysis::add_clearances(const Output& output, const Position& at, std::span<const Clearance> clearances,
                                       OutputError& error) const {
  for (const Clearance& c : clearances) {
    const Vec by_direction = 0.5 * c.clearance * slope(output, at, c.joint);
    const Vec force = at.reactions[c.joint].force;
    if (c.direction == Clearance::Direction::along_reaction && length(force) > 0.0) {
      error.shift -= dot(by_direction, force) / length(force);  // the pin of i yields to the force on it
      continue;
    }
    const double share = length(by_direction);
    error.shares.push_back(share);
    error.worst_high += share;
    error.worst_low -= share;
    error.deviation += square(share / c.sigmas);
  }
}

/// The derivative of the output with respect to a shift of the pin on link j against the one on link i, global axes.
Vec ToleranceAnalysis::slope(const Output& output, const Position& at, std::size_t joint) const {
  const auto by = [&](Parameter::Dimension dimension) {
    return output.change(at, sensitivity_.by(sensitivity_.find_parameter({dimension, joint})));
  };
  const int j = model_.joints[joint].j;
  const double phi = j == ground ? 0.0 : at.pose[static_cast<std::size_t>(j)].phi;
  return turn(phi)({by(Parameter::Dimension::point_j_x), by(Parameter::Dimension::point_j_y)});
}

}  // namespace loadpath::mechanism
