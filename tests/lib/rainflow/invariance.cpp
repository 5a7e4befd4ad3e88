#include "lib/rainflow/counter.hpp"
#include "lib/rainflow/damage.hpp"
#include "lib/rainflow/elimination.hpp"
#include "tests/lib/rainflow/naive.hpp"

#include <doctest/doctest.h>

#include <array>

using namespace loadpath::rainflow;
using namespace loadpath::rainflow::testing;

namespace {

/// Everything that is handed on, in its order.
struct Heard : Consumer {
  std::vector<Loop> loops;
  std::vector<double> counts, points;
  std::vector<Where> where;
  void take(const Batch& batch) override {
    loops.insert(loops.end(), batch.loops.begin(), batch.loops.end());
    counts.insert(counts.end(), batch.loops.size(), batch.count);
    where.insert(where.end(), batch.where.begin(), batch.where.end());
  }
  void pass(std::span<const double> turning_points) override {
    points.insert(points.end(), turning_points.begin(), turning_points.end());
  }
  friend bool operator==(const Heard& a, const Heard& b) {
    return a.loops == b.loops && a.counts == b.counts && a.points == b.points && a.where == b.where;
  }
};

Heard heard(const Series& series, const Rules& rules, const std::vector<std::size_t>& cuts) {
  Heard all;
  Counter counter(rules, all);
  std::size_t from = 0;
  for (const std::size_t to : cuts) {
    REQUIRE(!counter.feed(std::span(series).subspan(from, to - from)));
    from = to;
  }
  REQUIRE(!counter.feed(std::span(series).subspan(from)));
  counter.finish();
  return all;
}

double damage(const Series& series, Instructions instructions, double slope, std::size_t chunk) {
  const std::array<SnCurve::Branch, 2> branches{{{slope, 1e3}, {2.0 * slope - 1.0}}};
  DamageSum sum(*SnCurve::make(Measure::amplitude, {90.0, 10.0}, branches), instructions);
  Rules rules;
  rules.instructions = instructions;
  Counter counter(rules, sum);
  for (std::size_t i = 0; i < series.size(); i += chunk)
    REQUIRE(!counter.feed(std::span(series).subspan(i, std::min(chunk, series.size() - i))));
  counter.finish();
  return *sum.total();
}

/// Kinds of series that the comparisons of whole words meet: smooth, rough, level here and there, level all over.
std::vector<Series> kinds(std::size_t count) {
  Series holding = waves(count, 0.3);
  for (std::size_t i = 1; i < count; ++i) {
    if (i % 137 < 9) holding[i] = holding[i - 1];
  }
  Series steps = noise(count, 12, 5);  // plateaus of whole words and more
  for (std::size_t i = 0; i < count; ++i) steps[i] = steps[i - i % (count < 1000 ? 70 : 201)];
  return {waves(count), waves(count, 0.02), noise(count, 5), holding, noise(count, 6, 1), noise(count, 8, 4), steps};
}

}  // namespace

TEST_SUITE("rainflow invariance") {
  TEST_CASE("a series that is split in two anywhere gives the same cycles in the same order") {
    for (const Series& series : kinds(300)) {
      for (const bool placed : {false, true}) {
        for (const double gate : {0.0, 20.0}) {
          Rules rules;
          rules.placed = placed, rules.gate = gate, rules.residue = Residue::repeated;
          const Heard whole = heard(series, rules, {});
          for (std::size_t cut = 0; cut <= series.size(); ++cut) CHECK(heard(series, rules, {cut}) == whole);
        }
      }
    }
  }

  TEST_CASE("sample by sample and in odd pieces it gives the same") {
    for (const Series& series : kinds(30000)) {
      const Rules rules;
      const Heard whole = heard(series, rules, {});
      for (const std::size_t step : {1U, 63U, 64U, 65U, 4097U}) {
        std::vector<std::size_t> cuts;
        for (std::size_t at = step; at < series.size(); at += step) cuts.push_back(at);
        CHECK(heard(series, rules, cuts) == whole);
      }
    }
  }

  TEST_CASE("wide registers find the same as one comparison after the other") {
    for (const Series& series : kinds(50000)) {
      Rules rules;
      const Heard best = heard(series, rules, {});
      rules.instructions = Instructions::portable;
      CHECK(heard(series, rules, {}) == best);
    }
  }

  TEST_CASE("damage is the same to the bit, with wide registers and in any chunks") {
    for (const Series& series : kinds(50000)) {
      for (const double slope : {3.0, 5.0, 4.7, 12.25}) {
        const double whole = damage(series, best_instructions(), slope, series.size());
        CHECK(whole > 0.0);
        CHECK(damage(series, Instructions::portable, slope, series.size()) == whole);
        CHECK(damage(series, best_instructions(), slope, 777) == whole);
      }
    }
  }

  TEST_CASE("turning points are those of the definition, with their places") {
    for (const Series& series : kinds(40000)) {
      Rules rules;
      rules.placed = true;
      const Heard all = heard(series, rules, {});
      CHECK(all.points == naive_turning_points(series));
      for (std::size_t i = 0; i < all.loops.size(); ++i) {
        const auto [begin, end] = all.where[i];
        REQUIRE(Loop{series[begin], series[end]} == all.loops[i]);
        const bool are_first = (begin == 0 || series[begin - 1] != series[begin]) && series[end - 1] != series[end];
        REQUIRE(are_first);  // of their plateaus
      }
    }
  }

  TEST_CASE("positions of a period are those before it was rotated to its maximum") {
    const Series period{0, 2, 2, -1, 9, 9, 4, 6, -3};
    CycleList list;
    Rules rules;
    rules.placed = true;
    REQUIRE(!count_periodic(period, rules, list));
    REQUIRE(list.cycles().size() == 3);
    for (const Cycle& cycle : list.cycles()) {
      CHECK(std::abs(period[cycle.where.begin] - period[cycle.where.end]) == cycle.range);
      CHECK((period[cycle.where.begin] + period[cycle.where.end]) / 2.0 == cycle.mean);
    }
    CHECK(list.cycles()[0].where == Where{6, 7});
    CHECK(list.cycles()[1].where == Where{1, 3});
    CHECK(list.cycles()[2].where == Where{8, 4});  // over the end of the period
  }

  TEST_CASE("removal at once removes what closes and keeps the rest in order") {
    for (std::size_t count = 3; count < 400; ++count) {
      const Series points = naive_turning_points(noise(count, static_cast<unsigned>(count), count % 2 == 0 ? 0 : 9));
      Series room = points;
      room.resize(points.size() + 130);
      Elimination elimination(points.size(), best_instructions());
      const std::size_t left = elimination.reduce(room.data(), points.size());
      Counts before, after;
      const Series residue = naive_closed(points, before);
      room.resize(left);
      CHECK(naive_closed(room, after) == residue);
      for (const Loop& loop : elimination.closed()) note(after, loop.from, loop.to, 1.0);
      CHECK(before == after);
    }
  }
}
