#include "lib/account/fold.hpp"

#include "lib/account/rows.hpp"
#include "lib/simd/attributes.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::account {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double pass = number(State::pass), open = number(State::open), not_judged = number(State::not_judged);

/// Columns of one loop do not overlap.
struct Columns {
  double* __restrict worst, * __restrict counted, * __restrict utilisation;
};
struct States {
  double low, high, below, above;
};

/// The state of a row at a value within closed bounds, or beyond; absent if the value is NaN.
constexpr double state_at(const States& states, double x) {
  const double state = x < states.low ? states.below : x > states.high ? states.above : pass;
  return x == x ? state : absent_state;
}

LOADPATH_COLUMNS void take_checks(const States& all, const double* __restrict si, std::size_t n, const Columns& rows) {
  double* const __restrict worst = rows.worst, * const __restrict counted = rows.counted, * const __restrict utilisation = rows.utilisation;
  const States states = all;
  for (std::size_t i = 0; i < n; ++i) {
    const Folded row = Folded{worst[i], counted[i], utilisation[i]}.with_row(state_at(states, si[i]), si[i], true);
    worst[i] = row.worst;
    counted[i] = row.counted;
    utilisation[i] = row.utilisation;
  }
}

LOADPATH_COLUMNS void take_limits(const States& all, const double* __restrict si, std::size_t n, const Columns& rows) {
  double* const __restrict worst = rows.worst, * const __restrict utilisation = rows.utilisation;
  const States states = all;
  for (std::size_t i = 0; i < n; ++i) {
    const Folded row = Folded{worst[i], 0.0, utilisation[i]}.with_row(state_at(states, si[i]), nan, false);
    worst[i] = row.worst;
    utilisation[i] = row.utilisation;
  }
}

struct Rows {
  const double *worst, *counted, *utilisation;
};

LOADPATH_COLUMNS void judge_points(const Applies* __restrict applies, const Unjudged& unjudged, const Rows& rows,
                                   std::size_t n, double* __restrict state, double* __restrict utilisation) {
  const double *const worst = rows.worst, *const counted = rows.counted, *const used = rows.utilisation;
  const Unjudged by = unjudged;
  for (std::size_t i = 0; i < n; ++i) {
    const auto when = static_cast<double>(static_cast<int>(applies[i]));
    const Judged mode = judged({worst[i], counted[i], used[i]}, when, by);
    state[i] = mode.state;
    utilisation[i] = mode.utilisation;
  }
}

LOADPATH_COLUMNS void leave_points(const Applies* __restrict applies, const Unjudged& unjudged, std::size_t n,
                                   double* __restrict state) {
  const Unjudged by = unjudged;
  for (std::size_t i = 0; i < n; ++i)
    state[i] = judged(Folded{}, static_cast<double>(static_cast<int>(applies[i])), by).state;
}

LOADPATH_COLUMNS void begin_modes(const double* __restrict state, const double* __restrict used, double instead_of_open,
                                  std::size_t n, const Columns& all) {
  double* const __restrict worst = all.worst, * const __restrict counted = all.counted, * const __restrict utilisation = all.utilisation;
  for (std::size_t i = 0; i < n; ++i) {
    const Folded mode = Folded{}.with_mode(state[i], used[i], instead_of_open);
    worst[i] = mode.worst;
    counted[i] = mode.counted;
    utilisation[i] = mode.utilisation;
  }
}

LOADPATH_COLUMNS void take_modes(const double* __restrict state, const double* __restrict used, double instead_of_open,
                                 std::size_t n, const Columns& all) {
  double* const __restrict worst = all.worst, * const __restrict counted = all.counted, * const __restrict utilisation = all.utilisation;
  for (std::size_t i = 0; i < n; ++i) {
    const Folded modes{worst[i], counted[i], utilisation[i]};
    const Folded more = modes.with_mode(state[i], used[i], instead_of_open);
    worst[i] = more.worst;
    counted[i] = more.counted;
    utilisation[i] = more.utilisation;
  }
}

LOADPATH_COLUMNS void write_whole(const double* __restrict worst, const double* __restrict counted, std::size_t n,
                                  double* __restrict out) {
  for (std::size_t i = 0; i < n; ++i) out[i] = Folded{worst[i], counted[i], 0.0}.whole();
}

}  // namespace

Range closed(const Range& bounds) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {bounds.low_open ? std::nextafter(bounds.low, infinity) : bounds.low,
          bounds.high_open ? std::nextafter(bounds.high, -infinity) : bounds.high};
}

void RowColumns::clear(std::size_t n) {
  worst_.assign(n, absent_state);
  counted_.assign(n, 0.0);
  utilisation_.assign(n, nan);
}

void RowColumns::take_check(std::span<const double> utilisation) {
  const States states{-rounding_of_utilisation, 1.0 + rounding_of_utilisation, number(State::not_covered),
                      number(State::fail)};
  take_checks(states, utilisation.data(), utilisation.size(), {worst_.data(), counted_.data(), utilisation_.data()});
}

void RowColumns::take_limit(const Range& bounds, bool is_criterion, std::span<const double> si) {
  const double outside = number(is_criterion ? State::fail : State::not_covered);
  const Range within = closed(bounds);
  take_limits({within.low, within.high, outside, outside}, si.data(), si.size(),
              {worst_.data(), counted_.data(), utilisation_.data()});
}

void RowColumns::judge(std::span<const Applies> applies, const Unjudged& unjudged, ModeColumns& mode) const {
  const std::size_t n = applies.size();
  mode.state.resize(n);
  mode.utilisation.resize(n);
  const Rows rows{worst_.data(), counted_.data(), utilisation_.data()};
  judge_points(applies.data(), unjudged, rows, n, mode.state.data(), mode.utilisation.data());
}

void leave_mode(std::span<const Applies> applies, const Unjudged& unjudged, ModeColumns& mode) {
  mode.state.resize(applies.size());
  mode.utilisation.assign(applies.size(), nan);
  leave_points(applies.data(), unjudged, applies.size(), mode.state.data());
}

void VerdictColumns::fold(std::span<const ModeColumns* const> modes, std::size_t n, bool is_strict) {
  for (auto* column : {&worst_, &counted_, &utilisation_}) column->resize(n);
  const Columns all{worst_.data(), counted_.data(), utilisation_.data()};
  const double instead_of_open = is_strict ? not_judged : open;
  if (modes.empty()) {
    std::ranges::fill(worst_, absent_state);
    std::ranges::fill(counted_, 0.0);
    std::ranges::fill(utilisation_, nan);
    return;
  }
  begin_modes(modes[0]->state.data(), modes[0]->utilisation.data(), instead_of_open, n, all);
  for (const ModeColumns* mode : modes.subspan(1))
    take_modes(mode->state.data(), mode->utilisation.data(), instead_of_open, n, all);
}

void VerdictColumns::write_passes(std::span<double> out) const {
  std::transform(worst_.begin(), worst_.begin() + static_cast<std::ptrdiff_t>(out.size()), out.begin(),
                 [](double worst) { return worst <= open ? 1.0 : 0.0; });
}

void VerdictColumns::write_state(bool is_whole, std::span<double> out) const {
  if (is_whole)
    write_whole(worst_.data(), counted_.data(), out.size(), out.data());
  else
    std::copy_n(worst_.begin(), out.size(), out.begin());
}

}  // namespace loadpath::account
