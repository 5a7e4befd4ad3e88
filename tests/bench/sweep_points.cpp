// Points of a sweep and statistics of their results, against plain loops with the standard library's generators and
// with sorting.
#include "lib/sweep/point/probit.hpp"
#include "lib/sweep/point/space.hpp"
#include "lib/sweep/statistics/summary.hpp"
#include "tests/bench/sweep.hpp"

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace {

using namespace loadpath;
using namespace loadpath::bench;
using namespace loadpath::sweep;
using std::numbers::pi;

constexpr double mean_T = 300.0, sd_T = 30.0, mean_tau = 40e6, sd_tau = 4e6;

/// A torque and an allowable stress that scatter.
Space scattered(double rho, Sampling sampling = Sampling::random) {
  Space::Random random;
  random.variables = {Distribution(Normal{mean_T, sd_T}), Distribution(Lognormal{mean_tau, sd_tau})};
  if (rho != 0.0) random.correlation = *Correlation::of({1.0, rho, rho, 1.0}, {"T", "tau"});
  random.samples = std::uint64_t{1} << 40;
  random.sampling = sampling;
  return *Space::of({}, random);
}

/// Two columns of points that go on and on.
struct Points {
  Space space;
  std::vector<double> T = std::vector<double>(points), tau = T;
  std::uint64_t first = 0;

  void operator()() {
    double* const columns[] = {T.data(), tau.data()};
    space.fill(first, points, columns);
    first += points;
  }
};

/// The same by the standard library.
struct PlainPoints {
  std::mt19937_64 random{1};
  std::normal_distribution<double> standard;
  std::vector<double> T = std::vector<double>(points), tau = T;

  void operator()() {
    const double variance = std::log1p((sd_tau / mean_tau) * (sd_tau / mean_tau)), sd = std::sqrt(variance);
    const double mean = std::log(mean_tau) - 0.5 * variance;
    for (std::size_t i = 0; i < points; ++i) {
      T[i] = mean_T + sd_T * standard(random);
      tau[i] = std::exp(mean + sd * standard(random));
    }
  }
};

void two_variables(benchmark::State& state) { compare(state, Points{scattered(0.0)}, PlainPoints{}); }
void two_correlated(benchmark::State& state) { compare(state, Points{scattered(0.6)}, PlainPoints{}); }
void two_by_latin_hypercube(benchmark::State& state) {
  compare(state, Points{scattered(0.0, Sampling::latin_hypercube)}, PlainPoints{});
}
void two_by_sobol(benchmark::State& state) { compare(state, Points{scattered(0.0, Sampling::sobol)}, PlainPoints{}); }

/// Compared with Boost.Math's quantile.
void normal_quantile(benchmark::State& state) {
  const std::vector<double> p = spread(0.0, 1.0, 3);
  std::vector<double> own(points), boosts(points);
  compare(
      state, [&] { probit(p, own); },
      [&] {
        const boost::math::normal_distribution<double> normal;
        for (std::size_t i = 0; i < points; ++i) boosts[i] = boost::math::quantile(normal, p[i]);
      });
}

/// Mean, standard deviation, ends and quantiles of a column, against keeping it and selecting three quantiles.
void summary(benchmark::State& state) {
  PlainPoints plain;
  plain();
  Summary all;
  std::uint64_t block = 0;
  std::vector<double> kept;
  double sums = 0.0;
  compare(
      state,
      [&] {
        all.add(block, block * points, plain.tau);
        ++block;
      },
      [&] {
        kept = plain.tau;
        double sum = 0.0, square = 0.0;
        for (const double x : kept) sum += x;
        for (const double x : kept) square += (x - sum / points) * (x - sum / points);
        sums += sum + square;
        for (const std::size_t rank : {points / 20, points / 2, points - points / 20}) {
          std::nth_element(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(rank), kept.end());
          sums += kept[rank];
        }
      });
  benchmark::DoNotOptimize(sums);
}

/// Sampled, a diameter and its twist by the formulas of a shaft, and both reduced: all that a point costs.
void torsion_reduced(benchmark::State& state) {
  Points made{scattered(0.0)};
  PlainPoints plain;
  std::vector<double> d(points), theta(points);
  Summary of_d, of_theta;
  std::uint64_t block = 0;
  std::vector<double> all_d, all_theta;
  const auto evaluate = [&](const std::vector<double>& T, const std::vector<double>& tau) {
    for (std::size_t i = 0; i < points; ++i) {
      d[i] = std::cbrt(16.0 * T[i] / (pi * tau[i]));
      theta[i] = T[i] / (80e9 * pi / 32.0 * d[i] * d[i] * d[i] * d[i]);
    }
  };
  compare(
      state,
      [&] {
        made();
        evaluate(made.T, made.tau);
        of_d.add(block, block * points, d);
        of_theta.add(block, block * points, theta);
        ++block;
      },
      [&] {
        plain();
        evaluate(plain.T, plain.tau);
        for (auto* const of : {&d, &theta}) {
          double sum = 0.0, square = 0.0;
          for (const double x : *of) sum += x, square += x * x;
          std::sort(of->begin(), of->end());
          benchmark::DoNotOptimize(sum + square);
        }
      });
}

}  // namespace

BENCHMARK(two_variables)->Iterations(100);
BENCHMARK(two_correlated)->Iterations(100);
BENCHMARK(two_by_latin_hypercube)->Iterations(100);
BENCHMARK(two_by_sobol)->Iterations(100);
BENCHMARK(normal_quantile)->Iterations(100);
BENCHMARK(summary)->Iterations(100);
BENCHMARK(torsion_reduced)->Iterations(100);
BENCHMARK_MAIN();
