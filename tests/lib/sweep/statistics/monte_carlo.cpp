// Samples, and their statistics, next to closed forms; seeds are fixed.
#include "lib/sweep/point/probit.hpp"
#include "lib/sweep/point/space.hpp"
#include "lib/sweep/statistics/covariances.hpp"
#include "lib/sweep/statistics/share.hpp"
#include "lib/sweep/statistics/summary.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

namespace {

using namespace loadpath::sweep;

constexpr std::size_t block_size = 4096;

/// y = 3 a - 2 b of two normal variables with a correlation of 0.5, over all points of a space.
struct Linear {
  Summary y;
  Share beyond;  // of 40
  Forest<Covariances> together;
};

Linear sampled(Sampling sampling, std::uint64_t samples, std::uint64_t seed) {
  Space::Random random;
  random.variables = {Distribution(Normal{10.0, 2.0}), Distribution(Normal{4.0, 3.0})};
  random.correlation = *Correlation::of({1.0, 0.5, 0.5, 1.0}, {"a", "b"});
  random.samples = samples;
  random.seed = seed;
  random.sampling = sampling;
  const Space space = *Space::of({}, random);
  std::vector<double> a(block_size), b(block_size), y(block_size);
  double* const columns[] = {a.data(), b.data()};
  Linear all;
  for (std::uint64_t first = 0; first < samples; first += block_size) {
    const std::size_t n = std::min<std::uint64_t>(block_size, samples - first);
    space.fill(first, n, columns);
    for (std::size_t i = 0; i < n; ++i) {
      y[i] = 3.0 * a[i] - 2.0 * b[i];
      all.beyond.met += y[i] > 40.0 ? 1 : 0;
    }
    all.beyond.count += n;
    all.y.add(first / block_size, first, {y.data(), n});
    const double* const three[] = {a.data(), b.data(), y.data()};
    all.together.add(first / block_size, Covariances(three, n));
  }
  return all;
}

// mean 3*10 - 2*4; variance 9*4 + 4*9 - 2*6*0.5*2*3
constexpr double mean = 22.0, sd = 6.0;

}  // namespace

TEST_SUITE("statistics of sweeps: Monte Carlo") {
  TEST_CASE("a linear function of normal variables has its closed form within the stated confidence") {
    constexpr std::uint64_t n = 400'000;
    const Linear found = sampled(Sampling::random, n, 11);
    const Moments moments = found.y.moments();
    const double sigmas = 3.3;  // 99.9 %
    CHECK(std::abs(moments.mean() - mean) < sigmas * moments.error());
    CHECK(std::abs(moments.sd() / sd - 1.0) < sigmas / std::sqrt(2.0 * n));
    CHECK(std::abs(moments.skewness()) < sigmas * std::sqrt(6.0 / n));
    CHECK(std::abs(moments.kurtosis()) < sigmas * std::sqrt(24.0 / n));
    for (const double p : {0.001, 0.05, 0.5, 0.95, 0.999}) {
      const double exact = mean + sd * probit(p);
      const Interval bounds = found.y.ranks().quantile_bounds(p, 0.999);
      CHECK(bounds.low < exact);
      CHECK(exact < bounds.high);
      CHECK(bounds.low < found.y.ranks().quantile(p));
      CHECK(found.y.ranks().quantile(p) < bounds.high);
    }
    const double fails = Distribution(Normal{}).cumulative((mean - 40.0) / sd);
    const Interval share = found.beyond.bounds(0.999);
    CHECK(share.low < fails);
    CHECK(fails < share.high);
    const Covariances together = found.together.total();
    CHECK(std::abs(together.correlation(0, 1) - 0.5) < sigmas * 0.75 / std::sqrt(n));
    // cov(a, y) = 3*4 - 2*0.5*2*3 = 6; cov(b, y) = 3*0.5*2*3 - 2*9 = -9
    CHECK(together.correlation(0, 2) == doctest::Approx(6.0 / (2.0 * sd)).epsilon(0.01));
    CHECK(together.correlation(1, 2) == doctest::Approx(-9.0 / (3.0 * sd)).epsilon(0.01));
  }

  TEST_CASE("bounds of a quantile contain it as often as stated") {
    int held = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      const Interval bounds = sampled(Sampling::random, 200, seed).y.ranks().quantile_bounds(0.9, 0.95);
      held += bounds.low <= mean + sd * probit(0.9) && mean + sd * probit(0.9) <= bounds.high ? 1 : 0;
    }
    CHECK(held >= 366);  // of 400 at 95 %: fewer with a probability of 0.1 %
  }

  TEST_CASE("a Latin hypercube is closer to the mean than plain samples") {
    double plain = 0.0, latin = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      plain += std::abs(sampled(Sampling::random, 1000, seed).y.moments().mean() - mean);
      latin += std::abs(sampled(Sampling::latin_hypercube, 1000, seed).y.moments().mean() - mean);
    }
    CHECK(latin < 0.1 * plain);
  }
}
