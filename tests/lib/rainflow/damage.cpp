#include "lib/rainflow/damage.hpp"

#include "tests/lib/rainflow/naive.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

using namespace loadpath::rainflow;
using namespace loadpath::rainflow::testing;

namespace {

using Branch = SnCurve::Branch;

/// To a part of the value itself: damages are small.
doctest::Approx near(double value, double within = 1e-12) { return doctest::Approx(value).epsilon(within).scale(0.0); }

SnCurve curve_of(Measure measure, SnCurve::Point point, const std::vector<Branch>& branches) {
  const auto curve = SnCurve::make(measure, point, branches);
  REQUIRE(curve);
  return *curve;
}

/// k = 5, a limit of 100 at a million cycles.
SnCurve basquin() { return curve_of(Measure::amplitude, {100.0, 1e6}, {{5.0, 1e6}}); }

double damage_of(const SnCurve& curve, const std::vector<Loop>& loops, double count = 1.0) {
  DamageSum sum(curve);
  sum.take({loops, count, {}});
  REQUIRE(sum.total());
  return *sum.total();
}

/// The consistent rule by its words, block by block in small steps: the limit is moved after each.
double collectives_borne(const std::vector<Level>& levels, double k, double limit, double life) {
  constexpr int steps = 200000;
  double borne = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double damage = (i + 0.5) / steps, actual = limit * std::pow(1.0 - damage, 1.0 / (k - 1.0));
    double rate = 0.0;
    for (const Level& level : levels) {
      if (level.stress >= actual) rate += level.count * std::pow(level.stress / limit, k) / life;
    }
    borne += 1.0 / steps / rate;
  }
  return borne;
}

}  // namespace

