#include "lib/rainflow/spectrum.hpp"

#include "tests/lib/rainflow/naive.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

using namespace loadpath::rainflow;
using namespace loadpath::rainflow::testing;

namespace {

const Series iso{4, 7, 2, 10, 5, 9, 3, 4, 2, 12, 5, 11, 1, 4, 3, 10, 6, 12, 4, 8, 1, 9, 4, 6};

void count(const Series& series, Residue residue, Consumer& consumer, double gate = 0.0) {
  Rules rules;
  rules.residue = residue, rules.gate = gate;
  Counter counter(rules, consumer);
  REQUIRE(!counter.feed(series));
  counter.finish();
}

}  // namespace

TEST_SUITE("rainflow spectrum") {
  // ISO 12110-2:2013, the example of the tests of Gunnstein/fatpack: the matrix from start to destination.
  TEST_CASE("the rainflow matrix of the example of ISO 12110-2") {
    RainflowMatrix matrix(*Classes::make(0.5, 1.0, 12));
    count(iso, Residue::ignore, matrix);
    const std::vector<std::pair<int, int>> printed{{5, 9}, {3, 4}, {10, 2}, {5, 11}, {4, 3}, {10, 6}, {4, 8}, {1, 12}};
    double sum = 0.0;
    for (std::size_t from = 0; from < 12; ++from) {
      for (std::size_t to = 0; to < 12; ++to) sum += matrix.count(from, to);
    }
    CHECK(sum == 8.0);
    CHECK(matrix.outside() == 0.0);
    for (const auto& [from, to] : printed)
      CHECK(matrix.count(static_cast<std::size_t>(from - 1), static_cast<std::size_t>(to - 1)) == 1.0);
  }

  // The same tests: ranges of the cycles and of the repeated residue, in classes 1 to 12.
  TEST_CASE("the range pairs of the example of ISO 12110-2") {
    RangePairs pairs(*Classes::make(0.5, 1.0, 12));
    count(iso, Residue::repeated, pairs);
    const std::vector<double> printed{2, 1, 1, 3, 0, 1, 1, 1, 0, 0, 2, 0};
    CHECK(std::vector<double>(pairs.counts().begin(), pairs.counts().end()) == printed);
    CHECK(pairs.exceedances() == std::vector<double>{12, 10, 9, 8, 5, 5, 4, 3, 2, 2, 2, 0});
    CHECK(pairs.levels(Measure::amplitude).back().stress == 11.5 / 2.0);
    CHECK(pairs.levels(Measure::range).back().count == 2.0);
  }

  // The series of the tests of Gunnstein/fatpack, with what its race track of width 2 leaves.
  TEST_CASE("a gate leaves the turning points of a race track of its width") {
    const Series series{4.2, 7.3,  2.0, 9.8, 9.6, 10.3, 5.2, 8.5,  3.0, 4.4, 2.2, 2.4, 2.2, 12.0,
                        5.5, 11.1, 1.0, 4.3, 3.5, 9.5,  6.0, 12.0, 3.9, 8.3, 1.2, 8.6, 3.9, 6.2};
    const Series printed{4.2, 7.3, 2.,  10.3, 5.2, 8.5, 2.2, 12., 5.5, 11.1,
                         1.,  9.5, 6.0, 12.,  3.9, 8.3, 1.2, 8.6, 3.9, 6.2};
    struct Kept : Consumer {
      Series points;
      void take(const Batch& /*batch*/) override {}
      void pass(std::span<const double> more) override { points.insert(points.end(), more.begin(), more.end()); }
    } kept;
    count(series, Residue::ignore, kept, 2.0);
    CHECK(kept.points == printed);
  }

  TEST_CASE("a gate removes the cycles that are smaller and no others") {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const Series series = noise(3000, seed, seed % 2 == 0 ? 0 : 40);
      for (const double gate : {1.0, 10.0, 60.0}) {
        Tally all, gated;
        count(series, Residue::ignore, all);
        count(series, Residue::ignore, gated, gate);
        std::erase_if(all.counts, [&](const auto& cycle) { return cycle.first.first < gate; });
        CHECK(gated.counts == all.counts);
      }
    }
    Rules rules;
    rules.gate = 2.0;
    CHECK(counted(Series{0, 1, 0, 1}, rules).empty());
    CHECK(counted(Series{0, 2, 0, 2}, rules).size() == 1);  // as large as the gate
  }

  TEST_CASE("a gate on a period removes the smaller of its cycles") {
    for (unsigned seed = 1; seed <= 30; ++seed) {
      const Series period = noise(3 + seed, seed, seed % 2 == 0 ? 0 : 20);
      Counts naive = naive_periodic(period);
      std::erase_if(naive, [](const auto& cycle) { return cycle.first.first < 12.0; });
      for (const Method method : {Method::four_point, Method::hcm, Method::astm}) {
        Rules rules;
        rules.method = method, rules.gate = 12.0;
        CHECK(counted_periodic(period, rules) == naive);
      }
    }
  }

  TEST_CASE("levels are crossed as often up as down, and by what reaches them") {
    LevelCrossings crossings({5.0, 0.0, -5.0, std::numeric_limits<double>::quiet_NaN(), 100.0, 3.0});
    count(Series{-1, 3, 1, 6, -6, 5, -1}, Residue::ignore, crossings);
    const auto found = crossings.crossings();
    REQUIRE(found.size() == 5);
    const std::array<double, 5> levels{-5, 0, 3, 5, 100};
    // Up: -1 to 3, 1 to 6, -6 to 5. Down: 3 to 1, 6 to -6, 5 to -1.
    const std::array<std::uint64_t, 5> up{1, 2, 3, 2, 0}, down{1, 2, 3, 2, 0};
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK(found[i].level == levels[i]);
      CHECK(found[i].up == up[i]);
      CHECK(found[i].down == down[i]);
    }
  }

  TEST_CASE("crossings are those of the series, one sample after the other") {
    const Series series = noise(40000, 11, 20);
    std::vector<double> levels;
    for (int i = -25; i <= 25; ++i) levels.push_back(i);
    LevelCrossings crossings(levels);
    count(series, Residue::ignore, crossings);
    for (const auto& [level, up, down] : crossings.crossings()) {
      std::uint64_t rises = 0, falls = 0;
      for (std::size_t i = 1; i < series.size(); ++i) {
        rises += static_cast<std::uint64_t>(series[i - 1] < level && series[i] >= level);
        falls += static_cast<std::uint64_t>(series[i - 1] >= level && series[i] < level);
      }
      CHECK(up == rises);
      CHECK(down == falls);
    }
  }

  TEST_CASE("a class includes its lower bound, and the last one both") {
    for (const double low : {0.0, -0.7, 1.1, 123.4}) {
      for (const double width : {0.1, 0.3, 1.0 / 3.0, 7.7}) {
        const Classes some = *Classes::make(low, width, 900);
        for (std::size_t i = 0; i < 900; ++i) {
          CHECK(some.of(some.bound(i)) == i);
          if (i > 0) CHECK(some.of(std::nextafter(some.bound(i), -1e9)) == i - 1);
        }
      }
    }
    const Classes classes = *Classes::make(0.0, 0.1, 10);
    CHECK(classes.of(classes.bound(10)) == 9U);
    CHECK(!classes.of(-1e-300));
    CHECK(!classes.of(std::nextafter(classes.bound(10), 2.0)));
    CHECK(!Classes().of(0.0));
    RangePairs pairs(classes);
    count(Series{0, 5, 0, 0.05, 0}, Residue::half_cycles, pairs);
    CHECK(pairs.outside() == 1.0);
    CHECK(pairs.counts()[0] == 1.0);
  }

  TEST_CASE("classes without a width or a number are refused") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(!Classes::make(0.0, 0.0, 10));
    CHECK(!Classes::make(0.0, nan, 10));
    CHECK(!Classes::make(nan, 1.0, 10));
    CHECK(!Classes::make(0.0, 1e308, 10));
    CHECK(!Classes::make(1e20, 1.0, 10));
    CHECK(!Classes::make(0.0, 1.0, 0));
    CHECK(Classes::make(0.0, 1.0, 1025).fault().message.text() == "there must be 1 to 1024 classes");
  }
}
