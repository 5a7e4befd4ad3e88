#include "lib/numerics/fixed_point.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace loadpath;

namespace {

/// How often a function was called.
template <class Function>
int calls(const Function& function, double root, double most = 100.0) {
  int count = 0;
  const double found = numerics::fixed_point([&](double x) { return ++count, function(x); }, most);
  CAPTURE(found);
  CHECK(std::abs(found - root) <= 4e-16 * root);
  return count;
}

}  // namespace

TEST_SUITE("fixed point") {
  TEST_CASE("a constant takes two calls, a straight line three") {
    CHECK(calls([](double) { return 0.7; }, 0.7) == 2);
    CHECK(calls([](double x) { return 0.7 + 0.3 * x; }, 1.0) <= 4);
    CHECK(calls([](double x) { return 3.0 - 0.5 * x; }, 2.0) <= 4);
    CHECK(calls([](double) { return 0.0; }, 0.0) == 2);
  }

  TEST_CASE("curves and kinks are met to rounding") {
    CHECK(calls([](double x) { return std::sqrt(1.0 + 0.5 * x); }, 0.25 + std::sqrt(1.0625)) < 20);
    CHECK(calls([](double x) { return std::max(0.5 + 0.1 * x, 0.2 + 0.6 * x); }, 5.0 / 9.0) < 30);
    CHECK(calls([](double x) { return 1.0 / (1.0 + x); }, 0.5 * (std::sqrt(5.0) - 1.0)) < 20);
  }

  TEST_CASE("where there is no solution up to the bound the result is NaN") {
    CHECK(std::isnan(numerics::fixed_point([](double x) { return 1.0 + x; }, 100.0)));
    CHECK(std::isnan(numerics::fixed_point([](double x) { return 1.0 + 2.0 * x; }, 100.0)));
    CHECK(std::isnan(numerics::fixed_point([](double) { return 101.0; }, 100.0)));
    CHECK(std::isnan(numerics::fixed_point([](double) { return std::nan(""); }, 100.0)));
  }

  TEST_CASE("a straight line is met without a search") {
    CHECK(numerics::straight_fixed_point([](double) { return 0.7; }, 100.0) == 0.7);
    CHECK(numerics::straight_fixed_point([](double) { return 0.0; }, 100.0) == 0.0);
    CHECK(std::abs(numerics::straight_fixed_point([](double x) { return 0.7 + 0.3 * x; }, 100.0) - 1.0) < 1e-15);
    CHECK(std::abs(numerics::straight_fixed_point([](double x) { return 3.0 - 0.5 * x; }, 100.0) - 2.0) < 1e-15);
    CHECK(std::isnan(numerics::straight_fixed_point([](double x) { return 1.0 + x; }, 100.0)));
    CHECK(std::isnan(numerics::straight_fixed_point([](double x) { return 1.0 + 2.0 * x; }, 100.0)));
    CHECK(std::isnan(numerics::straight_fixed_point([](double) { return 101.0; }, 100.0)));
    CHECK(std::isnan(numerics::straight_fixed_point([](double) { return std::nan(""); }, 100.0)));
  }
}
