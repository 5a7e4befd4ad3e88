#include "lib/numerics/spline.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using loadpath::RestToRestSpline;

TEST_SUITE("numerics") {
  TEST_CASE("two points give the cubic that starts and ends at rest") {
    const std::array x{1.0, 3.0}, y{10.0, 14.0};
    const RestToRestSpline spline(x, y);
    CHECK(spline.at(1.0).y == 10.0);
    CHECK(spline.at(3.0).y == doctest::Approx(14.0));
    CHECK(spline.at(2.0).y == doctest::Approx(12.0));
    CHECK(spline.at(2.0).first == doctest::Approx(1.5 * 4.0 / 2.0));
    CHECK(spline.at(1.0).second == doctest::Approx(6.0 * 4.0 / 4.0));
    CHECK(spline.at(1.0).first == doctest::Approx(0.0));
    CHECK(spline.at(0.0).y == 10.0);
    CHECK(spline.at(9.0).first == 0.0);
  }

  TEST_CASE("it goes through its points with continuous derivatives, and nears a smooth curve with the fourth power") {
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
        error = std::max(error, std::abs(spline.at(at).y - std::cos(at)));
      }
      for (std::size_t k = 1; k + 1 < count; ++k) {
        CHECK(spline.at(x[k]).y == doctest::Approx(y[k]));
        CHECK(spline.at(x[k] - 1e-9).second == doctest::Approx(spline.at(x[k] + 1e-9).second).epsilon(1e-6));
      }
      if (before > 0.0) CHECK(before / error == doctest::Approx(16.0).epsilon(0.2));
      before = error;
    }
  }
}
