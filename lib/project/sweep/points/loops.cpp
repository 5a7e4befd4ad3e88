#include "lib/project/sweep/points/loops.hpp"

#include "lib/project/run/row_state.hpp"
#include "lib/sweep/columns.hpp"
#include "lib/sweep/nan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::project {

namespace {

using account::State;

constexpr double number(State state) { return static_cast<double>(static_cast<int>(state)); }
constexpr double pass = number(State::pass), accepted = number(State::accepted), open = number(State::open),
                 not_judged = number(State::not_judged);

static_assert(account::rank(State::pass) == static_cast<int>(State::pass) &&
                  account::rank(State::accepted) == static_cast<int>(State::accepted) &&
                  account::rank(State::open) == static_cast<int>(State::open) &&
                  account::rank(State::not_judged) == static_cast<int>(State::not_judged) &&
                  account::rank(State::not_covered) == static_cast<int>(State::not_covered) &&
                  account::rank(State::not_available) == static_cast<int>(State::not_available) &&
                  account::rank(State::fail) == static_cast<int>(State::fail),
              "the worst of several is the largest number");

/// Bounds that are part of what they bound.
Range closed(const Range& bounds) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {bounds.low_open ? std::nextafter(bounds.low, infinity) : bounds.low,
          bounds.high_open ? std::nextafter(bounds.high, -infinity) : bounds.high};
}

LOADPATH_COLUMNS double count_outside(double low, double high, const double* si, std::size_t n) {
  double count = 0.0;
  std::array<double, 8> lane{};
  std::size_t i = 0;
  for (; i + lane.size() <= n; i += lane.size()) {
    for (std::size_t k = 0; k < lane.size(); ++k) lane[k] += si[i + k] >= low && si[i + k] <= high ? 0.0 : 1.0;
  }
  for (; i < n; ++i) count += si[i] >= low && si[i] <= high ? 0.0 : 1.0;
  for (const double more : lane) count += more;
  return count;
}

/// Columns of one loop do not overlap.
struct Rows {
  double* __restrict worst, * __restrict checked, * __restrict utilisation;
};
struct States {
  double low, high, below, above;
};

LOADPATH_COLUMNS void take_checks(const States& states, const double* __restrict si, std::size_t n, const Rows& rows) {
  double* const __restrict worst = rows.worst, * const __restrict checked = rows.checked, * const __restrict utilisation = rows.utilisation;
  const double low = states.low, high = states.high, below = states.below, above = states.above;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = si[i], now = worst[i], used = utilisation[i];
    const double state = x < low ? below : x > high ? above : pass;
    const bool more = (state > now) | ((state == now) & !(used >= x));
    const bool taken = (x == x) & more;
    worst[i] = taken ? state : now;
    utilisation[i] = taken ? x : used;
    checked[i] = x == x ? 1.0 : checked[i];
  }
}

LOADPATH_COLUMNS void take_limits(const States& states, const double* __restrict si, std::size_t n, const Rows& rows) {
  double* const __restrict worst = rows.worst, * const __restrict utilisation = rows.utilisation;
  const double low = states.low, high = states.high, below = states.below, above = states.above;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = si[i], now = worst[i], used = utilisation[i];
    const double state = x < low ? below : x > high ? above : pass;
    const bool taken = (x == x) & (state > now);
    worst[i] = taken ? state : now;
    utilisation[i] = taken ? nan : used;
  }
}

/// What the rows of a mode have come to.
struct Judged {
  const double *worst, *checked, *utilisation;
};

LOADPATH_COLUMNS void judge_points(const Applies* __restrict applies, const Fold::Unjudged& by, const Judged& rows,
                                   std::size_t n, double* __restrict state, double* __restrict utilisation) {
  const double *const worst = rows.worst, *const checked = rows.checked, *const used = rows.utilisation;
  const double unseen = by.state[1], yes = by.state[2], no = by.state[0];
  const double least_checked = by.never ? 2.0 : by.needs_checks ? 1.0 : 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto when = static_cast<double>(static_cast<int>(applies[i]));
    const double left = when == 0.0 ? no : when == 1.0 ? unseen : yes;
    const double row = worst[i];
    const bool decided = (row > pass) | ((row == pass) & (checked[i] >= least_checked));
    const bool concerns = (when != 0.0) | (row > pass);
    const double came = decided ? row : left;
    const bool waits = (came == open) | (came == not_judged) | (came == accepted);
    state[i] = concerns ? came : absent_state;
    utilisation[i] = (concerns & !waits) ? used[i] : nan;
  }
}

LOADPATH_COLUMNS void leave_points(const Applies* __restrict applies, const std::array<double, 3>& by, std::size_t n,
                                   double* __restrict state) {
  const double unseen = by[1], yes = by[2];
  for (std::size_t i = 0; i < n; ++i) {
    const auto when = static_cast<double>(static_cast<int>(applies[i]));
    state[i] = when == 0.0 ? absent_state : when == 1.0 ? unseen : yes;
  }
}

