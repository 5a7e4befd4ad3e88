#include "lib/sweep/statistics/confidence.hpp"

#include <boost/math/distributions/binomial.hpp>

namespace loadpath::sweep {

namespace {

using boost::math::policies::discrete_quantile;
using boost::math::policies::integer_round_up;
using boost::math::policies::policy;
using Binomial = boost::math::binomial_distribution<double, policy<discrete_quantile<integer_round_up>>>;

}  // namespace

Interval share_bounds(std::uint64_t met, std::uint64_t n, double confidence) {
  const double each = 0.5 * (1.0 - confidence), all = static_cast<double>(n), some = static_cast<double>(met);
  return {Binomial::find_lower_bound_on_p(all, some, each), Binomial::find_upper_bound_on_p(all, some, each)};
}

// The number of values up to the quantile is binomial: the value of rank r lies above it with the probability that the
// number stays below r.
RankBounds rank_bounds(std::uint64_t n, double p, double confidence) {
  const double each = 0.5 * (1.0 - confidence);
  const Binomial below(static_cast<double>(n), p);
  const double low = boost::math::quantile(below, each);
  const double high = boost::math::quantile(boost::math::complement(below, each));
  return {static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high) + 1};
}

}  // namespace loadpath::sweep
