// The rules that turn checks and limits into the state of a failure mode, and modes into a verdict: once, for one
// machine and for the columns of a sweep.
//
// States are numbers of account::State, for then a loop over columns has numbers of one width only, and goes through
// wide registers.
#pragma once

#include "lib/account/state.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace loadpath::account {

/// The state of a point, a part or a failure mode as a number of a column: that of State, or one of these.
constexpr double refused_state = 7.0;  // the point violates an input rule, or a value is outside the range of its field
constexpr double absent_state = -1.0;  // the mode does not concern the part

constexpr double number(State state) { return static_cast<double>(static_cast<int>(state)); }
constexpr State state_of(double number) { return static_cast<State>(static_cast<int>(number)); }

/// The combined result of the rows of a mode, or of the modes of a part.
struct Folded {
  double worst = absent_state;
  double counted = 0.0;  // above zero: a check among the rows, an assessed mode among the modes
  double utilisation = std::numeric_limits<double>::quiet_NaN();

  /// Adds a check or a limit: among equally bad ones the most utilised governs. An absent state is not a row.
  [[nodiscard]] constexpr Folded with_row(double state, double used, bool is_check) const {
    const bool worse = state > worst;
    const bool more = (used > utilisation) | ((utilisation != utilisation) & (used == used));
    const bool governs = worse | ((state == worst) & more);
    return {worse ? state : worst, (is_check & (state >= 0.0)) ? 1.0 : counted, governs ? used : utilisation};
  }
  /// Adds a mode. `instead_of_open`: the state of a mode that was not considered.
  [[nodiscard]] constexpr Folded with_mode(double state, double used, double instead_of_open) const {
    constexpr double open = number(State::open);
    const double here = state == open ? instead_of_open : state;
    const bool more = (used > utilisation) | (utilisation != utilisation);
    return {here > worst ? here : worst, ((here >= 0.0) & (here != open)) ? 1.0 : counted, more ? used : utilisation};
  }
  /// Combined state of all modes of a step or project: pass if at least one was assessed and none is worse.
  [[nodiscard]] constexpr double whole() const {
    constexpr double pass = number(State::pass), open = number(State::open);
    return worst > open ? worst : counted > 0.0 ? pass : open;
  }
};

/// The state of a mode that its rows do not decide.
struct Unjudged {
  std::array<double, 3> state{};        // by Applies
  double passed = number(State::pass);  // state if all rows pass
  bool needs_checks = false;            // limits do not suffice to assess it
  bool never = false;                   // rows that pass do not assess it: a check is missing
};

/// The state of one mode: absent_state if it does not concern the part.
struct Judged {
  double state = absent_state;
  double utilisation = std::numeric_limits<double>::quiet_NaN();
};
/// `applies`: the number of Applies.
constexpr Judged judged(const Folded& rows, double applies, const Unjudged& by) {
  constexpr double pass = number(State::pass), accepted = number(State::accepted),
                   not_judged = number(State::not_judged);
  const double left = applies == 0.0 ? by.state[0] : applies == 1.0 ? by.state[1] : by.state[2];
  const double least_counted = by.never ? 2.0 : by.needs_checks ? 1.0 : 0.0;
  const bool passes = (rows.worst == pass) & (rows.counted >= least_counted);
  const double came = rows.worst > pass ? rows.worst : passes ? by.passed : left;
  // A mode that does not concern the part, and yet does not pass, was seen wrongly: no verdict is better than its rows.
  const bool concerns = (applies != 0.0) | (rows.worst > pass);
  const bool waits = (came >= accepted) & (came <= not_judged);
  return {concerns ? came : absent_state,
          (concerns & !waits) ? rows.utilisation : std::numeric_limits<double>::quiet_NaN()};
}

/// One mode, point by point.
struct ModeColumns {
  std::vector<double> state, utilisation;
};

/// Combined results of the rows of a mode at every point.
class RowColumns {
 public:
  void clear(std::size_t n);
  /// NaN is not a row.
  void take_check(std::span<const double> utilisation);
  void take_limit(const Range& bounds, bool is_criterion, std::span<const double> si);
  void judge(std::span<const Applies> applies, const Unjudged& unjudged, ModeColumns& mode) const;

 private:
  std::vector<double> worst_, counted_, utilisation_;
};

/// A mode that has no rows.
void leave_mode(std::span<const Applies> applies, const Unjudged& unjudged, ModeColumns& mode);

/// Combined results of several modes at every point.
class VerdictColumns {
 public:
  /// `is_strict`: modes not considered count as not assessed.
  void fold(std::span<const ModeColumns* const> modes, std::size_t n, bool is_strict);

  [[nodiscard]] std::span<const double> utilisation() const { return utilisation_; }
  /// 1 where they pass, or are open, else 0.
  void write_passes(std::span<double> out) const;
  /// `is_whole`: of all modes of a step or of the project, which pass where something was assessed.
  void write_state(bool is_whole, std::span<double> out) const;

 private:
  std::vector<double> worst_, counted_, utilisation_;
};

/// Bounds that belong to the range.
Range closed(const Range& bounds);

}  // namespace loadpath::account
