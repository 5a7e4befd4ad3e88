// Laws of uncertain inputs next to Boost.Math, which computes in extended precision.
#include "lib/sweep/point/distribution.hpp"

#include "lib/sweep/point/elementary.hpp"
#include "lib/sweep/point/probit.hpp"

#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <boost/math/distributions/uniform.hpp>
#include <boost/math/distributions/weibull.hpp>
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace {

using namespace loadpath::sweep;

constexpr std::size_t many = 100'000;

/// Probabilities all over (0, 1), a third of them small down to 1e-300, some near 1.
std::vector<double> probabilities() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<double> p;
  while (p.size() < many) {
    const double small = std::pow(10.0, -300.0 * share(random)), near_one = 1.0 - std::pow(10.0, -15.0 * share(random));
    for (const double at : {share(random), small, near_one}) {
      if (at > 0.0 && at < 1.0) p.push_back(at);
    }
  }
  return p;
}

/// The largest deviation from `expected`, related to it, or to `scale` where that is larger.
template <class Found, class Expected>
double worst(const Found& found, const Expected& expected, double scale = 0.0) {
  double deviation = 0.0;
  for (const double p : probabilities()) {
    const double exact = expected(p);
    deviation = std::max(deviation, std::abs(found(p) - exact) / std::max(std::abs(exact), scale));
  }
  return deviation;
}

template <class Known>
void compare(const Law& law, const Known& known, double tolerance, double scale) {
  const Distribution made(law);
  const auto own = [&](double p) { return made.quantile(p); };
  CHECK(worst(
            own, [&](double p) { return boost::math::quantile(known, p); }, scale) < tolerance);
  CHECK(made.mean() == doctest::Approx(boost::math::mean(known)).epsilon(1e-14));
  CHECK(made.sd() == doctest::Approx(boost::math::standard_deviation(known)).epsilon(1e-13));
  for (const double p : {1e-9, 0.001, 0.2, 0.5, 0.77, 0.999}) {
    const double x = boost::math::quantile(known, p);
    CHECK(made.density(x) == doctest::Approx(boost::math::pdf(known, x)).epsilon(1e-12));
    CHECK(made.cumulative(x) == doctest::Approx(p).epsilon(1e-7));
    CHECK(made.of_normal(probit(p)) == doctest::Approx(x).epsilon(1e-12));
  }
}

std::vector<Law> laws() {
  return {Normal{3.0, 2.0}, Uniform{-1.0, 4.0}, Triangular{1.0, 1.5, 4.0}, Lognormal{50.0, 5.0},
          Weibull{100.0, 2.5, 10.0}};
}

}  // namespace

