// Whether all points of a column are within bounds, and whether a load acts at all of them.
#include "lib/project/sweep/points/bounds.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

using namespace loadpath;

namespace {

/// A column of 17 points: two lanes of eight and one more.
std::vector<double> column_of(double si, std::size_t at, double other) {
  std::vector<double> all(17, si);
  all[at] = other;
  return all;
}

}  // namespace

TEST_SUITE("project: bounds of columns") {
  TEST_CASE("a load acts at all points with one sign") {
    for (const std::size_t at : {0U, 7U, 8U, 15U, 16U}) {
      CHECK(project::all_act(column_of(2.0, at, 3.0)));
      CHECK(project::all_act(column_of(-2.0, at, -3.0)));
      for (const double other : {0.0, -0.0, -2.0, std::nan("")})
        CHECK_FALSE(project::all_act(column_of(2.0, at, other)));
      for (const double other : {0.0, -0.0, 2.0, std::nan("")})
        CHECK_FALSE(project::all_act(column_of(-2.0, at, other)));
    }
  }

  TEST_CASE("the least number acts, and so does an infinite one") {
    const double least = std::numeric_limits<double>::denorm_min(), infinity = std::numeric_limits<double>::infinity();
    for (const double si : {least, -least, infinity, -infinity}) CHECK(project::all_act(std::vector<double>(9, si)));
  }
}
