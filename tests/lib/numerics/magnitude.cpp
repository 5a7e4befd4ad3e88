#include "lib/numerics/magnitude.hpp"

#include "lib/numerics/prandtl.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

TEST_SUITE("numerics") {
  using namespace loadpath::numerics;

  TEST_CASE("of values that differ only by rounding none exceeds the other") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double x : {1.0, 0.1, 7.0 / 3.0, -2.5, 1e300, 1e-300}) {
      CAPTURE(x);
      CHECK_FALSE(exceeds(std::nextafter(x, infinity), x));
      CHECK_FALSE(exceeds(x, std::nextafter(x, -infinity)));
      CHECK(exceeds(x + 2e-9 * std::abs(x), x));
      CHECK_FALSE(exceeds(x, x + 2e-9 * std::abs(x)));
      CHECK(exceeds(infinity, x));
      CHECK(exceeds(x, -infinity));
      CHECK_FALSE(exceeds(x, std::nan("")));
      CHECK_FALSE(exceeds(std::nan(""), x));
    }
    CHECK(exceeds(1e-300, 0.0));
  }

  TEST_CASE("in a twisted square the largest stress is at the first of eight equal places") {
    const std::array<PlanePoint, 4> exact{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}};
    for (std::size_t moved = 0; moved < 4; ++moved) {
      for (const double by : {-1e-15, 0.0, 1e-15}) {
        std::array<PlanePoint, 4> corners = exact;
        corners[moved].x += by, corners[moved].y -= by;
        const Contour contour = corners;
        const TorsionFunction found = torsion_function({&contour, 1}, 16);
        CHECK(found.at.x == doctest::Approx(0.5).epsilon(0.2));
        CHECK(found.at.x < 0.5);
        CHECK(std::abs(found.at.y) < 1e-12);
      }
    }
  }
}
