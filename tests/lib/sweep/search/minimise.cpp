#include "lib/sweep/search/minimise.hpp"

#include "tests/lib/sweep/formula.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

using namespace loadpath::sweep;
using namespace loadpath::sweep::testing;
using std::numbers::pi;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr auto at_most_one = Constraint::Kind::at_most_one, is_one = Constraint::Kind::is_one;
using Outcome = Neighbour::Outcome;

Variable range(double from, double to) {
  Variable variable;
  variable.from = from, variable.to = to;
  return variable;
}

Variable stock(std::vector<double> values, bool ordered = true) {
  Variable variable;
  variable.values = std::move(values), variable.ordered = ordered;
  return variable;
}

/// A strut of length 2 m in steel under 100 kN by diameter and wall, in mm: mass, Euler's load twofold, yielding,
/// whether it is a tube, and the flag of all.
void strut(const double* x, double* y) {
  const double d = x[0], s = x[1], inner = d - 2.0 * s;
  const double A = pi / 4.0 * (d * d - inner * inner), I = pi / 64.0 * (std::pow(d, 4) - std::pow(inner, 4));
  y[0] = 7.85e-6 * A * 2000.0;
  y[1] = inner > 0.0 ? 2.0 * 100e3 * 2000.0 * 2000.0 / (pi * pi * 210e3 * I) : none;
  y[2] = 1.5 * 100e3 / (A * 235.0);
  y[3] = y[1] <= 1.0 && y[2] <= 1.0 ? 1.0 : 0.0;
}

const std::vector<double> diameters{20, 25, 30, 38, 42.4, 48.3, 51, 60.3, 63.5, 70, 76.1, 88.9, 101.6, 114.3};
const std::vector<double> walls{1.6, 2, 2.6, 2.9, 3.2, 3.6, 4, 4.5, 5, 5.6, 6.3, 7.1, 8, 10, 12.5};

/// The best tube by two loops, first of equal ones.
std::vector<double> lightest_tube() {
  std::vector<double> best;
  double least = 1e300, y[4];
  for (const double d : diameters) {
    for (const double s : walls) {
      const double x[] = {d, s};
      strut(x, y);
      if (y[3] == 1.0 && y[0] < least) least = y[0], best = {d, s};
    }
  }
  return best;
}

Effort searching() {
  Effort effort;
  effort.enumerated = 0;
  return effort;
}

bool same(const Optimum& a, const Optimum& b) {
  bool alike = a.point == b.point && a.outputs == b.outputs && a.evaluations == b.evaluations &&
               a.neighbours.size() == b.neighbours.size();
  for (std::size_t i = 0; alike && i < a.neighbours.size(); ++i)
    alike = a.neighbours[i].point == b.neighbours[i].point && a.neighbours[i].broken == b.neighbours[i].broken;
  return alike;
}

}  // namespace

