#include "lib/quantity/extremes/extremes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace loadpath;
using std::numbers::pi;

namespace {

Axis turn(std::size_t positions, double bend = 0.0) {
  Axis axis{"crank", "angle", "deg", {}, {}, 2.0 * pi};
  for (std::size_t i = 0; i < positions; ++i) {
    const double even = 2.0 * pi * static_cast<double>(i) / static_cast<double>(positions);
    axis.at.add(even + bend * std::sin(even));
  }
  return axis;
}

std::vector<double> waves(const Axis& axis) {
  std::vector<double> si;
  for (const double t : axis.at.numbers()) si.push_back(std::cos(t + 0.4) + 0.5 * std::cos(7.0 * t + 0.3) - 0.25);
  return si;
}

}  // namespace

// The extremes of the waves: by Newton's method from a grid of 200,000 places, in Python.
TEST_SUITE("quantity") {
  TEST_CASE("of several summits the highest is refined, on even and on uneven positions") {
    for (const double bend : {0.0, 0.2}) {
      for (const std::size_t positions : {358U, 359U, 360U, 361U, 720U}) {
        CAPTURE(bend);
        CAPTURE(positions);
        const Axis axis = turn(positions, bend);
        const std::vector<double> si = waves(axis);
        const SeriesView series{si, &axis};
        CHECK(maximum(series).value == doctest::Approx(1.189303541323).epsilon(1e-5));
        CHECK(maximum(series).at == doctest::Approx(6.2265651868).epsilon(1e-4));
        CHECK(minimum(series).value == doctest::Approx(-1.689303541323).epsilon(1e-5));
        CHECK(largest(series).at == doctest::Approx(3.0849725332).epsilon(1e-4));
      }
    }
  }

  TEST_CASE("of a series without negative values the largest is its maximum, but for a constant one its first place") {
    const Axis axis = turn(360);
    std::vector<double> si;
    for (const double t : axis.at.numbers()) si.push_back(2.0 + std::cos(t - 1.0));
    CHECK(largest(SeriesView{si, &axis}).value == doctest::Approx(3.0).epsilon(1e-12));
    si.assign(360, 2.0);
    CHECK(largest(SeriesView{si, &axis}).value == 2.0);
    CHECK(largest(SeriesView{si, &axis}).nearest == 0);
  }

  TEST_CASE("a view of another length than its axis, or with a value that is not finite, has no extreme") {
    const Axis axis = turn(360);
    std::vector<double> si = waves(axis);
    si[200] = std::numeric_limits<double>::infinity();
    CHECK(std::isnan(maximum(SeriesView{si, &axis}).value));
    CHECK(std::isnan(largest(SeriesView{si, &axis}).value));
    si.resize(100);
    CHECK(std::isnan(maximum(SeriesView{si, &axis}).value));
  }
}
