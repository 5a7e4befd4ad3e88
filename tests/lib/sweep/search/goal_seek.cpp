#include "lib/sweep/search/goal_seek.hpp"

#include "tests/lib/sweep/formula.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace loadpath::sweep;
using namespace loadpath::sweep::testing;
using std::numbers::pi;
using Kind = Solution::Kind;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

SeekResult seek_one(double (*f)(double), double from, double to, double target) {
  Formula function(1, 1, [f](const double* x, double* y) { y[0] = f(x[0]); });
  Goal goal;
  goal.from = from, goal.to = to, goal.target = target;
  const SeekResult sought = seek(function, {0.0}, goal);
  CHECK(sought.evaluations == function.points);
  return sought;
}

}  // namespace

TEST_SUITE("goal seek") {
  TEST_CASE("the diameter for a stress, with the other inputs at their base") {
    Formula shaft(2, 2, [](const double* x, double* y) {
      y[0] = x[0] * x[1];
      y[1] = 16.0 * x[1] / (pi * std::pow(x[0], 3));
    });
    Goal goal;
    goal.from = 0.01, goal.to = 0.2, goal.output = 1, goal.target = 60e6;
    const SeekResult found = seek(shaft, {0.05, 1500.0}, goal);
    REQUIRE(found.solutions.size() == 1);
    CHECK(found.solutions[0].kind == Kind::crossing);
    CHECK(found.solutions[0].at == doctest::Approx(std::cbrt(16.0 * 1500.0 / (pi * 60e6))).epsilon(1e-14));
    CHECK(found.solutions[0].within <= 1e-15);
    CHECK(found.value == doctest::Approx(60e6).epsilon(1e-14));
  }

  TEST_CASE("all roots of a wave are reported, in order") {
    const SeekResult found = seek_one([](double x) { return std::sin(x); }, 0.5, 20.0, 0.25);
    const double first = std::asin(0.25);
    REQUIRE(found.solutions.size() == 6);
    for (std::size_t k = 0; k < 6; ++k) {
      const double turn = 2.0 * pi * static_cast<double>((k + 1) / 2);
      const double root = k % 2 == 1 ? turn + first : turn + pi - first;
      CHECK(found.solutions[k].at == doctest::Approx(root).epsilon(1e-14));
      CHECK(found.solutions[k].kind == Kind::crossing);
    }
  }

  TEST_CASE("a root that touches, and two roots closer than the points apart") {
    const SeekResult touched = seek_one([](double x) { return (x - 0.7321) * (x - 0.7321); }, 0.0, 2.0, 0.0);
    REQUIRE(touched.solutions.size() == 1);
    CHECK(touched.solutions[0].kind == Kind::touching);
    CHECK(touched.solutions[0].at == doctest::Approx(0.7321).epsilon(1e-7));
    const SeekResult edge = seek_one([](double x) { return 3.0 + std::abs(x - 0.7321); }, 0.0, 2.0, 3.0);
    REQUIRE(edge.solutions.size() == 1);
    CHECK(edge.solutions[0].kind == Kind::touching);
    CHECK(edge.solutions[0].at == doctest::Approx(0.7321).epsilon(1e-12));
    const SeekResult twice = seek_one([](double x) { return (x - 0.7321) * (x - 0.7322); }, 0.0, 2.0, 0.0);
    REQUIRE(twice.solutions.size() == 2);
    CHECK(twice.solutions[0].at == doctest::Approx(0.7321).epsilon(1e-11));
    CHECK(twice.solutions[1].at == doctest::Approx(0.7322).epsilon(1e-11));
  }

  TEST_CASE("a miss is reported with the nearest value") {
    const SeekResult found = seek_one([](double x) { return 2.0 + (x - 1.0) * (x - 1.0); }, 0.0, 4.0, 1.5);
    CHECK(found.solutions.empty());
    CHECK(found.nearest == doctest::Approx(1.0).epsilon(1e-6));
    CHECK(found.value == doctest::Approx(2.0).epsilon(1e-12));
    const SeekResult rising = seek_one([](double x) { return x; }, 0.0, 4.0, 9.0);
    CHECK(rising.nearest == 4.0);
    CHECK(rising.value == 4.0);
    const SeekResult never = seek_one([](double) { return none; }, 0.0, 4.0, 9.0);
    CHECK(never.solutions.empty());
    CHECK(std::isnan(never.nearest));
  }

  TEST_CASE("a pole and a step are jumps, not roots") {
    const SeekResult pole = seek_one([](double x) { return 1.0 / (x - 0.3); }, -1.0, 1.0, 0.0);
    REQUIRE(pole.solutions.size() == 1);
    CHECK(pole.solutions[0].kind == Kind::leap);
    CHECK(pole.solutions[0].at == doctest::Approx(0.3).epsilon(1e-12));
    const SeekResult step = seek_one([](double x) { return x < 0.3 ? 1.0 : 2.0; }, -1.0, 1.0, 1.5);
    REQUIRE(step.solutions.size() == 1);
    CHECK(step.solutions[0].kind == Kind::leap);
  }

  TEST_CASE("a segment at the target is one solution, the ends of the range count") {
    const SeekResult flat = seek_one([](double x) { return x < 1.0 ? x : x > 2.0 ? x - 1.0 : 1.0; }, 0.0, 4.0, 1.0);
    REQUIRE(flat.solutions.size() == 1);
    CHECK(flat.solutions[0].kind == Kind::stretch);
    CHECK(flat.solutions[0].at == 1.0);
    CHECK(flat.solutions[0].to == 2.0);
    const SeekResult ends = seek_one([](double x) { return x * (x - 4.0); }, 0.0, 4.0, 0.0);
    REQUIRE(ends.solutions.size() == 2);
    CHECK(ends.solutions[0].at == 0.0);
    CHECK(ends.solutions[1].at == 4.0);
  }

  TEST_CASE("a root next to missing values is found") {
    // below 1.0003 there is nothing, the root is at 1.001, the next point of the range at 1.0078
    const SeekResult found = seek_one([](double x) { return x < 1.0003 ? none : std::log(x / 1.001); }, 0.0, 2.0, 0.0);
    REQUIRE(found.solutions.size() == 1);
    CHECK(found.solutions[0].at == doctest::Approx(1.001).epsilon(1e-12));
  }
}
