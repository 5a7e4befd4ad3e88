#include "lib/mechanism/columns/largest.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace loadpath::mechanism;

TEST_SUITE("mechanism in columns") {
  TEST_CASE("the largest size and square are found in blocks of eight and behind them") {
    for (std::size_t place = 0; place < 19; ++place) {
      CAPTURE(place);
      std::vector<double> x(19, 1.0), y(19, 2.0);
      x[place] = -3.0, y[place] = 4.0;
      CHECK(largest_size(x) == 3.0);
      CHECK(largest_square(x, y) == 25.0);
      x[place] = std::numeric_limits<double>::quiet_NaN();
      CHECK(largest_size(x) == 1.0);
      CHECK(largest_square(x, y) == 5.0);
    }
    CHECK(largest_size({}) == 0.0);
  }

  TEST_CASE("squares are raised position by position, and a force that is not finite is reported") {
    for (std::size_t place = 0; place < 19; ++place) {
      CAPTURE(place);
      std::vector<double> x(19, 0.0), y(19, 1.0), most(19, 4.0);
      x[place] = 3.0, y[place] = 4.0;
      CHECK(raise_to_squares(x, y, most));
      take_roots(most);
      for (std::size_t k = 0; k < most.size(); ++k) CHECK(most[k] == (k == place ? 5.0 : 2.0));
      y[place] = std::numeric_limits<double>::infinity();
      CHECK_FALSE(raise_to_squares(x, y, most));
    }
  }
}