TEST_SUITE("points of sweeps: distributions") {
  TEST_CASE("the normal quantile is Boost's to 1e-15, far into the tails") {
    const boost::math::normal_distribution<long double> normal;
    CHECK(worst([](double p) { return probit(p); },
                [&](double p) { return static_cast<double>(boost::math::quantile(normal, p)); }) < 1e-15);
    CHECK(probit(0.5) == 0.0);
    CHECK(probit(0.25) == -probit(0.75));
    CHECK(probit(5e-324) == doctest::Approx(-38.467405617144344).epsilon(1e-14));  // mpmath
  }

  TEST_CASE("logarithm and exponential are the C library's to 1e-15") {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> exponent(-700.0, 700.0);
    for (std::size_t i = 0; i < many; ++i) {
      const double x = exponent(random);
      CHECK_UNARY(std::abs(exponential(x) / std::exp(x) - 1.0) < 4e-16);
      CHECK_UNARY(std::abs(natural_log(std::exp(x)) / std::log(std::exp(x)) - 1.0) < 4e-16);
    }
    for (const double p : probabilities()) CHECK_UNARY(std::abs(log_of_survival(p) / -std::log1p(-p) - 1.0) < 1e-15);
    CHECK(std::isfinite(exponential(1e9)));
  }

  TEST_CASE("quantiles, densities and moments are Boost's") {
    compare(Normal{3.0, 2.0}, boost::math::normal(3.0, 2.0), 1e-14, 1.0);
    compare(Uniform{-1.0, 4.0}, boost::math::uniform(-1.0, 4.0), 1e-15, 1.0);
    compare(Triangular{1.0, 1.5, 4.0}, boost::math::triangular(1.0, 1.5, 4.0), 1e-15, 0.0);
    compare(Weibull{100.0, 2.5}, boost::math::weibull(2.5, 100.0), 1e-13, 0.0);
    compare(Weibull{2.0, 1.0}, boost::math::weibull(1.0, 2.0), 1e-13, 0.0);
    const double variance = std::log(1.0 + 0.04);  // variance of ln x, for sd/mean = 0.2
    compare(Lognormal{50.0, 10.0}, boost::math::lognormal(std::log(50.0) - variance / 2.0, std::sqrt(variance)), 1e-14,
            0.0);
  }

  TEST_CASE("a triangle may have its mode at an end") {
    const Distribution rising(Triangular{0.0, 1.0, 1.0}), falling(Triangular{0.0, 0.0, 1.0});
    CHECK(rising.quantile(0.25) == doctest::Approx(0.5));
    CHECK(falling.quantile(0.75) == doctest::Approx(0.5));
    CHECK(rising.density(1.0) == 2.0);
    CHECK(falling.density(0.0) == 2.0);
    CHECK(rising.cumulative(0.5) == doctest::Approx(0.25));
  }

  TEST_CASE("the location moves a Weibull distribution") {
    const Distribution moved(Weibull{100.0, 2.5, 10.0}), plain(Weibull{100.0, 2.5});
    CHECK(moved.quantile(0.3) == doctest::Approx(plain.quantile(0.3) + 10.0).epsilon(1e-15));
    CHECK(moved.mean() == doctest::Approx(plain.mean() + 10.0).epsilon(1e-15));
  }

  TEST_CASE("a column has the bits of its single values, in place too") {
    std::vector<double> p = probabilities();
    p.resize(3001);
    for (const Law& law : laws()) {
      const Distribution made(law);
      std::vector<double> x(p.size()), same = p;
      made.quantile(p, x);
      made.quantile(same, same);
      CHECK(same == x);
      for (std::size_t i = 0; i < p.size(); ++i) CHECK_UNARY(x[i] == made.quantile(p[i]));
    }
  }

  TEST_CASE("every value of a probability inside (0, 1) is finite") {
    for (const Law& law : laws()) {
      for (const double p : {5e-324, 0x1p-53, 0.5, 1.0 - 0x1p-53}) CHECK(std::isfinite(Distribution(law).quantile(p)));
      for (const double z : {-100.0, -37.0, 37.0}) CHECK(std::isfinite(Distribution(law).of_normal(z)));
      CHECK(refusal(law).empty());
    }
  }

  TEST_CASE("parameters that make no distribution are refused") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal(Normal{1.0, 0.0}).text() == "the standard deviation must be > 0");
    CHECK(refusal(Normal{nan, 1.0}).text() == "the parameters of a distribution must be numbers");
    CHECK(refusal(Uniform{2.0, 2.0}).text() == "min must be below max");
    CHECK(refusal(Triangular{1.0, 5.0, 4.0}).text() == "the mode must lie between min and max");
    CHECK(refusal(Lognormal{-1.0, 1.0}).text() == "the mean of a lognormal distribution must be > 0");
    CHECK(refusal(Weibull{0.0, 1.0}).text() == "the scale of a Weibull distribution must be > 0");
    CHECK(refusal(Weibull{1.0, -2.0}).text() == "the shape of a Weibull distribution must be > 0");
    for (const Law& law : {Law{Weibull{1.0, 0.005}}, Law{Lognormal{1.0, 1e200}}, Law{Uniform{-1e308, 1e308}}})
      CHECK(refusal(law).text() == "these parameters give values outside the range of numbers");
  }
}