LOADPATH_COLUMNS void begin_together(const double* __restrict state, const double* __restrict used,
                                     double instead_of_open, std::size_t n, const Rows& rows) {
  double* const __restrict worst = rows.worst, * const __restrict judged = rows.checked, * const __restrict utilisation = rows.utilisation;
  for (std::size_t i = 0; i < n; ++i) {
    const double here = state[i] == open ? instead_of_open : state[i];
    worst[i] = here;
    judged[i] = ((here >= 0.0) & (here != open)) ? 1.0 : 0.0;
    utilisation[i] = used[i];
  }
}

LOADPATH_COLUMNS void take_together(const double* __restrict state, const double* __restrict used,
                                    double instead_of_open, std::size_t n, const Rows& rows) {
  double* const __restrict worst = rows.worst, * const __restrict judged = rows.checked, * const __restrict utilisation = rows.utilisation;
  for (std::size_t i = 0; i < n; ++i) {
    const double here = state[i] == open ? instead_of_open : state[i], most_used = utilisation[i];
    worst[i] = here > worst[i] ? here : worst[i];
    judged[i] = ((here >= 0.0) & (here != open)) ? 1.0 : judged[i];
    const bool more = (used[i] > most_used) | (most_used != most_used);
    utilisation[i] = more ? used[i] : most_used;
  }
}

LOADPATH_COLUMNS void write_whole(const double* __restrict worst, const double* __restrict judged, std::size_t n,
                                  double* __restrict out) {
  for (std::size_t i = 0; i < n; ++i) {
    const double passed = judged[i] > 0.0 ? pass : open;
    out[i] = worst[i] <= open ? passed : worst[i];
  }
}

}  // namespace

bool all_within(const Range& bounds, std::span<const double> si) {
  const Range within = closed(bounds);
  return count_outside(within.low, within.high, si.data(), si.size()) == 0.0;
}

bool all_act(std::span<const double> si) {
  const double least = std::numeric_limits<double>::denorm_min(), infinity = std::numeric_limits<double>::infinity();
  return count_outside(least, infinity, si.data(), si.size()) == 0.0 ||
         count_outside(-infinity, -least, si.data(), si.size()) == 0.0;
}

void Fold::clear(std::size_t n) {
  worst_.assign(n, absent_state);
  checked_.assign(n, 0.0);
  utilisation_.assign(n, nan);
}

void Fold::take(const Range& closed, double below, double above, bool is_check, std::span<const double> si) {
  const States states{closed.low, closed.high, below, above};
  const Rows rows{worst_.data(), checked_.data(), utilisation_.data()};
  (is_check ? take_checks : take_limits)(states, si.data(), si.size(), rows);
}

void Fold::take_check(std::span<const double> utilisation) {
  take({-rounding_of_utilisation, 1.0 + rounding_of_utilisation}, number(State::not_covered), number(State::fail), true,
       utilisation);
}

void Fold::take_limit(const Range& bounds, bool is_criterion, std::span<const double> si) {
  const double outside = number(is_criterion ? State::fail : State::not_covered);
  take(closed(bounds), outside, outside, false, si);
}

void Fold::judge(std::span<const Applies> applies, const Unjudged& unjudged, ModeColumns& mode) const {
  const std::size_t n = applies.size();
  mode.state.resize(n);
  mode.utilisation.resize(n);
  const Judged rows{worst_.data(), checked_.data(), utilisation_.data()};
  judge_points(applies.data(), unjudged, rows, n, mode.state.data(), mode.utilisation.data());
}

void leave_mode(std::span<const Applies> applies, const Fold::Unjudged& unjudged, ModeColumns& mode) {
  mode.state.resize(applies.size());
  mode.utilisation.assign(applies.size(), nan);
  leave_points(applies.data(), unjudged.state, applies.size(), mode.state.data());
}

void Together::fold(std::span<const ModeColumns* const> modes, std::size_t n, bool is_strict) {
  for (auto* column : {&worst_, &judged_, &utilisation_}) column->resize(n);
  const Rows rows{worst_.data(), judged_.data(), utilisation_.data()};
  const double instead_of_open = is_strict ? not_judged : open;
  if (modes.empty()) {
    std::ranges::fill(worst_, absent_state);
    std::ranges::fill(judged_, 0.0);
    std::ranges::fill(utilisation_, nan);
    return;
  }
  begin_together(modes[0]->state.data(), modes[0]->utilisation.data(), instead_of_open, n, rows);
  for (const ModeColumns* mode : modes.subspan(1))
    take_together(mode->state.data(), mode->utilisation.data(), instead_of_open, n, rows);
}

void Together::write_passes(std::span<double> out) const {
  std::transform(worst_.begin(), worst_.begin() + static_cast<std::ptrdiff_t>(out.size()), out.begin(),
                 [](double worst) { return worst <= open ? 1.0 : 0.0; });
}

void Together::write_state(bool is_whole, std::span<double> out) const {
  if (is_whole)
    write_whole(worst_.data(), judged_.data(), out.size(), out.data());
  else
    std::copy_n(worst_.begin(), out.size(), out.begin());
}

}  // namespace loadpath::project