TEST_SUITE("rainflow damage") {
  // EN 1993-1-9:2005, 7.1: the category at 2e6 cycles, m = 3 to 5e6, m = 5 to 1e8; limits 0.737 and 0.405 of it.
  TEST_CASE("a detail category of EN 1993-1-9") {
    const SnCurve curve = curve_of(Measure::range, {71.0, 2e6}, {{3.0, 5e6}, {5.0, 1e8}});
    CHECK(curve.segments()[0].from / 71.0 == near(0.737, 0.0005 / 0.737));
    CHECK(curve.segments()[1].from / 71.0 == near(0.405, 0.0005 / 0.405));
    CHECK(*curve.cycles(71.0) == near(2e6));
    CHECK(*curve.cycles(142.0) == near(2.5e5));
    CHECK(!curve.cycles(0.404 * 71.0));
    CHECK(curve.damage(0.404 * 71.0) == 0.0);
    CHECK(*curve.stress(2e6) == near(71.0));
    CHECK(*curve.stress(5e7) == near(71.0 * std::cbrt(0.4) * std::pow(0.1, 0.2)));
    CHECK(!curve.stress(1.01e8));
  }

  TEST_CASE("both branches give the same life at their knee") {
    for (const auto& branches :
         {std::vector<Branch>{{3.0, 5e6}, {5.0, 1e8}, {7.3}}, {{4.0, 1e5}, {9.0, 1e7}, {1.0, 1e9}}}) {
      const SnCurve curve = curve_of(Measure::range, {71.0, 2e4}, branches);
      for (std::size_t i = 0; i + 1 < branches.size(); ++i) {
        const double knee = curve.segments()[i].from;
        CHECK(curve.damage(knee) == near(1.0 / branches[i].until, 1e-14));
        CHECK(curve.damage(std::nextafter(knee, 0.0)) == near(1.0 / branches[i].until, 1e-13));
        const double above = damage_of(curve, {{0.0, knee}}),
                     below = damage_of(curve, {{0.0, std::nextafter(knee, 0.0)}});
        CHECK(above == near(below, 1e-13));
        CHECK(*curve.stress(branches[i].until) == near(knee, 1e-14));
      }
    }
  }

  TEST_CASE("life and stress are inverses, and one over life is damage") {
    const SnCurve curve = curve_of(Measure::amplitude, {100.0, 1e6}, {{5.0, 1e6}, {9.0, 1e8}, {15.5}});
    for (double stress = 20.0; stress < 900.0; stress *= 1.1) {
      const double life = *curve.cycles(stress);
      CHECK(*curve.stress(life) == near(stress, 1e-12));
      CHECK(curve.damage(stress) * life == near(1.0, 1e-12));
      CHECK(damage_of(curve, {{stress, -stress}}) * life == near(1.0, 1e-11));
    }
  }

  TEST_CASE("powers by products and by logarithms are those of the C library") {
    for (const double slope : {1.0, 2.0, 3.0, 5.0, 6.0, 9.0, 1.25, 4.7, 12.25, 33.3, 64.0}) {
      const SnCurve curve = curve_of(Measure::range, {1.0, 1.0}, {{slope}});
      for (double stress = 1e-4; stress < 1e4; stress *= 1.37)
        CHECK(damage_of(curve, {{0.0, stress}}) ==
              near(std::pow(stress, slope), 1e-15 + 3e-16 * slope * (1.0 + std::abs(std::log2(stress)))));
    }
  }

  TEST_CASE("a sine of 100 MPa has the life of its closed form by every method") {
    constexpr int n = 30, steps = 36;
    Series sine;
    for (int i = 0; i < n * steps; ++i) sine.push_back(100.0 * std::sin(2.0 * std::numbers::pi * i / steps));
    const SnCurve amplitudes = curve_of(Measure::amplitude, {160.0, 1e6}, {{5.0}});
    const SnCurve ranges = curve_of(Measure::range, {320.0, 1e6}, {{5.0}});
    const double closed_form = n / (1e6 * std::pow(1.6, 5.0));
    for (const Method method : {Method::four_point, Method::hcm, Method::astm}) {
      Rules rules;
      rules.method = method;
      DamageSum by_amplitude(amplitudes), by_range(ranges);
      Consumers both({&by_amplitude, &by_range});
      REQUIRE(!count_periodic(sine, rules, both));
      CHECK(by_amplitude.cycles() == n);
      CHECK(*by_amplitude.total() == near(closed_form, 1e-13));
      CHECK(*by_range.total() == near(closed_form, 1e-13));
      CHECK(by_amplitude.largest_stress() == near(100.0));
      CHECK(by_range.largest_stress() == near(200.0));
    }
  }

  TEST_CASE("half cycles do half the damage, and cycles of three branches add up") {
    const SnCurve curve = curve_of(Measure::amplitude, {100.0, 1e6}, {{5.0, 1e6}, {9.0, 1e8}});
    CHECK(damage_of(curve, {{200.0, -200.0}}) == near(32e-6));
    CHECK(damage_of(curve, {{200.0, -200.0}}, 0.5) == near(16e-6));
    std::vector<Loop> loops;
    double sum = 0.0;
    for (int i = 1; i <= 1000; ++i) {
      loops.push_back({0.5 * i, 0.0});
      sum += curve.damage(0.25 * i);
    }
    CHECK(damage_of(curve, loops) == near(sum, 1e-12));
  }

  TEST_CASE("Miner's rules below the limit") {
    const SnCurve curve = basquin();
    const double largest = 200.0;
    const SnCurve elementary = *by_miner(curve, Miner::elementary, largest),
                  modified = *by_miner(curve, Miner::modified, largest);
    const SnCurve original = *by_miner(curve, Miner::original, largest),
                  liu_zenner = *by_miner(curve, Miner::liu_zenner, largest);
    CHECK(original.damage(99.0) == 0.0);
    CHECK(original.damage(100.0) == near(1e-6));
    CHECK(damage_of(original, {{100.0, -100.0}}) == near(1e-6));
    CHECK(damage_of(original, {{100.0, -99.99}}) == 0.0);
    CHECK(elementary.damage(50.0) == near(1e-6 / 32.0));
    CHECK(modified.damage(50.0) == near(1e-6 / 512.0));  // 2 k - 1 = 9
    // Slope (5 + 3.6) / 2 from the life of 200, 1e6 / 2^5, down to half of the limit.
    CHECK(liu_zenner.damage(200.0) == near(32e-6));
    CHECK(liu_zenner.damage(100.0) == near(32e-6 / std::pow(2.0, 4.3)));
    CHECK(liu_zenner.damage(50.001) > 0.0);
    CHECK(liu_zenner.damage(49.999) == 0.0);
    CHECK(by_miner(curve, Miner::liu_zenner, 99.0)->damage(99.0) == 0.0);
    for (double stress = 1.0; stress < 300.0; stress += 1.0) {
      CHECK(elementary.damage(stress) >= modified.damage(stress) * (1.0 - 1e-12));
      CHECK(modified.damage(stress) >= original.damage(stress) * (1.0 - 1e-12));
    }
  }

  TEST_CASE("the consistent rule lowers the limit as damage grows") {
    const std::vector<Level> levels{{60.0, 5e4}, {150.0, 10.0}, {20.0, 1e6}, {95.0, 1e3}, {120.0, 200.0}, {0.0, 7.0}};
    const double damage = *consistent_damage(basquin(), levels);
    CHECK(1.0 / damage == near(collectives_borne(levels, 5.0, 100.0, 1e6), 1e-4));
    double original = 0.0, elementary = 0.0;
    for (const Level& level : levels) {
      original += level.count * basquin().damage(level.stress);
      elementary += level.count * by_miner(basquin(), Miner::elementary, 0.0)->damage(level.stress);
    }
    CHECK(damage > original);
    CHECK(damage < elementary);
    CHECK(*consistent_damage(basquin(), {{99.0, 1e9}}) == 0.0);
    CHECK(*consistent_damage(basquin(), {{200.0, 3.0}}) == near(96e-6));
    CHECK(*consistent_damage(basquin(), {}) == 0.0);
  }

  TEST_CASE("rules are for a curve that leaves open what is below its limit") {
    const SnCurve two = curve_of(Measure::range, {71.0, 2e6}, {{3.0, 5e6}, {5.0, 1e8}});
    const SnCurve endless = curve_of(Measure::range, {71.0, 2e6}, {{3.0}});
    for (const SnCurve& curve : {two, endless, SnCurve()}) {
      for (const Miner rule : {Miner::original, Miner::elementary, Miner::modified, Miner::liu_zenner})
        CHECK(!by_miner(curve, rule, 100.0));
      CHECK(!consistent_damage(curve, {{100.0, 1.0}}));
    }
  }

  TEST_CASE("the damage-equivalent range") {
    // (sum of n S^m / N)^(1/m): (10 * 50^4 + 1000 * 20^4) / 2e6, fourth root.
    const SnCurve wohler = curve_of(Measure::range, {1.0, 1.0}, {{4.0}});
    std::vector<Loop> loops(10, Loop{-20.0, 30.0});
    loops.insert(loops.end(), 1000, Loop{20.0, 0.0});
    const double damage = damage_of(wohler, loops);
    CHECK(*equivalent_stress(wohler, damage, 2e6) == near(std::sqrt(std::sqrt((6.25e7 + 1.6e8) / 2e6))));
    CHECK(*equivalent_stress(wohler, damage_of(wohler, {{0.0, 7.0}}), 1.0) == near(7.0));
    CHECK(!equivalent_stress(wohler, 0.0, 1e6));
    CHECK(!equivalent_stress(wohler, 1.0, 0.0));
  }

  TEST_CASE("the cycles with the most damage are reported with their time") {
    const Series series{0, 10, 5, 300, -100, 250, 240, 260, 0, 10, 0};
    Rules rules;
    rules.placed = true;
    LargestShares shares(basquin(), 2);
    Counter counter(rules, shares);
    REQUIRE(!counter.feed(series));
    counter.finish();
    REQUIRE(shares.shares().size() == 2);
    const auto& [first, damage] = shares.shares()[0];
    CHECK(first.range == 400.0);
    CHECK(first.mean == 100.0);
    CHECK(first.count == 0.5);
    CHECK(first.where == Where{3, 4});
    CHECK(damage == near(16e-6));
    CHECK(shares.shares()[1].cycle.where == Where{4, 7});
    const std::array<Loop, 3> same{Loop{0.0, 300.0}, {10.0, 310.0}, {20.0, 320.0}};
    LargestShares first_ones(basquin(), 2);
    first_ones.take({same, 1.0, {}});
    CHECK(first_ones.shares()[0].cycle.mean == 150.0);
    CHECK(first_ones.shares()[1].cycle.mean == 160.0);
  }

  TEST_CASE("numbers that do not make a curve are refused") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const auto refused = [](SnCurve::Point point, const std::vector<Branch>& branches) {
      return !SnCurve::make(Measure::range, point, branches);
    };
    for (const double bad : {nan, inf, 0.0, -1.0}) {
      CHECK(refused({bad, 1e6}, {{5.0}}));
      CHECK(refused({100.0, bad}, {{5.0}}));
      CHECK(refused({100.0, 1e6}, {{bad}}));
    }
    CHECK(refused({100.0, 1e6}, {}));
    CHECK(refused({100.0, 1e6}, {{0.5}}));
    CHECK(refused({100.0, 1e6}, {{5.0}, {9.0}}));
    CHECK(refused({100.0, 1e6}, {{5.0, nan}, {9.0}}));
    CHECK(refused({100.0, 1e6}, {{5.0, 1e6}, {9.0, 1e6}}));
    const std::vector<Branch> falling{{3.0, 5e6}, {5.0, 1e6}};
    CHECK(SnCurve::make(Measure::range, {71.0, 2e6}, falling).fault().message.text() ==
          "branch 2 must end at more cycles than what is before it");
  }

  TEST_CASE("a result beyond the range of numbers is not available") {
    DamageSum sum(curve_of(Measure::range, {1.0, 1.0}, {{64.0}}));
    const Loop huge{-8e307, 8e307};
    sum.take({{&huge, 1}, 1.0, {}});
    CHECK(sum.total().fault().message.text() == "the damage exceeds the range of numbers");
    const SnCurve curve = curve_of(Measure::range, {1.0, 1.0}, {{64.0}});
    CHECK(std::isfinite(curve.damage(1e300)));
    CHECK(!curve.cycles(1e-300));
    CHECK(!curve.cycles(0.0));
    CHECK(!curve.stress(nan("")));
    CHECK(*DamageSum(basquin()).total() == 0.0);
  }
}
