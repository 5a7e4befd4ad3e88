// The worst points and the Pareto set next to brute force.
#include "lib/sweep/statistics/pareto.hpp"
#include "lib/sweep/statistics/worst.hpp"
#include "tests/lib/sweep/statistics/shards.hpp"

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <map>
#include <span>

namespace {

using namespace loadpath::sweep;
using namespace loadpath::sweep::test;

using Columns = std::vector<std::vector<double>>;

/// Small integers, so that many are equal.
Columns whole_numbers(std::size_t columns, std::size_t n, int most, unsigned seed) {
  std::mt19937 random(seed);
  Columns found(columns, std::vector<double>(n));
  for (auto& column : found) {
    for (double& x : column) x = static_cast<int>(random() % static_cast<unsigned>(2 * most)) - most;
  }
  return found;
}

std::vector<double> row_of(const Columns& columns, std::size_t i) {
  std::vector<double> row;
  for (const auto& column : columns) row.push_back(column[i]);
  return row;
}

void add_block(Pareto& to, const Columns& objectives, std::size_t block) {
  const std::size_t first = block * block_size, n = std::min(block_size, objectives[0].size() - first);
  std::vector<const double*> columns;
  for (const auto& column : objectives) columns.push_back(column.data() + first);
  to.add(first, columns, n, [&](std::size_t i) { return row_of(objectives, first + i); });
}

Pareto pareto_of(const Columns& objectives, const std::vector<Aim>& aims, unsigned bits = 52) {
  Pareto all(aims, bits);
  for (std::size_t block = 0; block * block_size < objectives[0].size(); ++block) add_block(all, objectives, block);
  return all;
}

/// Points with what is equal to them, the first of each, that nothing beats; by comparing each two.
std::map<std::uint64_t, std::uint64_t> by_brute_force(const Columns& objectives, const std::vector<Aim>& aims) {
  const std::size_t n = objectives[0].size();
  std::map<std::uint64_t, std::uint64_t> found;
  for (std::size_t i = 0; i < n; ++i) {
    bool stays = true;
    std::uint64_t equals = 0;
    for (std::size_t j = 0; j < n; ++j) {
      bool as_good = true, better = false;
      for (std::size_t k = 0; k < aims.size(); ++k) {
        const double sign = aims[k] == Aim::min ? 1.0 : -1.0, a = sign * objectives[k][j], b = sign * objectives[k][i];
        as_good = as_good && a <= b;
        better = better || a < b;
      }
      equals += as_good && !better ? 1 : 0;
      stays = stays && !(as_good && (better || j < i));
    }
    if (stays) found[i] = equals;
  }
  return found;
}

}  // namespace

