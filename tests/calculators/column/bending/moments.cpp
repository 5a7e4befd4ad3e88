#include "calculators/column/bending/moments.hpp"

#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <random>

namespace {

using namespace loadpath;
using namespace loadpath::column;
using test::rel;

Moments of(double M_1, double M_2, double q = 0.0, double F = 0.0) {
  return {from_si<Moment>(M_1), from_si<Moment>(M_2), from_si<Stiffness>(q), from_si<Force>(F), from_si<Length>(2.0)};
}

}  // namespace

TEST_SUITE("moments of a bar") {
  TEST_CASE("the largest moment and shear are those of a fine grid") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int i = 0; i < 200; ++i) {
      const Moments m = of(any(random), any(random), 4.0 * any(random), 2.0 * any(random));
      constexpr int steps = 4000;
      double moment = 0.0, shear = 0.0;
      for (int k = 0; k <= steps; ++k) {
        const double x = static_cast<double>(k) / steps;
        moment = std::max(moment, std::abs(in_si(m.at(x))));
        if (k < steps) shear = std::max(shear, std::abs(in_si(m.at(x + 1.0 / steps) - m.at(x))) * steps / 2.0);
      }
      CHECK(rel(in_si(m.largest()), moment) < 1e-5);
      CHECK(rel(in_si(m.shear()), shear) < 2e-3);
    }
  }

  TEST_CASE("table B.3 of EN 1993-1-1") {
    CHECK(uniform_moment_factor(of(1, 1)) == 1.0);
    CHECK(uniform_moment_factor(of(1, 0)) == 0.6);
    CHECK(uniform_moment_factor(of(0, -2)) == 0.6);
    CHECK(uniform_moment_factor(of(1, -1)) == 0.4);
    CHECK(uniform_moment_factor(of(0, 0, 1)) == 0.95);
    CHECK(uniform_moment_factor(of(0, 0, 0, 1)) == 0.90);
    // built in at both ends: M_h = -q l^2/12, M_s = q l^2/24, alpha_s = -1/2: 0.1 + 0.4
    CHECK(rel(uniform_moment_factor(of(-1.0 / 3, -1.0 / 3, 1)), 0.5) < 1e-12);
    // a force between built-in ends: M_h = -F l/8 = -M_s, alpha_s = -1: 0.8
    CHECK(rel(uniform_moment_factor(of(-0.25, -0.25, 0, 1)), 0.8) < 1e-12);
    // hinged at one end, built in at the other: M_h = -q l^2/8, M_s = q l^2/16: 0.1 (1 - 0) + 0.4
    CHECK(rel(uniform_moment_factor(of(0, -0.5, 1)), 0.5) < 1e-12);
  }

  TEST_CASE("AISC 360 (F1-1)") {
    CHECK(rel(moment_gradient_factor(of(1, 1)), 1.0) < 1e-12);
    CHECK(rel(moment_gradient_factor(of(0, 0, 1)), 1.1364) < 1e-4);     // printed as 1.14
    CHECK(rel(moment_gradient_factor(of(0, 0, 0, 1)), 1.3158) < 1e-4);  // printed as 1.32
    CHECK(rel(moment_gradient_factor(of(1, 0)), 1.6667) < 1e-4);        // printed as 1.67
    CHECK(rel(moment_gradient_factor(of(1, -1)), 2.2727) < 1e-4);       // printed as 2.27
  }
}
