// Designs of the literature whose best points are published.
#include "lib/sweep/search/minimise.hpp"
#include "tests/lib/sweep/formula.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace loadpath::sweep;
using namespace loadpath::sweep::testing;
using std::numbers::pi;
using std::numbers::sqrt2;

namespace {

std::vector<Constraint> at_most_one(std::size_t first, std::size_t count) {
  std::vector<Constraint> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back({first + i, Constraint::Kind::at_most_one});
  return all;
}

Variable range(double from, double to) {
  Variable variable;
  variable.from = from, variable.to = to;
  return variable;
}

Variable stock(std::vector<double> values) {
  Variable variable;
  variable.values = std::move(values);
  return variable;
}

Variable whole(int from, int to, double unit = 1.0) {
  std::vector<double> values;
  for (int i = from; i <= to; ++i) values.push_back(i * unit);
  return stock(values);
}

/// Relative, and none of the neighbours better.
void check_best(const Optimum& found, double published, double within) {
  CHECK(found.allowed);
  CHECK_FALSE(found.budget_spent);
  CHECK(found.outputs[0] == doctest::Approx(published).epsilon(within).scale(0.0));
  for (const Neighbour& neighbour : found.neighbours) CHECK(neighbour.outcome != Neighbour::Outcome::better);
}

}  // namespace

