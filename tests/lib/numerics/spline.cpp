#include "lib/numerics/spline.hpp"

#include "lib/numerics/periodic_spline.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using loadpath::numerics::MonotoneSpline;
using loadpath::numerics::RestToRestSpline;

TEST_SUITE("numerics") {
  TEST_CASE("two points give the cubic that starts and ends at rest") {
    const std::array x{1.0, 3.0}, y{10.0, 14.0};
    const RestToRestSpline spline(x, y);
    CHECK(spline.at(1.0).value == 10.0);
    CHECK(spline.at(3.0).value == doctest::Approx(14.0));
    CHECK(spline.at(2.0).value == doctest::Approx(12.0));
    CHECK(spline.at(2.0).first == doctest::Approx(1.5 * 4.0 / 2.0));
    CHECK(spline.at(1.0).second == doctest::Approx(6.0 * 4.0 / 4.0));
    CHECK(spline.at(1.0).first == doctest::Approx(0.0));
    CHECK(spline.at(0.0).value == 10.0);
    CHECK(spline.at(9.0).first == 0.0);
  }

  TEST_CASE("it goes through its points with continuous derivatives, and converges with the fourth power") {
    double before = 0.0;
    for (const std::size_t count : {11U, 21U, 41U}) {
      std::vector<double> x, y;
      for (std::size_t k = 0; k < count; ++k) {
        x.push_back(3.14159265358979 * static_cast<double>(k) / static_cast<double>(count - 1));
        y.push_back(std::cos(x.back()));
      }
      const RestToRestSpline spline(x, y);
      double error = 0.0;
      for (int s = 0; s <= 1000; ++s) {
        const double at = 3.14159265358979 * s / 1000.0;
        error = std::max(error, std::abs(spline.at(at).value - std::cos(at)));
      }
      for (std::size_t k = 1; k + 1 < count; ++k) {
        CHECK(spline.at(x[k]).value == doctest::Approx(y[k]));
        CHECK(spline.at(x[k] - 1e-9).second == doctest::Approx(spline.at(x[k] + 1e-9).second).epsilon(1e-6));
      }
      if (before > 0.0) CHECK(before / error == doctest::Approx(16.0).epsilon(0.2));
      before = error;
    }
  }

  TEST_CASE("how far a spline overshoots its points") {
    // From rest through (0, 0), (1, 1), (2, 1): the slope at 1 is 3/4, and 1 + 3/4 t (1 - t)^2 is highest at t = 1/3.
    const std::array x{0.0, 1.0, 2.0}, y{0.0, 1.0, 1.0};
    const auto over = RestToRestSpline(x, y).largest_overshoot();
    CHECK(over.by == doctest::Approx(1.0 / 9.0));
    CHECK(over.x == doctest::Approx(4.0 / 3.0));
    CHECK(over.y == doctest::Approx(10.0 / 9.0));
    const std::array straight{0.0, 1.0, 2.0};
    CHECK(RestToRestSpline(x, straight).largest_overshoot().by <= 1e-15);
  }

  TEST_CASE("the monotone curve goes through its points, smoothly, and never beyond them") {
    const std::array x{0.0, 0.2, 1.0, 1.5, 3.0, 3.1}, y{0.0, 5.0, 5.0, 2.0, 1.9, -4.0};
    const MonotoneSpline curve(x, y);
    for (std::size_t k = 0; k < x.size(); ++k) CHECK(curve.at(x[k]).value == doctest::Approx(y[k]).epsilon(1e-12));
    for (std::size_t k = 1; k < x.size(); ++k) {
      for (int s = 0; s <= 200; ++s) {
        const double at = x[k - 1] + (x[k] - x[k - 1]) * s / 200.0, h = 1e-6;
        CAPTURE(at);
        CHECK(curve.at(at).value <= std::max(y[k - 1], y[k]) + 1e-12);
        CHECK(curve.at(at).value >= std::min(y[k - 1], y[k]) - 1e-12);
        CHECK(curve.at(at).first * (y[k] - y[k - 1]) >= -1e-9);
        if (s == 0 || s == 200) continue;
        const double slope = (curve.at(at + h).value - curve.at(at - h).value) / (2.0 * h);
        const double bend = (curve.at(at + h).first - curve.at(at - h).first) / (2.0 * h);
        CHECK(curve.at(at).first == doctest::Approx(slope).epsilon(1e-6).scale(10.0));
        CHECK(curve.at(at).second == doctest::Approx(bend).epsilon(1e-6).scale(1000.0));
      }
      CHECK(curve.at(x[k]).second == doctest::Approx(0.0).scale(1e3));
    }
    CHECK(curve.at(0.5).first == doctest::Approx(0.0));  // it dwells
    CHECK(curve.at(1.5).first == doctest::Approx(2.0 / (1.0 / -6.0 + 1.0 / (-0.1 / 1.5))));
  }

  TEST_CASE("a closed curve repeats after its period, wherever it begins") {
    const double period = 2.0 * std::numbers::pi;
    std::vector<double> x, y;
    for (int k = 0; k < 40; ++k) {
      x.push_back(1.0 + period * k / 40.0);
      y.push_back(std::sin(x.back()));
    }
    const loadpath::numerics::PeriodicSpline spline(x, y, period);
    const double h = period / 40.0;  // the bounds of Hall and Meyer for a fourth derivative of 1
    for (double at = -9.0; at < 20.0; at += 0.37) {
      CHECK(std::abs(spline.at(at).y - std::sin(at)) < 5.0 / 384.0 * h * h * h * h);
      CHECK(std::abs(spline.at(at).first - std::cos(at)) < h * h * h / 24.0);
      CHECK(std::abs(spline.at(at).second + std::sin(at)) < 3.0 / 8.0 * h * h);
    }
  }
}
