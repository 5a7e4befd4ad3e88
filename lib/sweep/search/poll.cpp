#include "lib/sweep/search/poll.hpp"

#include "lib/sweep/search/spread.hpp"

#include <algorithm>

namespace loadpath::sweep {

namespace {

/// Column j of the mirror I - 2 v v' / v'v, whose columns are orthogonal.
double mirrored(const std::vector<double>& v, double square, std::size_t i, std::size_t j) {
  return (i == j ? 1.0 : 0.0) - (square > 0.0 ? 2.0 * v[i] * v[j] / square : 0.0);
}

/// A vector that rotates with the number of the round; none in the first, where the directions are those of the axes.
std::vector<double> turned(const Spread& spread, std::uint64_t round, std::size_t n) {
  std::vector<double> v(n, 0.0);
  for (std::size_t i = 0; round > 0 && i < n; ++i) v[i] = 2.0 * spread(round, i) - 1.0;
  return v;
}

std::vector<Trial> around(const Trial& best, std::span<const std::size_t> free, double size,
                          const std::vector<double>& v) {
  double square = 0.0;
  for (const double x : v) square += x * x;
  std::vector<Trial> trials(2 * free.size(), best);
  for (std::size_t j = 0; j < trials.size(); ++j) {
    const double step = j % 2 == 0 ? size : -size;
    for (std::size_t i = 0; i < free.size(); ++i) {
      double& place = trials[j].at[free[i]];
      place = std::clamp(place + step * mirrored(v, square, i, j / 2), 0.0, 1.0);
    }
  }
  return trials;
}

}  // namespace

Trial polled(Trials& trials, Trial best, std::span<const std::size_t> free, double size) {
  constexpr double finest = 1e-8, widest = 0.25;
  constexpr std::uint64_t most = 1000;
  const int patience = free.size() > 1 ? 2 : 1;  // turned directions in vain before they are halved
  const Spread spread(free.size());
  int in_vain = 0;
  for (std::uint64_t round = 0; size > finest && round < most && trials.left() > 0; ++round) {
    auto poll = around(best, free, size, turned(spread, round, free.size()));
    trials.judge(poll);
    const auto found = std::min_element(poll.begin(), poll.end(),
                                        [](const Trial& a, const Trial& b) { return better(a.standing, b.standing); });
    if (better(found->standing, best.standing)) {
      best = *found;
      size = std::min(2.0 * size, widest);
      in_vain = 0;
    } else if (++in_vain >= patience) {
      size *= 0.5;
      in_vain = 0;
    }
  }
  return best;
}

}  // namespace loadpath::sweep