TEST_SUITE("designs of the literature") {
  // Sandgren 1990, in the form of Coello 2000: 6059.7143 at (0.8125, 0.4375, 42.0984, 176.6366). With these plates the
  // best radius and length are closed: R = T_s / 0.0193, L from the volume.
  TEST_CASE("the pressure vessel of two stock plates") {
    Formula vessel(4, 5, [](const double* x, double* y) {
      const double s = x[0], h = x[1], R = x[2], L = x[3];
      y[0] = 0.6224 * s * R * L + 1.7781 * h * R * R + 3.1661 * s * s * L + 19.84 * s * s * R;
      y[1] = 0.0193 * R / s;
      y[2] = 0.00954 * R / h;
      y[3] = 1296000.0 / (pi * R * R * L + 4.0 / 3.0 * pi * R * R * R);
      y[4] = L / 240.0;
    });
    const Problem problem{vessel,
                          {whole(1, 99, 0.0625), whole(1, 99, 0.0625), range(10, 200), range(10, 200)},
                          0,
                          false,
                          at_most_one(1, 4)};
    const Optimum found = minimise(problem);
    const double s = 0.8125, h = 0.4375, R = s / 0.0193, L = (1296000.0 - 4.0 / 3.0 * pi * R * R * R) / (pi * R * R);
    const double closed = 0.6224 * s * R * L + 1.7781 * h * R * R + 3.1661 * s * s * L + 19.84 * s * s * R;
    CHECK(closed == doctest::Approx(6059.714335).epsilon(1e-9));
    check_best(found, closed, 1e-7);
    CHECK(found.point[0] == s);
    CHECK(found.point[1] == h);
  }

  // Sandgren 1990 (its formulas as in the library of GAMS, model 206, with the limits given there): 2.65856. For each
  // wire and number of coils the thinnest coil that the preload allows is the best, so that the best of all is closed.
  TEST_CASE("the coil spring of a wire from a list and an integer number of coils") {
    const std::vector<double> wires{0.207, 0.225, 0.244, 0.263, 0.283, 0.307, 0.331, 0.362, 0.394, 0.4375, 0.5};
    const Formula::Body body = [](const double* x, double* y) {
      const double d = x[0], N = x[1], D = x[2], C = D / d, F = 1000.0, G = 11.5e6;
      const double K = (4.0 * C - 1.0) / (4.0 * C - 4.0) + 0.615 / C, per_force = 8.0 * N * C * C * C / (G * d);
      y[0] = pi * pi * D * d * d * (N + 2.0) / 4.0;
      y[1] = 8.0 * F / pi * K * C / (d * d) / 189e3;
      y[2] = (F * per_force + 1.05 * (N + 2.0) * d) / 14.0;
      y[3] = (D + d) / 3.0;
      y[4] = per_force / (6.0 / 300.0);
      y[5] = 1.25 / 700.0 / per_force;
    };
    Formula spring(3, 6, body);
    double best = 1e300;
    for (const double d : wires) {
      for (double N = 1.0; N <= 40.0; ++N) {
        const double C = std::cbrt(1.25 / 700.0 * 11.5e6 * d / (8.0 * N)), x[] = {d, N, C * d};
        double y[6];
        body(x, y);
        bool allowed = C >= 1.1;
        for (int i = 1; i < 5; ++i) allowed = allowed && y[i] <= 1.0;
        if (allowed) best = std::min(best, y[0]);
      }
    }
    CHECK(best == doctest::Approx(2.65856).epsilon(2e-6));
    const Problem problem{spring, {stock(wires), whole(1, 40), range(0.5, 3.0)}, 0, false, at_most_one(1, 5)};
    check_best(minimise(problem), best, 1e-7);
  }

  // Belegundu 1982, Arora 1989: 0.0126652328 (Coello and others); three continuous variables.
  TEST_CASE("the tension spring") {
    Formula spring(3, 5, [](const double* x, double* y) {
      const double d = x[0], D = x[1], N = x[2];
      y[0] = (N + 2.0) * D * d * d;
      y[1] = 71785.0 * std::pow(d, 4) / (D * D * D * N);
      y[2] = (4.0 * D * D - d * D) / (12566.0 * (D * d * d * d - std::pow(d, 4))) + 1.0 / (5108.0 * d * d);
      y[3] = D * D * N / (140.45 * d);
      y[4] = (d + D) / 1.5;
    });
    const Problem problem{spring, {range(0.05, 2.0), range(0.25, 1.3), range(2.0, 15.0)}, 0, false, at_most_one(1, 4)};
    const Optimum found = minimise(problem);
    check_best(found, 0.012665232788, 1e-7);
    CHECK(found.scope == Optimum::Scope::local);
  }

  // Rao 1996, Coello 2000: 1.724852309 at (0.20573, 3.47049, 9.03662, 0.20573).
  TEST_CASE("the welded beam") {
    Formula beam(4, 8, [](const double* x, double* y) {
      const double h = x[0], l = x[1], t = x[2], b = x[3], P = 6000.0, L = 14.0, E = 30e6, G = 12e6;
      const double M = P * (L + l / 2.0), R = std::sqrt(l * l / 4.0 + (h + t) * (h + t) / 4.0);
      const double J = 2.0 * sqrt2 * h * l * (l * l / 12.0 + (h + t) * (h + t) / 4.0);
      const double t1 = P / (sqrt2 * h * l), t2 = M * R / J;
      const double P_c = 4.013 * E * std::sqrt(t * t * std::pow(b, 6) / 36.0) / (L * L) *
                         (1.0 - t / (2.0 * L) * std::sqrt(E / (4.0 * G)));
      y[0] = 1.10471 * h * h * l + 0.04811 * t * b * (14.0 + l);
      y[1] = std::sqrt(t1 * t1 + 2.0 * t1 * t2 * l / (2.0 * R) + t2 * t2) / 13600.0;
      y[2] = 6.0 * P * L / (b * t * t) / 30000.0;
      y[3] = h / b;
      y[4] = (0.10471 * h * h + 0.04811 * t * b * (14.0 + l)) / 5.0;
      y[5] = 0.125 / h;
      y[6] = 4.0 * P * L * L * L / (E * t * t * t * b) / 0.25;
      y[7] = P / P_c;
    });
    const Problem problem{
        beam, {range(0.1, 2.0), range(0.1, 10.0), range(0.1, 10.0), range(0.1, 2.0)}, 0, false, at_most_one(1, 7)};
    check_best(minimise(problem), 1.724852309, 1e-7);
  }

  // Golinski 1973; 2994.471066 at (3.5, 0.7, 17, 7.3, 7.715320, 3.350215, 5.286654).
  TEST_CASE("the speed reducer with its number of teeth") {
    Formula reducer(7, 12, [](const double* x, double* y) {
      const double b = x[0], m = x[1], z = x[2], l1 = x[3], l2 = x[4], d1 = x[5], d2 = x[6];
      y[0] = 0.7854 * b * m * m * (3.3333 * z * z + 14.9334 * z - 43.0934) - 1.508 * b * (d1 * d1 + d2 * d2) +
             7.4777 * (d1 * d1 * d1 + d2 * d2 * d2) + 0.7854 * (l1 * d1 * d1 + l2 * d2 * d2);
      y[1] = 27.0 / (b * m * m * z);
      y[2] = 397.5 / (b * m * m * z * z);
      y[3] = 1.93 * l1 * l1 * l1 / (m * z * std::pow(d1, 4));
      y[4] = 1.93 * l2 * l2 * l2 / (m * z * std::pow(d2, 4));
      y[5] = std::sqrt(std::pow(745.0 * l1 / (m * z), 2) + 16.9e6) / (110.0 * d1 * d1 * d1);
      y[6] = std::sqrt(std::pow(745.0 * l2 / (m * z), 2) + 157.5e6) / (85.0 * d2 * d2 * d2);
      y[7] = m * z / 40.0;
      y[8] = 5.0 * m / b;
      y[9] = b / (12.0 * m);
      y[10] = (1.5 * d1 + 1.9) / l1;
      y[11] = (1.1 * d2 + 1.9) / l2;
    });
    const Problem problem{reducer,
                          {range(2.6, 3.6), range(0.7, 0.8), whole(17, 28), range(7.3, 8.3), range(7.3, 8.3),
                           range(2.9, 3.9), range(5.0, 5.5)},
                          0,
                          false,
                          at_most_one(1, 11)};
    const Optimum found = minimise(problem);
    check_best(found, 2994.471066, 1e-7);
    CHECK(found.point[2] == 17.0);
    CHECK(found.scope == Optimum::Scope::every_combination);
  }

  // Nowacki 1973: 263.895843; closed by Lagrange: A_1 = (3 + sqrt 3) / 6, A_2 = 1 / sqrt 6.
  TEST_CASE("the truss of three bars") {
    Formula truss(2, 4, [](const double* x, double* y) {
      const double a = x[0], b = x[1], s = sqrt2 * a * a + 2.0 * a * b;
      y[0] = (2.0 * sqrt2 * a + b) * 100.0;
      y[1] = (sqrt2 * a + b) / s;
      y[2] = b / s;
      y[3] = 1.0 / (a + sqrt2 * b);
    });
    const Problem problem{truss, {range(0, 1), range(0, 1)}, 0, false, at_most_one(1, 3)};
    const Optimum found = minimise(problem);
    check_best(found, 263.8958434, 1e-8);
    CHECK(found.point[0] == doctest::Approx((3.0 + std::sqrt(3.0)) / 6.0).epsilon(1e-4));
    CHECK(found.point[1] == doctest::Approx(1.0 / std::sqrt(6.0)).epsilon(1e-4));
    CHECK(100.0 * (2.0 * sqrt2 * (3.0 + std::sqrt(3.0)) / 6.0 + 1.0 / std::sqrt(6.0)) == doctest::Approx(263.8958434));
  }

  // Sandgren 1990: four gears of 12 to 60 teeth for 1 / 6.931; 2.7009e-12 with 16, 19, 43, 49.
  TEST_CASE("the ratio of four gears") {
    Formula gears(4, 1, [](const double* z, double* y) {
      const double miss = 1.0 / 6.931 - z[0] * z[1] / (z[2] * z[3]);
      y[0] = miss * miss;
    });
    const Problem problem{gears, {whole(12, 60), whole(12, 60), whole(12, 60), whole(12, 60)}, 0, false, {}};
    Effort all;
    all.budget = all.enumerated = 6'000'000;
    const Optimum found = minimise(problem, all);
    const double miss = 1.0 / 6.931 - 16.0 * 19.0 / (43.0 * 49.0);
    CHECK(miss * miss == doctest::Approx(2.700857e-12).epsilon(1e-6));
    check_best(found, miss * miss, 1e-9);
    CHECK(found.scope == Optimum::Scope::every_point);
    CHECK(gears.points >= 49 * 49 * 49 * 49);
  }
}
