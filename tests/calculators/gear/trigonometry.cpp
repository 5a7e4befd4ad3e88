#include "calculators/gear/trigonometry.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <random>

namespace {

using namespace loadpath::numerics;

/// Units in the last place of the expected value by which they are apart.
double units_apart(double found, long double expected) {
  int exponent = 0;
  std::frexp(static_cast<double>(expected), &exponent);
  return static_cast<double>(std::abs(found - expected)) / std::ldexp(1.0, exponent - 53);
}

/// The most units over values drawn evenly.
template <class Own, class Exact>
double worst(Own own, Exact exact, double low, double high) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> between(low, high);
  double most = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double x = between(random);
    most = std::max(most, units_apart(own(x), exact(static_cast<long double>(x))));
  }
  return most;
}

using Long = long double;

}  // namespace

TEST_SUITE("trigonometry") {
  TEST_CASE("sine, cosine and tangent are right to a unit of the last place") {
    for (const double most : {1e-8, 0.7, 1.7, 7.0, 1e3, 1e5}) {
      CAPTURE(most);
      CHECK(worst([](double x) { return sine(x); }, [](Long x) { return std::sin(x); }, -most, most) < 1.0);
      CHECK(worst([](double x) { return cosine(x); }, [](Long x) { return std::cos(x); }, -most, most) < 1.0);
      CHECK(worst([](double x) { return tangent(x); }, [](Long x) { return std::tan(x); }, -most, most) < 1.0);
    }
  }

  TEST_CASE("also close to the zeros, where nearly all of the angle cancels") {
    for (int n = 1; n < 2000; ++n) {
      const double x = n * 1.5707963267948966;
      CHECK(units_apart(sine(x), std::sin(static_cast<Long>(x))) < 1.0);
      CHECK(units_apart(cosine(x), std::cos(static_cast<Long>(x))) < 1.0);
    }
  }

  TEST_CASE("arc tangent and arc cosine are right to a unit of the last place") {
    for (const double most : {1e-8, 0.5, 1.0, 3.0, 1e3, 1e300}) {
      CAPTURE(most);
      CHECK(worst([](double x) { return arc_tangent(x); }, [](Long x) { return std::atan(x); }, -most, most) < 1.0);
    }
    for (const double least : {-1.0, -0.51, 0.0, 0.49, 0.999999}) {
      CAPTURE(least);
      CHECK(worst([](double x) { return arc_cosine(x); }, [](Long x) { return std::acos(x); }, least, 1.0) < 1.0);
    }
  }

  TEST_CASE("the ends of the range, and NaN") {
    constexpr double pi = 3.141592653589793, infinity = std::numeric_limits<double>::infinity();
    CHECK(sine(0.0) == 0.0);
    CHECK(cosine(0.0) == 1.0);
    CHECK(arc_tangent(infinity) == pi / 2.0);
    CHECK(arc_tangent(-infinity) == -pi / 2.0);
    CHECK(arc_cosine(1.0) == 0.0);
    CHECK(arc_cosine(-1.0) == pi);
    CHECK(arc_cosine(0.0) == pi / 2.0);
    CHECK(std::isnan(arc_cosine(1.0000000001)));
    for (const double none : {static_cast<double>(NAN), infinity}) {
      CHECK(std::isnan(sine(none)));
      CHECK(std::isnan(tangent(none)));
    }
    CHECK(std::isnan(arc_tangent(NAN)));
  }
}