TEST_SUITE("statistics of sweeps: selections") {
  TEST_CASE("the Pareto set is that of brute force, for one to four objectives") {
    const std::vector<Aim> all_aims{Aim::min, Aim::max, Aim::min, Aim::max};
    for (std::size_t d = 1; d <= 4; ++d) {
      for (const int most : {4, 1000}) {
        const std::vector<Aim> aims(all_aims.begin(), all_aims.begin() + static_cast<long>(d));
        const Columns objectives = whole_numbers(d, 500, most, static_cast<unsigned>(d));
        std::map<std::uint64_t, std::uint64_t> found;
        for (const auto& point : pareto_of(objectives, aims).points()) {
          found[point.index] = point.equals;
          CHECK(point.objectives == row_of(objectives, point.index));
          CHECK(point.values == point.objectives);
        }
        CHECK(found == by_brute_force(objectives, aims));
      }
    }
  }

  TEST_CASE("the Pareto set does not depend on which block found which of its points") {
    for (const unsigned bits : {52U, 4U, 0U}) {
      const std::vector<Aim> aims{Aim::min, Aim::max, Aim::min};
      Columns objectives{column(3000, 1), column(3000, 2), column(3000, 3)};
      const Columns ties = whole_numbers(3, 3000, 6, 4);
      for (const Columns& of : {objectives, ties}) {
        const std::string whole = bytes_of(pareto_of(of, aims, bits));
        for (unsigned seed = 0; seed < 20; ++seed) {
          const auto merged = sharded(
              Pareto(aims, bits), (3000 + block_size - 1) / block_size, seed,
              [&](Pareto& shard, std::size_t block) { add_block(shard, of, block); },
              [](Pareto& into, const Pareto& from) { into.merge(from); });
          CHECK_UNARY(bytes_of(merged) == whole);
        }
        Reader reader(whole), cut(std::string_view(whole).substr(0, whole.size() - 8));
        Pareto again, part;
        again.load(reader);
        part.load(cut);
        CHECK_UNARY(bytes_of(again) == whole);
        CHECK(cut.failed());
      }
    }
  }

  TEST_CASE("where all objectives contradict each other, classes bound the Pareto set") {
    constexpr std::size_t n = 100'000;
    Columns objectives(2);
    for (std::size_t i = 0; i < n; ++i) {
      objectives[0].push_back(1.0 + static_cast<double>(i) / n);
      objectives[1].push_back(1.0 / objectives[0].back());
    }
    const Pareto coarse = pareto_of(objectives, {Aim::min, Aim::min}, 8);
    CHECK(coarse.size() <= 256);
    CHECK(coarse.size() > 100);
    CHECK(coarse.points().front().objectives[0] < 1.0 + 0x1p-8);
    for (const auto& point : coarse.points()) CHECK(point.equals >= 1);
    CHECK(pareto_of({{1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}}, {Aim::min, Aim::max}).points().front().equals == 3);
  }

  TEST_CASE("points without an objective are skipped") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    const Pareto found = pareto_of({{nan, 1.0, -infinity}, {0.0, 5.0, 0.0}}, {Aim::min, Aim::min});
    REQUIRE(found.size() == 1);
    CHECK(found.points()[0].index == 1);
  }

  TEST_CASE("the worst points are those of sorting, whichever block finds them") {
    const auto values = column(5000, 5), ties = whole_numbers(1, 5000, 20, 6)[0];
    for (const auto& keys : {values, ties}) {
      std::vector<std::pair<double, std::uint64_t>> order;  // the largest key first, then the smallest index
      for (std::size_t i = 0; i < keys.size(); ++i) {
        if (!std::isnan(keys[i])) order.emplace_back(-keys[i], i);
      }
      std::sort(order.begin(), order.end());
      const auto feed = [&](Worst& shard, std::size_t block) {
        const std::size_t first = block * block_size, n = std::min(block_size, keys.size() - first);
        shard.add(first, std::span(keys).subspan(first, n), [&](std::size_t i) {
          return std::vector<double>{keys[first + i], 7.0};
        });
      };
      for (unsigned seed = 0; seed < 20; ++seed) {
        const auto found = sharded(Worst(25), (5000 + block_size - 1) / block_size, seed, feed,
                                   [](Worst& into, const Worst& from) { into.merge(from); });
        const auto rows = found.rows();
        REQUIRE(rows.size() == 25);
        for (std::size_t k = 0; k < rows.size(); ++k) {
          CHECK(rows[k].index == order[k].second);
          CHECK(rows[k].key == -order[k].first);
          CHECK(rows[k].values == std::vector<double>{rows[k].key, 7.0});
        }
        const std::string bytes = bytes_of(found);
        Reader reader(bytes), cut(std::string_view(bytes).substr(0, 40));
        Worst again, part;
        again.load(reader);
        part.load(cut);
        CHECK_UNARY(bytes_of(again) == bytes);
        CHECK(cut.failed());
      }
    }
  }

  TEST_CASE("no worst points are kept where none are requested, and all where there are fewer") {
    Worst none(0), all(9);
    const std::vector<double> keys{3.0, 1.0};
    const auto nothing = [](std::size_t) { return std::vector<double>{}; };
    none.add(0, keys, nothing);
    all.add(0, keys, nothing);
    CHECK(none.rows().empty());
    CHECK(all.rows().size() == 2);
  }
}
