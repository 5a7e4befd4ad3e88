#include "lib/numerics/cube_root.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

TEST_SUITE("numerics") {
  TEST_CASE("the cube root is accurate to a unit in the last place, over all magnitudes") {
    for (double x = 1e-300; x < 1e300; x *= 1.0371) {
      const long double expected = std::cbrt(static_cast<long double>(x));
      CHECK(std::abs(static_cast<double>((loadpath::numerics::cube_root(x) - expected) / expected)) <= 2.23e-16);
      CHECK(loadpath::numerics::cube_root(-x) == -loadpath::numerics::cube_root(x));
    }
  }

  TEST_CASE("the cube roots of 0 and of NaN are themselves") {
    CHECK(loadpath::numerics::cube_root(0.0) == 0.0);
    CHECK(std::isnan(loadpath::numerics::cube_root(NAN)));
    for (const double n : {1.0, 2.0, 3.0, 10.0, 1e5}) CHECK(loadpath::numerics::cube_root(n * n * n) == n);
  }
}
