#include "lib/rainflow/counter.hpp"
#include "tests/lib/rainflow/naive.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <numbers>

using namespace loadpath::rainflow;
using namespace loadpath::rainflow::testing;

namespace {

constexpr Method methods[] = {Method::four_point, Method::hcm, Method::astm};

Rules rules_of(Method method, Residue residue) {
  Rules rules;
  rules.method = method, rules.residue = residue;
  return rules;
}

/// Counts without their means.
std::map<double, double> by_range(const Counts& counts) {
  std::map<double, double> ranges;
  for (const auto& [cycle, count] : counts) ranges[cycle.first] += count;
  return ranges;
}

}  // namespace

TEST_SUITE("rainflow counting") {
  // ASTM E1049-85(2017), figure 6: the table of 5.4.4 and the text before it.
  TEST_CASE("the example of ASTM E1049 is counted as it is printed") {
    const Series series{-2, 1, -3, 5, -1, 3, -4, 4, -2};
    const std::map<double, double> printed{{3, 0.5}, {4, 1.5}, {6, 0.5}, {8, 1.0}, {9, 0.5}};
    CHECK(by_range(counted(series, rules_of(Method::astm, Residue::astm))) == printed);
    CHECK(by_range(counted(series, rules_of(Method::four_point, Residue::half_cycles))) == printed);
    CHECK(by_range(counted(series, rules_of(Method::four_point, Residue::astm))) == printed);
    const Counts with_means = counted(series, rules_of(Method::astm, Residue::astm));
    CHECK(with_means.at({4, 1}) == 1.0);  // E-F, -1 to 3, the only full one
    CHECK(with_means.at({4, -1}) == 0.5);
    CHECK(with_means.at({9, 0.5}) == 0.5);
  }

  TEST_CASE("the example of ASTM E1049, repeated, has full cycles only") {
    // 5.4.5 with figure 7, as recalled: from D round to D: E-F 4, A-B 3, H-C 7, D-G 9.
    const Series period{-2, 1, -3, 5, -1, 3, -4, 4};
    const std::map<double, double> printed{{3, 1}, {4, 1}, {7, 1}, {9, 1}};
    for (const Method method : methods) CHECK(by_range(counted_periodic(period, rules_of(method, {}))) == printed);
    CHECK(by_range(counted(period, rules_of(Method::four_point, Residue::repeated))) == printed);
  }

  // Wikipedia, Rainflow-counting algorithm, as quoted in Gunnstein/fatpack issue 21.
  TEST_CASE("the table of sixteen reversals of Wikipedia") {
    const Series series{2, -14, 10, 0, 13, -9, 11, -8, 8, -9, 15, -4, 10, 0, 13, 0};
    const std::map<double, double> printed{{10, 2},   {13, 0.5}, {16, 1.5}, {17, 0.5},
                                           {19, 0.5}, {20, 1},   {22, 1},   {29, 0.5}};
    CHECK(by_range(counted(series, rules_of(Method::astm, Residue::astm))) == printed);
    CHECK(by_range(counted(series)) == printed);
  }

  // ISO 12110-2:2013, the example that the tests of Gunnstein/fatpack hold: reversals, cycles, residue, cycles of the
  // residue repeated once.
  TEST_CASE("the example of ISO 12110-2 with its residue and what closes when it repeats") {
    const Series reversals{4, 7, 2, 10, 5, 9, 3, 4, 2, 12, 5, 11, 1, 4, 3, 10, 6, 12, 4, 8, 1, 9, 4, 6};
    const Counts closed{{{4, 7}, 1}, {{1, 3.5}, 2}, {{8, 6}, 1}, {{6, 8}, 1}, {{4, 8}, 1}, {{4, 6}, 1}, {{11, 6.5}, 1}};
    const Rules ignore = rules_of(Method::four_point, Residue::ignore);
    CHECK(counted(reversals, ignore) == closed);
    Counts repeated = closed;
    for (const auto& [range, mean] : {std::pair{2.0, 5.0}, {3.0, 5.5}, {7.0, 5.5}, {11.0, 6.5}})
      repeated[{range, mean}] += 1;
    CHECK(counted(reversals, rules_of(Method::four_point, Residue::repeated)) == repeated);

    Tally tally;
    Counter counter(ignore, tally);
    REQUIRE(!counter.feed(reversals));
    counter.finish();
    const auto residue = counter.residue().values;
    CHECK(Series(residue.begin(), residue.end()) == Series{4, 7, 2, 12, 1, 9, 4, 6});
  }

  TEST_CASE("the same cycles as by removing the smallest range again and again") {
    for (const int steps : {0, 3, 10}) {
      for (unsigned seed = 1; seed <= 30; ++seed) {
        const Series series = noise(20 + 13 * seed, seed, steps);
        const Counts naive = naive_with_halves(series);
        CHECK(counted(series) == naive);
        CHECK(counted(series, rules_of(Method::four_point, Residue::astm)) == naive);
        CHECK(counted(series, rules_of(Method::astm, Residue::half_cycles)) == naive);
        CHECK(counted(series, rules_of(Method::astm, Residue::astm)) == naive);
      }
    }
  }

  TEST_CASE("a period has the cycles that four periods have more than three") {
    for (const int steps : {0, 4}) {
      for (unsigned seed = 1; seed <= 40; ++seed) {
        const Series period = noise(2 + seed, seed, steps);
        const Counts naive = naive_periodic(period);
        for (const Method method : methods) CHECK(counted_periodic(period, rules_of(method, {})) == naive);
        CHECK(counted(period, rules_of(Method::four_point, Residue::repeated)) == naive);
      }
    }
  }

  TEST_CASE("removal in blocks leaves every method its cycles") {
    for (const int steps : {0, 2, 6, 50}) {
      const Series series = noise(60000, 7, steps);
      for (const Method method : methods) {
        Rules rules = rules_of(method, Residue::half_cycles);
        const Counts in_blocks = counted(series, rules);
        rules.blocks = false;
        CHECK(counted(series, rules) == in_blocks);
        rules.placed = true;
        CHECK(counted(series, rules) == in_blocks);
      }
    }
  }

  TEST_CASE("HCM closes what the four-point method closes once the largest value has passed") {
    const Series series = noise(2000, 3);
    const auto largest =
        std::max_element(series.begin(), series.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    const Series behind(largest, series.end());
    const Rules four = rules_of(Method::four_point, Residue::ignore), hcm = rules_of(Method::hcm, Residue::ignore);
    Counts same = counted(behind, hcm);
    CHECK(same == counted(behind, four));
    // Clormann and Seeger: the way from zero is half a loop. 0, 10, 0, 10 closes with HCM, and is open with four
    // points.
    CHECK(counted(Series{0, 10, 0, 10}, hcm) == Counts{{{10, 5}, 1}});
    CHECK(counted(Series{5, 10, 0, 10}, hcm) == Counts{{{10, 5}, 1}});
    // From zero on there is no half of a loop before the first peak.
    CHECK(counted(Series{0, 10, 0}, rules_of(Method::hcm, Residue::half_cycles)) == Counts{{{10, 5}, 0.5}});
    CHECK(counted(Series{5, -10, 4, -7, 3}, hcm) == Counts{});
    CHECK(counted(Series{5, -10, 4, -7, 5}, hcm) == Counts{{{11, -1.5}, 1}});
  }

  TEST_CASE("a sine of 100 MPa is n cycles of range 200 by every method") {
    constexpr int n = 50, steps = 40;
    Series sine;
    for (int i = 0; i < n * steps; ++i) sine.push_back(100.0 * std::sin(2.0 * std::numbers::pi * (i % steps) / steps));
    for (const Method method : methods) {
      const Counts periodic = counted_periodic(sine, rules_of(method, {}));
      REQUIRE(periodic.size() == 1);
      CHECK(periodic.begin()->first.first == 200.0);
      CHECK(periodic.begin()->first.second == 0.0);
      CHECK(periodic.begin()->second == n);
    }
    // From zero to zero, not as a period: the quarter before the first peak and behind the last valley is a half cycle
    // of range 100 each, which HCM has only behind; and the last peak to the last valley is another half.
    const Counts open = counted(sine, rules_of(Method::astm, Residue::astm));
    CHECK(open.at({200.0, 0.0}) == n - 0.5);
    CHECK(counted(sine) == open);
    CHECK(counted(sine, rules_of(Method::hcm, Residue::half_cycles)).at({200.0, 0.0}) == n - 0.5);
  }

  TEST_CASE("short and constant series have no cycles") {
    for (const Method method : methods) {
      const Rules rules = rules_of(method, Residue::half_cycles);
      for (const Series& series : {Series{}, Series{7}, Series(1000, 7.0)}) {
        CHECK(counted(series, rules).empty());
        CHECK(counted_periodic(series, rules).empty());
      }
      CHECK(counted_periodic(Series{3, 7}, rules) == Counts{{{4, 5}, 1}});
    }
    CHECK(counted(Series{3, 7}) == Counts{{{4, 5}, 0.5}});
    CHECK(counted(Series{3, 7}, rules_of(Method::four_point, Residue::ignore)).empty());
    CHECK(counted(Series{3, 3, 7, 7, 7}) == Counts{{{4, 5}, 0.5}});
    CHECK(counted(Series{0, 1, 0, 1, 0}) == Counts{{{1, 0.5}, 2}});
  }

  TEST_CASE("tiny and huge values are counted exactly") {
    CHECK(counted(Series{0, 2e-300, 1e-300, 3e-300}, rules_of(Method::four_point, Residue::ignore)).size() == 1);
    const Counts huge = counted(Series{-8e307, 8e307, -8e307, 8e307, -8e307});
    CHECK(huge == Counts{{{1.6e308, 0.0}, 2}});
  }

  TEST_CASE("a sample that is not a number is refused with its place") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf, 1e308}) {
      for (const std::size_t at : {0U, 1U, 2U, 63U, 64U, 65U, 5000U, 9998U, 9999U}) {
        for (const auto& [instructions, held] : {std::pair{Instructions::portable, false},
                                                 {Instructions::portable, true},
                                                 {best_instructions(), false},
                                                 {best_instructions(), true}}) {
          Series series = waves(10000);
          if (held) {
            for (std::size_t i = 1; i < series.size(); i += 2) series[i] = series[i - 1];
          }
          series[at] = bad;
          Rules rules;
          rules.instructions = instructions;
          Tally tally;
          Counter counter(rules, tally);
          const auto fault = counter.feed(series);
          REQUIRE(fault);
          CHECK(fault->at == at);
          CHECK(fault->message.text().find("sample " + std::to_string(at)) == 0);
          const auto periodic = count_periodic(series, rules, tally);
          REQUIRE(periodic);
          CHECK(periodic->at == at);
        }
      }
    }
  }

  TEST_CASE("rules that contradict one another are reported") {
    CHECK(!contradiction({}));
    CHECK(contradiction(rules_of(Method::astm, Residue::repeated)));
    CHECK(contradiction(rules_of(Method::hcm, Residue::repeated)));
    Rules rules;
    rules.gate = -1.0;
    CHECK(contradiction(rules));
    rules.gate = std::numeric_limits<double>::quiet_NaN();
    CHECK(contradiction(rules)->message.text() == "the gate must be a range, 0 or more");
  }
}
