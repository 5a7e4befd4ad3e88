// Lines of level against curves that are known, hatching against the area that it fills.
#include "lib/draw/chart/levels.hpp"

#include "lib/draw/chart/hatching.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <numbers>

using namespace loadpath::draw;
using namespace loadpath::figure;
using doctest::Approx;

namespace {

Lattice lattice_of(std::size_t columns, std::size_t rows) {
  Lattice lattice;
  for (std::size_t i = 0; i < columns; ++i) lattice.x.push_back(10.0 * static_cast<double>(i));
  for (std::size_t j = rows; j > 0; --j)
    lattice.y.push_back(10.0 * static_cast<double>(j - 1));  // falling, as on a page
  return lattice;
}

std::vector<double> values_of(const Lattice& lattice, const std::function<double(double, double)>& f) {
  std::vector<double> values;
  for (const double y : lattice.y) {
    for (const double x : lattice.x) values.push_back(f(x, y));
  }
  return values;
}

double length_of(const Strokes& strokes) {
  double sum = 0.0;
  for (const auto& [from, to] : strokes) sum += length(to - from);
  return sum;
}

}  // namespace

TEST_SUITE("lines of level") {
  TEST_CASE("of a plane are straight, from side to side") {  // through four columns and two rows
    const Lattice lattice = lattice_of(5, 4);
    const auto lines = level_lines(lattice, values_of(lattice, [](double x, double y) { return x + 2.0 * y; }), 35.0);
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].size() == 6);
    for (const Point p : lines[0]) CHECK(p.x + 2.0 * p.y == Approx(35.0));
  }

  TEST_CASE("of a hill close about its top") {
    const Lattice lattice = lattice_of(41, 41);
    const auto squares = [](double x, double y) { return (x - 200.0) * (x - 200.0) + (y - 200.0) * (y - 200.0); };
    const auto lines = level_lines(lattice, values_of(lattice, squares), 150.0 * 150.0);
    REQUIRE(lines.size() == 1);
    CHECK(length(lines[0].front() - lines[0].back()) == 0.0);
    double around = 0.0;
    for (std::size_t i = 1; i < lines[0].size(); ++i) {
      around += length(lines[0][i] - lines[0][i - 1]);
      CHECK(std::sqrt(squares(lines[0][i].x, lines[0][i].y)) == Approx(150.0).epsilon(1e-3));
    }
    CHECK(around == Approx(2.0 * std::numbers::pi * 150.0).epsilon(2e-3));
  }

  TEST_CASE("of a saddle do not cross") {
    const Lattice lattice = lattice_of(2, 2);
    const std::vector<double> values{1.0, 0.0, 0.0, 1.0};
    for (const double level : {0.4, 0.6}) {
      const auto lines = level_lines(lattice, values, level);
      REQUIRE(lines.size() == 2);
      for (const auto& line : lines) {
        REQUIRE(line.size() == 2);
        CHECK(length(line[1] - line[0]) == Approx(std::numbers::sqrt2 * 4.0));  // each cuts the nearer corner off
      }
    }
  }

  TEST_CASE("end where a value is missing") {
    const Lattice lattice = lattice_of(7, 5);
    std::vector<double> values = values_of(lattice, [](double, double y) { return y; });
    values[lattice.node(3, 2)] = std::numeric_limits<double>::quiet_NaN();
    const auto lines = level_lines(lattice, values, 15.0);
    CHECK(lines.size() == 2);
    for (const auto& line : lines) {
      for (const Point p : line) CHECK((p.x <= 20.0 || p.x >= 40.0));
    }
  }

  TEST_CASE("between four corners a value is bilinear") {
    const Lattice lattice = lattice_of(3, 3);
    const auto values = values_of(lattice, [](double x, double y) { return 2.0 + 3.0 * x - y + 0.5 * x * y; });
    const Point at{13.0, 4.0};
    CHECK(between(lattice, values, cell_at(lattice, at)) == Approx(2.0 + 39.0 - 4.0 + 26.0));
  }

  TEST_CASE("strokes fill what they hatch, and nothing else") {
    const Box area{0.0, 0.0, 300.0, 200.0};
    const auto in_disc = [](Point p) { return length(p - Point{150.0, 100.0}) < 80.0; };
    for (const bool rising : {false, true}) {
      const Strokes strokes = hatching(area, 5.0, rising, in_disc);
      const double apart = 5.0 / std::numbers::sqrt2;
      CHECK(length_of(strokes) * apart == Approx(std::numbers::pi * 80.0 * 80.0).epsilon(0.01));
      for (const auto& [from, to] : strokes) {
        CHECK(length(from - Point{150.0, 100.0}) < 80.2);
        CHECK((to.y - from.y < 0.0) == rising);
      }
      CHECK(length_of(hatching(area, 5.0, rising, [](Point) { return true; })) * apart ==
            Approx(300.0 * 200.0).epsilon(0.01));
    }
  }
}