TEST_SUITE("search for the best design") {
  TEST_CASE("a tube of the stock is the one of two loops, enumerated or searched") {
    Formula function(2, 4, strut);
    for (const auto& constraints :
         {std::vector<Constraint>{{1, at_most_one}, {2, at_most_one}, {3, is_one}}, {{3, is_one}}}) {
      const Problem problem{function, {stock(diameters), stock(walls)}, 0, false, constraints};
      const Optimum all = minimise(problem), found = minimise(problem, searching());
      CHECK(all.scope == Optimum::Scope::every_point);
      CHECK(found.scope == Optimum::Scope::local);
      CHECK(all.point == lightest_tube());
      CHECK(found.point == lightest_tube());
    }
  }

  TEST_CASE("each neighbour in the stock is named with the constraint it violates") {
    Formula function(2, 4, strut);
    const Problem problem{
        function, {stock(diameters), stock(walls)}, 0, false, {{1, at_most_one}, {2, at_most_one}, {3, is_one}}};
    const Optimum found = minimise(problem);
    REQUIRE(found.neighbours.size() == 4);
    for (const Neighbour& next : found.neighbours) {
      double y[4];
      strut(next.point.data(), y);
      const bool allowed = y[3] == 1.0;
      CHECK(next.outcome == (allowed ? Outcome::no_better : Outcome::breaks));
      CHECK(next.outputs[0] == y[0]);
      if (allowed) CHECK(y[0] >= found.outputs[0]);
      if (!allowed) CHECK(next.broken == (y[2] > y[1] ? 1 : 0));
      if (allowed) CHECK(next.broken == 3);
      CHECK((next.point[next.variable] > found.point[next.variable]) == next.up);
    }
    CHECK(std::count_if(found.neighbours.begin(), found.neighbours.end(),
                        [](const Neighbour& next) { return next.outcome == Outcome::breaks; }) >= 1);
  }

  // Diameter from the stock, length free: at most as long as buckling allows, for each diameter in closed form.
  TEST_CASE("stock and a continuous variable together") {
    Formula rod(2, 2, [](const double* x, double* y) {
      const double d = x[0], l = x[1];
      y[0] = l / d - 0.02 * d * d;  // slender, but thin
      y[1] = 30e3 * l * l / (pi * pi * 210e3 * pi / 64.0 * std::pow(d, 4));
    });
    double best = -1e300, diameter = 0.0;
    for (const double d : diameters) {
      const double l = std::min(3000.0, std::sqrt(pi * pi * 210e3 * pi / 64.0 / 30e3) * d * d);
      if (l / d - 0.02 * d * d > best) best = l / d - 0.02 * d * d, diameter = d;
    }
    const Problem problem{rod, {stock(diameters), range(100, 3000)}, 0, true, {{1, at_most_one}}};
    const Optimum found = minimise(problem);
    CHECK(found.scope == Optimum::Scope::every_combination);
    CHECK(found.point[0] == diameter);
    CHECK(found.outputs[0] == doctest::Approx(best).epsilon(1e-8));
    int resized = 0;
    for (const Neighbour& next : found.neighbours) {
      CHECK(next.outcome != Outcome::better);
      if (next.resized) ++resized;
    }
    CHECK(resized == 2);
  }

  // min x + y outside a circle that only a flag shows: at x = y = sqrt(1/2).
  TEST_CASE("a flag alone limits the search, too") {
    Formula circle(2, 2, [](const double* x, double* y) {
      y[0] = x[0] + 2.0 * x[1];
      y[1] = std::hypot(x[0] - 3.0, x[1] - 3.0) <= 1.0 ? 1.0 : 0.0;
    });
    const Problem problem{circle, {range(0, 5), range(0, 5)}, 0, false, {{1, is_one}}};
    const Optimum found = minimise(problem);
    CHECK(found.allowed);
    CHECK(found.outputs[0] == doctest::Approx(9.0 - std::sqrt(5.0)).epsilon(1e-4));
  }

  TEST_CASE("a kink in the objective and one in a constraint are reached") {
    // max(|x - 1|, |y - 2|) + x/10 with u = max(x, y): the corner where |x - 1| = |y - 2|, y = 1
    Formula kinked(2, 2, [](const double* x, double* y) {
      y[0] = std::max(std::abs(x[0] - 1.0), std::abs(x[1] - 2.0)) + x[0] / 10.0;
      y[1] = std::max(x[0], x[1]);
    });
    const Problem problem{kinked, {range(-3, 3), range(-3, 3)}, 0, false, {{1, at_most_one}}};
    const Optimum found = minimise(problem);
    CHECK(found.outputs[0] == doctest::Approx(1.0).epsilon(1e-6));  // x = 0, y = 1
    CHECK(found.point[0] == doctest::Approx(0.0).epsilon(1e-5).scale(1.0));
  }

  TEST_CASE("the lowest of many valleys is found") {
    Formula valleys(2, 1, [](const double* x, double* y) {
      y[0] = 20.0;
      for (int i = 0; i < 2; ++i) {
        const double t = x[i] - 1.3;
        y[0] += t * t - 10.0 * std::cos(2.0 * pi * t);
      }
    });
    const Problem problem{valleys, {range(-3, 4), range(-3, 4)}, 0, false, {}};
    Effort effort;
    effort.starts = 20;
    const Optimum found = minimise(problem, effort);
    CHECK(found.point[0] == doctest::Approx(1.3).epsilon(1e-6));
    CHECK(found.point[1] == doctest::Approx(1.3).epsilon(1e-6));
  }

  TEST_CASE("words are neighbours of each other") {
    // material, diameter: price; the third word is the best, and no step of one leads to it over the second
    const std::vector<double> strength{235, 100, 900, 300}, price{1.0, 3.0, 2.0, 1.5};
    Formula shaft(2, 2, [&](const double* x, double* y) {
      const auto word = static_cast<std::size_t>(x[0]);
      y[0] = price[word] * x[1] * x[1];
      y[1] = 16.0 * 500e3 / (pi * std::pow(x[1], 3)) / (0.577 * strength[word]);
    });
    std::vector<double> sizes;
    for (int i = 0; i < 60; ++i) sizes.push_back(10.0 + i);
    const Problem problem{shaft, {stock({0, 1, 2, 3}, false), stock(sizes)}, 0, false, {{1, at_most_one}}};
    const Optimum all = minimise(problem), found = minimise(problem, searching());
    CHECK(found.point == all.point);
    CHECK(std::count_if(found.neighbours.begin(), found.neighbours.end(),
                        [](const Neighbour& next) { return next.variable == 0; }) == 3);
  }

  TEST_CASE("without a feasible point the point with the smallest violation is reported, with its worst constraint") {
    Formula narrow(2, 3, [](const double* x, double* y) {
      y[0] = x[0] + x[1];
      y[1] = 2.0 + (x[0] - 0.25) * (x[0] - 0.25);
      y[2] = 1.5 + (x[1] - 0.5) * (x[1] - 0.5);
    });
    const Problem problem{narrow, {range(0, 1), range(0, 1)}, 0, false, {{1, at_most_one}, {2, at_most_one}}};
    const Optimum found = minimise(problem);
    CHECK_FALSE(found.allowed);
    CHECK(found.worst == 0);
    CHECK(found.point[0] == doctest::Approx(0.25).epsilon(1e-3));
    CHECK(found.point[1] == doctest::Approx(0.5).epsilon(1e-3));
    for (const Neighbour& next : found.neighbours) CHECK(next.outcome == Outcome::breaks);
  }

  TEST_CASE("points that are not available are never feasible, and rank after everything else") {
    Formula holed(1, 2, [](const double* x, double* y) {
      y[0] = x[0] < 2.0 ? none : x[0];
      y[1] = x[0] < 3.0 ? none : 0.5;
    });
    const Problem problem{holed, {range(0, 10)}, 0, false, {{1, at_most_one}}};
    const Optimum found = minimise(problem);
    CHECK(found.allowed);
    CHECK(found.point[0] == doctest::Approx(3.0).epsilon(1e-6));
    CHECK(found.point[0] >= 3.0);
    Formula never(1, 1, [](const double*, double* y) { y[0] = none; });
    CHECK_FALSE(minimise({never, {range(0, 1)}, 0, false, {}}).allowed);
    CHECK_FALSE(minimise({never, {stock({1, 2, 3})}, 0, false, {}}).allowed);
  }

  TEST_CASE("at the end of a range there is no neighbour") {
    Formula line(2, 1, [](const double* x, double* y) { y[0] = x[0] - x[1]; });
    const Optimum found = minimise({line, {range(2, 5), stock({1, 2, 3})}, 0, false, {}});
    CHECK(found.point == std::vector<double>{2, 3});
    REQUIRE(found.neighbours.size() == 3);  // the stock's one with x as it is and resized
    CHECK(found.neighbours[0].point[0] == doctest::Approx(2.003));
    CHECK(found.neighbours[1].point == std::vector<double>{2, 2});
  }

  TEST_CASE("the same question has the same answer to the bit") {
    Formula function(2, 4, strut);
    const Problem problem{function, {stock(diameters), range(1, 12)}, 0, false, {{1, at_most_one}, {2, at_most_one}}};
    const Optimum first = minimise(problem), second = minimise(problem);
    CHECK(first.allowed);
    CHECK(same(first, second));
  }

  TEST_CASE("the budget ends the search, and this is reported") {
    Formula function(2, 4, strut);
    const Problem problem{function, {stock(diameters), range(1, 12)}, 0, false, {{1, at_most_one}, {2, at_most_one}}};
    for (const std::uint64_t budget : {0, 1, 10, 1000}) {
      Effort effort;
      effort.budget = budget;
      const Optimum found = minimise(problem, effort);
      CHECK(found.budget_spent);
      CHECK(found.evaluations <= budget + 1000);
      CHECK(found.evaluations == function.points);
      function.points = 0;
    }
  }

  TEST_CASE("the scale of numbers changes nothing") {
    for (const double unit : {1e-9, 1.0, 1e12}) {
      for (const double size : {1e-12, 1.0, 1e9}) {
        Formula rod(2, 2, [&](const double* x, double* y) {
          const double d = x[0] / unit, l = x[1] / unit;
          y[0] = size * (d * d * (1.0 + l) + 4.0 / l);
          y[1] = 9.0 * l / (d * d * d * d);
        });
        // d^2 = 3 sqrt l; then 3 (l^(1/2) + l^(3/2)) + 4 / l is least where 4.5 l^(5/2) + 1.5 l^(3/2) = 4
        double l = 1.0;
        for (int i = 0; i < 60; ++i)
          l -= (4.5 * std::pow(l, 2.5) + 1.5 * std::pow(l, 1.5) - 4.0) /
               (11.25 * std::pow(l, 1.5) + 2.25 * std::sqrt(l));
        const Optimum found = minimise(
            {rod, {range(0.5 * unit, 4.0 * unit), range(0.1 * unit, 5.0 * unit)}, 0, false, {{1, at_most_one}}});
        CHECK(found.allowed);
        CHECK(found.outputs[0] / size ==
              doctest::Approx(3.0 * (std::sqrt(l) + std::pow(l, 1.5)) + 4.0 / l).epsilon(1e-8));
        CHECK(found.point[1] / unit == doctest::Approx(l).epsilon(1e-4));
      }
    }
  }

  TEST_CASE("variables without a choice, a flat objective and no variable at all") {
    Formula flat(3, 2, [](const double* x, double* y) { y[0] = 4.0, y[1] = x[0] + x[1] - x[2]; });
    const Optimum found = minimise({flat, {range(2, 2), stock({3}), range(0, 9)}, 0, false, {{1, at_most_one}}});
    CHECK(found.allowed);
    CHECK(found.point[0] == 2.0);
    CHECK(found.point[1] == 3.0);
    CHECK(found.point[2] >= 4.0);
    Formula constant(0, 1, [](const double*, double* y) { y[0] = 7.0; });
    const Optimum only = minimise({constant, {}, 0, false, {}});
    CHECK(only.allowed);
    CHECK(only.outputs[0] == 7.0);
    CHECK(only.neighbours.empty());
  }

  TEST_CASE("an error of the function is passed on") {
    Formula angry(2, 1, [](const double* x, double* y) {
      if (x[0] > 0.74 && x[0] < 0.76) throw std::runtime_error("stopped");
      y[0] = (x[0] - 0.75) * (x[0] - 0.75) + x[1];
    });
    CHECK_THROWS_AS((void)minimise({angry, {range(0, 1), range(0, 1)}, 0, false, {}}), std::runtime_error);
  }

  TEST_CASE("the best of random designs is not beaten by brute force") {
    // ten small mixed cases: a quadratic in two integers and one continuous variable, cut by a plane; for each
    // pair the continuous one is closed: its free optimum, or where the plane cuts
    for (int k = 0; k < 10; ++k) {
      const double a = 0.3 + 0.37 * k, b = 5.2 - 0.41 * k, c = 0.9 * std::sin(k), limit = 6.0 + 0.5 * k;
      const auto f = [&](double i, double j, double x) {
        return (i - a) * (i - a) + 0.7 * (j - b) * (j - b) + (x + c - i / 5.0) * (x + c - i / 5.0) + 0.3 * i * j;
      };
      Formula cut(3, 2, [&](const double* x, double* y) {
        y[0] = f(x[0], x[1], x[2]);
        y[1] = limit / (x[0] + x[1] + x[2] + 1e-3);
      });
      double best = 1e300;
      std::vector<double> whole;
      for (int i = 0; i <= 9; ++i) whole.push_back(i);
      for (const double i : whole) {
        for (const double j : whole) {
          const double x = std::max(i / 5.0 - c, limit - 1e-3 - i - j);
          if (x <= 4.0) best = std::min(best, f(i, j, std::max(x, 0.0)));
        }
      }
      const Problem problem{cut, {stock(whole), stock(whole), range(0, 4)}, 0, false, {{1, at_most_one}}};
      const Optimum found = minimise(problem);
      CHECK(found.allowed);
      CHECK(found.outputs[0] == doctest::Approx(best).epsilon(1e-7));
    }
  }
}
