#include "calculators/dynamics/initial_value.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace loadpath::dynamics {

namespace {

namespace odeint = boost::numeric::odeint;

constexpr double steps_of_range = 500.0, shortest = 1e-13;  // step over the range
constexpr double least_error = 1e-14;                       // in SI: unknowns may start at zero, and at rest
constexpr int most_steps = 200'000;

using Stepper = odeint::runge_kutta_dopri5<Unknowns>;

class Solver {
 public:
  using Visit = std::function<void(double t, const Unknowns& y)>;
  Solver(const InitialValue& problem, double tolerance, const Visit& visit)
      : problem_(problem), tolerance_(tolerance), visit_(visit), t_(problem.t_1), y_(problem.y) {}

  Solved run() {
    visit_(t_, y_);
    for (int step = 0; step < most_steps; ++step) {
      const double before = t_;
      const Unknowns from = y_;
      if (!advance(t_, y_, problem_.t_2)) return {Solved::End::no_slopes, t_, y_};
      if (const auto zero = first_zero(before, from)) return end_at(before, from, *zero);
      visit_turns(before, from);
      visit_(t_, y_);
      if (t_ >= problem_.t_2) return {Solved::End::time, t_, y_};
    }
    return {Solved::End::too_many_steps, t_, y_};
  }

 private:
  /// One step, at most to `last`; false if no step is short enough.
  bool advance(double& t, Unknowns& y, double last) {
    const double range = problem_.t_2 - problem_.t_1;
    const auto system = [this](const Unknowns& at, Unknowns& slopes, double time) { find_slopes(at, slopes, time); };
    auto controlled = odeint::make_controlled(least_error, tolerance_, Stepper());
    while (step_ > shortest * range) {
      const double to_last = last - t;
      double length = std::min({step_, range / steps_of_range, to_last}), at = t;
      Unknowns next = y;
      has_slopes_ = true;
      const auto tried = controlled.try_step(system, next, at, length);
      if (!has_slopes_) {
        step_ = 0.25 * std::min(step_, range / steps_of_range);
        continue;
      }
      step_ = length;
      if (tried == odeint::fail) continue;
      t = at >= last || last - at < shortest * range ? last : at;
      y = std::move(next);
      return true;
    }
    return false;
  }
  /// Slopes of zero in place of none: the step is refused afterwards.
  void find_slopes(const Unknowns& y, Unknowns& slopes, double t) {
    problem_.slopes(t, y, slopes);
    for (double& slope : slopes) {
      if (std::isfinite(slope)) continue;
      has_slopes_ = false;
      slope = 0.0;
    }
  }

  /// The unknowns at a time within a step that started there.
  Unknowns within(double from, const Unknowns& y, double t) {
    Unknowns at = y;
    const double kept = step_;
    step_ = std::max(t - from, shortest * (problem_.t_2 - problem_.t_1) * 2.0);
    while (from < t && advance(from, at, t)) {
    }
    step_ = kept;
    return at;
  }

  /// Where a function changes its sign in the last step. `sign`: its sign before, which a zero keeps.
  std::optional<double> change(const OfUnknowns& function, double& sign, double before, const Unknowns& from) {
    const double now = function(t_, y_);
    const double was = sign;
    if (now != 0.0 && std::isfinite(now)) sign = std::copysign(1.0, now);
    const bool reached = was != 0.0 && (now * was < 0.0 || now == 0.0);
    if (!reached) return std::nullopt;
    if (now == 0.0) return t_;
    const auto value = [&](double t) { return t == t_ ? now : function(t, within(before, from, t)); };
    const double start = function(before, from);
    if (!(start * was > 0.0)) return before;
    std::uintmax_t most = 60;
    const auto bracket = boost::math::tools::toms748_solve(value, before, t_, start, now,
                                                           boost::math::tools::eps_tolerance<double>(48), most);
    return bracket.second;
  }

  std::optional<double> first_zero(double before, const Unknowns& from) {
    if (!problem_.until) return std::nullopt;
    if (sign_ == 0.0) sign_ = sign_of(problem_.until, before, from);
    return change(problem_.until, sign_, before, from);
  }
  static double sign_of(const OfUnknowns& function, double t, const Unknowns& y) {
    const double value = function(t, y);
    return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0;
  }
  Solved end_at(double before, const Unknowns& from, double t) {
    Unknowns y = within(before, from, t);
    t_ = t, y_ = y;
    visit_turns(before, from);
    visit_(t, y);
    return {Solved::End::zero, t, std::move(y)};
  }
  void visit_turns(double before, const Unknowns& from) {
    signs_.resize(problem_.turns.size());
    std::vector<double> places;
    for (std::size_t k = 0; k < signs_.size(); ++k) {
      if (signs_[k] == 0.0) signs_[k] = sign_of(problem_.turns[k], before, from);
      if (const auto place = change(problem_.turns[k], signs_[k], before, from)) places.push_back(*place);
    }
    std::ranges::sort(places);
    for (const double t : places) visit_(t, within(before, from, t));
  }

  const InitialValue& problem_;
  double tolerance_;
  const Visit& visit_;
  double t_;
  Unknowns y_;
  double step_ = (problem_.t_2 - problem_.t_1) / steps_of_range;
  bool has_slopes_ = true;
  double sign_ = 0.0;          // of `until`
  std::vector<double> signs_;  // of the turns; 0: none yet
};

}  // namespace

Solved solve(const InitialValue& problem, double tolerance,
             const std::function<void(double t, const Unknowns& y)>& visit) {
  return Solver(problem, tolerance, visit).run();
}

}  // namespace loadpath::dynamics
