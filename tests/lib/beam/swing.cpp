// Natural frequencies in torsion, against closed forms, a published chain of discs, and Holzer's walk by small steps.
#include "lib/beam/swing.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace {

using doctest::Approx;
using loadpath::beam::Disc;
using loadpath::beam::rigid;
using loadpath::beam::Rod;
using loadpath::beam::Swing;
using std::numbers::pi;

/// The residual at the right end for a rotation of 1 at the left: a rod is cut into `parts` springs with masses.
double left_over(const Swing::Rods& rods, const Swing::Discs& discs, double omega, int parts) {
  double turned = 1.0, moment = 0.0;
  const auto pass_discs = [&](std::size_t node) {
    for (const Disc& disc : discs) {
      const double own = omega * omega * disc.J;
      if (disc.node == node) moment += (disc.k < rigid ? own / (1.0 - own / disc.k) : own) * turned;
    }
  };
  for (std::size_t r = 0; r < rods.size(); ++r) {
    pass_discs(r);
    const double half = rods[r].l / parts / 2.0;
    for (int part = 0; part < parts; ++part) {
      moment += omega * omega * rods[r].j * half * turned;
      turned -= moment * 2.0 * half / rods[r].GI;
      moment += omega * omega * rods[r].j * half * turned;
    }
  }
  pass_discs(rods.size());
  return moment;
}

Swing two_discs(double J_1, double J_2, double k) { return Swing({{1.0, k, 0.0}}, {{0, J_1}, {1, J_2}}); }

}  // namespace

TEST_SUITE("swing") {
  TEST_CASE("two discs on a spring: sqrt(k (1/J_1 + 1/J_2)), and there are no other frequencies") {
    const Swing swing = two_discs(2.0, 3.0, 600.0);
    CHECK(swing.natural(0) == 0.0);
    CHECK(swing.natural(1) == Approx(std::sqrt(500.0)).epsilon(1e-12));
    CHECK(std::isnan(swing.natural(2)));
    CHECK(two_discs(1e12, 3.0, 600.0).natural(1) == Approx(std::sqrt(200.0)).epsilon(1e-9));  // an end that is held
  }

  // Thomson, Theory of Vibration with Applications, Holzer's method: 123.666 and 202.658 rad/s.
  TEST_CASE("Thomson's three discs") {
    const Swing swing({{1.0, 0.1e6, 0.0}, {1.0, 0.2e6, 0.0}}, {{0, 5.0}, {1, 11.0}, {2, 22.0}});
    CHECK(swing.natural(1) == Approx(123.666).epsilon(5e-6));
    CHECK(swing.natural(2) == Approx(202.658).epsilon(5e-6));
    CHECK(swing.below(123.0) == 1);
    CHECK(swing.below(124.0) == 2);
    CHECK(swing.below(203.0) == 3);
  }

  TEST_CASE("a bar without discs: i pi c/l, however it is divided; with one end fixed its odd halves") {
    const double l = 1.3, GI = 8e4, j = 0.02, c = std::sqrt(GI / j);
    for (const std::size_t cuts : {std::size_t{1}, std::size_t{2}, std::size_t{7}}) {
      const Swing::Rods rods(cuts, Rod{l / static_cast<double>(cuts), GI, j});
      for (std::size_t i = 1; i < 9; ++i) {
        const auto number = static_cast<double>(i);
        CHECK(Swing(rods, {}).natural(i) == Approx(number * pi * c / l).epsilon(1e-9));
        CHECK(Swing(rods, {{0, 1e12}}).natural(i) == Approx((number - 0.5) * pi * c / l).epsilon(1e-9));
        CHECK(Swing(rods, {}).below(number * pi * c / l * (1.0 - 1e-6)) == i);
        CHECK(Swing(rods, {}).below(number * pi * c / l * (1.0 + 1e-6)) == i + 1);
      }
    }
  }

  TEST_CASE("a fixed bar with a disc on its end: b tan b = J of the bar over J of the disc") {
    const double l = 1.0, GI = 1e4, j = 0.01, J = 0.025;
    const double omega = Swing({{l, GI, j}}, {{0, 1e12}, {1, J}}).natural(1);
    const double b = omega * l * std::sqrt(j / GI);
    CHECK(b * std::tan(b) == Approx(j * l / J).epsilon(1e-9));
  }

  TEST_CASE("behind a soft coupling a disc vibrates nearly by itself, and a stiff coupling is a rigid one") {
    const Swing::Rods rods{{0.5, 1e6, 0.001}};
    CHECK(Swing(rods, {{0, 1.0}, {1, 2.0, 10.0}}).natural(1) == Approx(std::sqrt(10.0 * 1.5)).epsilon(1e-3));
    CHECK(Swing(rods, {{0, 1.0}, {1, 2.0, 1e15}}).natural(1) ==
          Approx(Swing(rods, {{0, 1.0}, {1, 2.0}}).natural(1)).epsilon(1e-8));
  }

  TEST_CASE("random shafts, no frequency missed: Holzer's method in small steps changes its sign at each") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int k = 0; k < 20; ++k) {
      Swing::Rods rods;
      Swing::Discs discs;
      for (std::size_t r = 0; r < 4; ++r)
        rods.push_back({0.1 + part(random), 1e4 * (0.1 + part(random)), 0.01 * part(random)});
      for (std::size_t d = 0; d < 3; ++d) discs.push_back({d + 1, 0.1 * part(random)});
      const Swing swing(rods, discs);
      const double reach = 0.5 * (swing.natural(3) + swing.natural(4));
      std::vector<double> walked;
      double before = left_over(rods, discs, 1e-3 * reach, 400);
      constexpr int steps = 1000;
      for (int s = 2; s <= steps; ++s) {
        const double here = left_over(rods, discs, reach * s / steps, 400);
        if (before * here < 0.0) walked.push_back(reach * (s - 0.5) / steps);
        before = here;
      }
      REQUIRE(walked.size() == 3);
      for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(walked[i] - swing.natural(i + 1)) < 2.0 * reach / steps);
    }
  }
}
