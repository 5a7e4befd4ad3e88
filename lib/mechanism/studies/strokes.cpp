#include "lib/mechanism/studies/strokes.hpp"

#include "lib/mechanism/equations/kinematics.hpp"
#include "lib/mechanism/groups/system.hpp"
#include "lib/mechanism/studies/position_functions.hpp"
#include "lib/mechanism/studies/relative_motion.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loadpath::mechanism {
namespace {

// Relative to the largest derivative over the motion: smaller values are rounding errors.
constexpr double negligible = 1e-10;

struct Motion {
  double coordinate = 0.0, first = 0.0;
};

Motion motion_of(const Model& model, const Stroke& stroke, const Position& at) {
  if (stroke.of == Stroke::Of::link) return {at.pose[stroke.index].phi, at.velocity[stroke.index].phi};
  const RelativeMotion along = relative_motion(model.joints[stroke.index], at);
  return {along.s, along.s_dot};
}

/// The mechanism near one of the positions, to be moved by its drive.
class Neighbourhood {
 public:
  explicit Neighbourhood(const Model& model) : model_(model), system_(model_), at_(blank_position(model_)) {}

  void go_to(const Position& from) {
    start_ = drive_coordinate(model_, 0, from);
    const Drive drive{start_, 1.0, 0.0};
    closed_ = system_.hold(from.pose, {&drive, 1}) == Status::closed;
  }

  /// This far from where it started.
  std::optional<Motion> motion(const Stroke& stroke, double way) {
    const Drive drive{start_ + way, 1.0, 0.0};
    if (!closed_) return {};
    if (system_.solve_motion({&drive, 1}, at_) != Status::closed) return {};
    return motion_of(model_, stroke, at_);
  }

 private:
  const Model& model_;
  GroupSystem system_;
  Position at_;
  bool closed_ = false;
  double start_ = 0.0;
};

class Finder {
 public:
  Finder(const Model& model, const Course& course) : model_(model), course_(course), near_(model) {}

  /// Nothing if it does not move.
  std::optional<Stroke> find(Stroke::Of of, std::size_t index, double unit) {
    Stroke stroke{.of = of, .index = index};
    motions_.clear();
    double most = 0.0;
    for (std::size_t k = 0; k < course_.at.size(); ++k) {
      motions_.push_back(course_.known[k] ? motion_of(model_, stroke, course_.derivatives[k]) : Motion{});
      most = std::max(most, std::abs(motions_[k].first));
    }
    if (most <= negligible * unit) return {};
    least_ = negligible * most;
    find_reversals(stroke);
    measure(stroke);
    return stroke;
  }

 private:
  /// The first derivative, with rounding errors set to zero.
  [[nodiscard]] double first(std::size_t k) const {
    return std::abs(motions_[k].first) <= least_ ? 0.0 : motions_[k].first;
  }

  /// A zero at a position counts to the interval that follows, if the previous motion was in the opposite direction.
  void find_reversals(Stroke& stroke) {
    const std::size_t count = course_.at.size();
    const bool cyclic = course_.period != 0.0;
    double before = cyclic && course_.known[count - 1] ? first(count - 1) : 0.0;
    for (std::size_t k = 0; k < (cyclic ? count : count - 1); ++k) {
      const std::size_t next = (k + 1) % count;
      if (!course_.known[k] || !course_.known[next]) {
        before = 0.0;
        continue;
      }
      if (first(k) != 0.0) before = first(k);
      if (before * first(next) >= 0.0) continue;
      const double way = course_.at[next] - course_.at[k] + (next == 0 ? course_.period : 0.0);
      if (const auto reversal = refine(stroke, k, way)) stroke.reversals.push_back(*reversal);
    }
  }

  /// By regula falsi with halved ends (Illinois).
  std::optional<Reversal> refine(const Stroke& stroke, std::size_t k, double way) {
    constexpr int most_steps = 60;
    const Reversal here{course_.at[k], motions_[k].coordinate};
    if (first(k) == 0.0) return here;
    near_.go_to(course_.derivatives[k]);
    const auto end = near_.motion(stroke, way);
    if (!end) return {};
    double low = 0.0, high = way, at_low = first(k), at_high = end->first;
    for (int n = 0; n < most_steps; ++n) {
      const double middle = (low * at_high - high * at_low) / (at_high - at_low);
      const auto motion = near_.motion(stroke, middle);
      if (!motion) return {};
      if (std::abs(motion->first) <= 1e-3 * least_ || std::abs(high - low) <= 1e-13 * std::abs(way)) {
        return Reversal{course_.at[k] + middle, motion->coordinate};
      }
      const bool same_as_low = motion->first * at_low > 0.0;
      (same_as_low ? low : high) = middle;
      (same_as_low ? at_low : at_high) = motion->first;
      (same_as_low ? at_high : at_low) *= 0.5;
    }
    return {};
  }

  /// From the last position to the repetition of the first one.
  void complete_turn(const Stroke& stroke, std::vector<double>& places) {
    const std::size_t last = course_.at.size() - 1;
    if (!course_.known[last] || !course_.known[0]) return;
    near_.go_to(course_.derivatives[last]);
    if (const auto end = near_.motion(stroke, course_.at[0] + course_.period - course_.at[last]))
      places.push_back(end->coordinate);
  }

  void measure(Stroke& stroke) {
    std::vector<double> places;
    for (const Reversal& r : stroke.reversals) places.push_back(r.coordinate);
    for (std::size_t k = 0; k < course_.at.size(); ++k) {
      if (course_.known[k]) places.push_back(motions_[k].coordinate);
    }
    if (course_.period != 0.0 && stroke.reversals.empty()) complete_turn(stroke, places);
    const auto [low, high] = std::ranges::minmax(places);
    stroke.range = high - low;
    if (course_.period == 0.0 || stroke.reversals.size() != 2) return;
    const double turn = std::abs(course_.period);
    const double one = std::abs(stroke.reversals[1].drive - stroke.reversals[0].drive);
    stroke.time_ratio = std::max(one, turn - one) / std::min(one, turn - one);
  }

  const Model& model_;
  const Course& course_;
  Neighbourhood near_;
  std::vector<Motion> motions_;
  double least_ = 0.0;
};

}  // namespace

std::vector<Stroke> strokes(const Model& model, const Course& course) {
  std::vector<Stroke> all;
  if (course.at.size() < 2) return all;
  Finder finder(model, course);
  const double length = model.drivers[0].kind == Driver::Kind::rotary ? characteristic_length(model) : 1.0;
  const double unit_of_links = model.drivers[0].kind == Driver::Kind::rotary ? 1.0 : 1.0 / characteristic_length(model);
  const auto add = [&](Stroke::Of of, std::size_t index, double unit) {
    if (auto stroke = finder.find(of, index, unit)) all.push_back(std::move(*stroke));
  };
  for (std::size_t k = 0; k < model.links.size(); ++k) add(Stroke::Of::link, k, unit_of_links);
  for (std::size_t n = 0; n < model.joints.size(); ++n) {
    if (is_guided(model.joints[n])) add(Stroke::Of::guide, n, length);
  }
  return all;
}

}  // namespace loadpath::mechanism
