// Reductions of columns: their results, and that the grouping of the blocks leaves no trace.
#include "lib/sweep/statistics/summary.hpp"

#include "lib/sweep/statistics/covariances.hpp"
#include "lib/sweep/statistics/share.hpp"
#include "tests/lib/sweep/statistics/shards.hpp"

#include <doctest/doctest.h>

#include <numeric>
#include <span>

namespace {

using namespace loadpath::sweep;
using namespace loadpath::sweep::test;

std::span<const double> block_of(const std::vector<double>& values, std::size_t block) {
  const std::size_t first = block * block_size;
  return std::span(values).subspan(first, std::min(block_size, values.size() - first));
}

std::size_t blocks_of(const std::vector<double>& values) { return (values.size() + block_size - 1) / block_size; }

void add_block(Summary& to, const std::vector<double>& values, std::size_t block) {
  CHECK(to.add(block, block * block_size, block_of(values, block)));
}

Summary summary_of(const std::vector<double>& values) {
  Summary all;
  for (std::size_t block = 0; block < blocks_of(values); ++block) add_block(all, values, block);
  return all;
}

std::vector<double> sorted(std::vector<double> values) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double x) { return std::isnan(x); }), values.end());
  std::sort(values.begin(), values.end());
  return values;
}

double quantile_by_sorting(const std::vector<double>& ascending, double p) {
  const double place = p * static_cast<double>(ascending.size() - 1);
  const auto low = static_cast<std::size_t>(place);
  if (low + 1 == ascending.size()) return ascending.back();
  return ascending[low] + (place - static_cast<double>(low)) * (ascending[low + 1] - ascending[low]);
}

/// The mean of a power of what is away from `from`, in extended precision.
long double power_mean(const std::vector<double>& values, long double from, int power) {
  long double sum = 0.0L;
  for (const double x : values) sum += std::pow(x - from, static_cast<long double>(power));
  return sum / static_cast<long double>(values.size());
}

}  // namespace

TEST_SUITE("statistics of sweeps") {
  TEST_CASE("moments are those of their definition") {
    const auto values = column(20'000, 1), there = sorted(values);
    const Summary all = summary_of(values);
    CHECK(all.count() == there.size());
    CHECK(all.missing() == values.size() - there.size());
    const auto n = static_cast<long double>(there.size());
    const long double mean = power_mean(there, 0.0L, 1), m2 = power_mean(there, mean, 2);
    const Moments found = all.moments();
    CHECK(found.mean() == doctest::Approx(static_cast<double>(mean)).epsilon(1e-13));
    CHECK(found.variance() == doctest::Approx(static_cast<double>(m2 * n / (n - 1.0L))).epsilon(1e-13));
    CHECK(found.skewness() ==
          doctest::Approx(static_cast<double>(power_mean(there, mean, 3) / std::pow(m2, 1.5L))).epsilon(1e-12));
    CHECK(found.kurtosis() ==
          doctest::Approx(static_cast<double>(power_mean(there, mean, 4) / (m2 * m2) - 3.0L)).epsilon(1e-12));
  }

  TEST_CASE("moments by hand: 2, 4, 4, 4, 5, 5, 7, 9") {
    const std::vector<double> values{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0};
    const Moments found{std::span(values)};
    CHECK(found.mean() == 5.0);
    CHECK(found.variance() == doctest::Approx(32.0 / 7.0).epsilon(1e-15));
    CHECK(found.skewness() == doctest::Approx(42.0 / 8.0 / 8.0).epsilon(1e-15));          // m3 = 42/8, m2 = 4
    CHECK(found.kurtosis() == doctest::Approx(356.0 / 8.0 / 16.0 - 3.0).epsilon(1e-15));  // m4 = 356/8
  }

  TEST_CASE("moments of a constant are exact, of one value and of none not available") {
    const Summary all = summary_of(std::vector<double>(1000, 0.1));
    CHECK(all.moments().mean() == 0.1);
    CHECK(all.moments().variance() == 0.0);
    CHECK(std::isnan(all.moments().skewness()));
    CHECK(std::isnan(summary_of({3.0}).moments().variance()));
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    const Summary none = summary_of({nan, infinity, -infinity});
    CHECK(none.missing() == 3);
    CHECK(none.count() == 0);
    CHECK(std::isnan(none.moments().mean()));
    CHECK(std::isnan(none.min().value));
    CHECK(std::isnan(none.ranks().quantile(0.5)));
    CHECK(none.ranks().histogram(5).counts.empty());
  }

  TEST_CASE("a large mean does not affect a small scatter") {
    std::vector<double> values;
    for (int i = 0; i < 1001; ++i) values.push_back(1e9 + 0.001 * (i % 7 - 3));
    CHECK(summary_of(values).moments().sd() == doctest::Approx(0.002).epsilon(1e-3));
  }

  TEST_CASE("the extremes come with the first of their points") {
    std::vector<double> values(1000, 1.0);
    values[500] = values[100] = values[777] = 9.0;
    values[300] = values[299] = -2.0;
    const Summary all = summary_of(values);
    CHECK(all.max().value == 9.0);
    CHECK(all.max().index == 100);
    CHECK(all.min().value == -2.0);
    CHECK(all.min().index == 299);
  }

  TEST_CASE("any grouping of blocks and any order of merging give the same bytes") {
    const auto values = column(20'000, 2);
    const std::string whole = bytes_of(summary_of(values));
    for (unsigned seed = 0; seed < 40; ++seed) {
      const auto merged = sharded(
          Summary(), blocks_of(values), seed,
          [&](Summary& shard, std::size_t block) { add_block(shard, values, block); },
          [](Summary& into, const Summary& from) { CHECK(into.merge(from)); });
      CHECK_UNARY(bytes_of(merged) == whole);
    }
  }

  TEST_CASE("blocks in reverse order give the same bytes, and of consecutive ones few parts are kept") {
    const auto values = column(20'000, 3);
    Summary backwards;
    for (std::size_t block = blocks_of(values); block-- > 0;) add_block(backwards, values, block);
    CHECK_UNARY(bytes_of(backwards) == bytes_of(summary_of(values)));
    Forest<Moments> forest;
    for (std::uint64_t block = 1000; block < 1999; ++block) CHECK(forest.add(block, Moments(std::span(values))));
    CHECK(forest.blocks() == 999);
    CHECK(forest.parts() <= 20);
  }

  TEST_CASE("a block that is already there is not added again") {
    const auto values = column(1000, 4);
    Summary all = summary_of(values);
    const std::string before = bytes_of(all);
    CHECK(!all.add(3, 3 * block_size, block_of(values, 3)));
    Summary one;
    add_block(one, values, 5);
    CHECK(!all.merge(one));
    CHECK_UNARY(bytes_of(all) == before);
    add_block(one, values, 6);
    CHECK(!one.merge(all));
  }

  TEST_CASE("stored data are read back to the bit, and truncated data are reported") {
    const Summary all = summary_of(column(5000, 5));
    const std::string bytes = bytes_of(all);
    Summary again;
    Reader reader(bytes);
    again.load(reader);
    CHECK(!reader.failed());
    CHECK(reader.at_end());
    CHECK_UNARY(bytes_of(again) == bytes);
    for (const std::size_t length : {std::size_t{0}, std::size_t{17}, bytes.size() / 2, bytes.size() - 1}) {
      Reader part(std::string_view(bytes).substr(0, length));
      Summary cut;
      cut.load(part);
      CHECK(part.failed());
    }
  }

  TEST_CASE("quantiles are those of sorted values, within a class of 2^-12") {
    for (const std::size_t n : {1UL, 2UL, 100UL, 50'000UL}) {
      const auto values = column(n, 6), ascending = sorted(values);
      const Ranks ranks = summary_of(values).ranks();
      for (const double p : {0.0, 0.001, 0.05, 0.2, 0.25, 0.5, 0.777, 0.95, 0.999, 1.0}) {
        const double exact = quantile_by_sorting(ascending, p);
        CHECK(std::abs(ranks.quantile(p) - exact) <= 0x1p-12 * std::abs(exact));
      }
      CHECK(ranks.quantile(0.0) == ascending.front());
      CHECK(ranks.quantile(1.0) == ascending.back());
    }
  }

  TEST_CASE("quantiles of a few values, and of values of a stock, are exact") {
    const Ranks few = summary_of({10.0, 40.0, -20.0, 0.0, 30.0}).ranks();
    CHECK(few.quantile(0.5) == 10.0);
    CHECK(few.quantile(0.25) == 0.0);
    CHECK(few.quantile(0.875) == 35.0);
    std::vector<double> stock;
    for (int i = 0; i < 10'000; ++i) stock.push_back(i % 10 < 7 ? 0.05 : i % 10 < 9 ? 0.055 : 0.06);
    const Ranks ranks = summary_of(stock).ranks();
    CHECK(ranks.quantile(0.5) == 0.05);
    CHECK(ranks.quantile(0.75) == 0.055);
    CHECK(ranks.quantile(0.95) == 0.06);
    CHECK(ranks.below(0.055) == 7000);
    CHECK(summary_of({-0.0, 0.0, 5e-324}).ranks().quantile(0.5) == 0.0);
  }

  TEST_CASE("shares are bounded by Clopper and Pearson") {
    const Interval half = Share{5, 10, 0}.bounds(0.95), one = Share{1, 10, 0}.bounds(0.95);
    CHECK(half.low == doctest::Approx(0.1871).epsilon(1e-3));  // the tables' values for 5 and for 1 of 10
    CHECK(half.high == doctest::Approx(0.8129).epsilon(1e-3));
    CHECK(one.low == doctest::Approx(0.0025).epsilon(2e-2));
    CHECK(one.high == doctest::Approx(0.4450).epsilon(1e-3));
    const Interval none = Share{0, 10, 0}.bounds(0.95), all = Share{10, 10, 0}.bounds(0.95);
    CHECK(none.low == 0.0);
    CHECK(none.high == doctest::Approx(1.0 - std::pow(0.025, 0.1)).epsilon(1e-12));
    CHECK(all.low == doctest::Approx(std::pow(0.025, 0.1)).epsilon(1e-12));
    CHECK(all.high == 1.0);
    CHECK(Share{}.bounds(0.95).high == 1.0);
    CHECK(std::isnan(Share{}.share()));
  }

  TEST_CASE("the bounds of a median are the ranks of the sign test") {
    // The tables of the median for 95 %: 1 and 6 of 6, 2 and 9 of 10, 6 and 15 of 20; none of 5.
    const auto is = [](std::uint64_t n, std::uint64_t low, std::uint64_t high) {
      const RankBounds found = rank_bounds(n, 0.5, 0.95);
      return found.low == low && found.high == high;
    };
    CHECK(is(5, 0, 6));
    CHECK(is(6, 1, 6));
    CHECK(is(10, 2, 9));
    CHECK(is(20, 6, 15));
    CHECK(std::isnan(summary_of({1.0, 2.0, 3.0}).ranks().quantile_bounds(0.5, 0.95).low));
    const RankBounds many = rank_bounds(1'000'000'000, 0.5, 0.95);  // n/2 -+ 1.96 sqrt(n)/2
    CHECK(static_cast<double>(many.high - many.low) == doctest::Approx(1.959964 * std::sqrt(1e9)).epsilon(1e-4));
  }

  TEST_CASE("a histogram counts every value once") {
    const auto values = column(30'000, 7), ascending = sorted(values);
    const Histogram found = summary_of(values).ranks().histogram(40);
    REQUIRE(found.counts.size() == 40);
    REQUIRE(found.edges.size() == 41);
    CHECK(found.edges.front() == ascending.front());
    CHECK(found.edges.back() == ascending.back());
    CHECK(std::accumulate(found.counts.begin(), found.counts.end(), std::uint64_t{0}) == ascending.size());
    for (std::size_t k = 1; k < 40; ++k) {
      const auto exact = std::lower_bound(ascending.begin(), ascending.end(), found.edges[k]) - ascending.begin();
      const auto until = std::accumulate(found.counts.begin(), found.counts.begin() + static_cast<long>(k), 0L);
      CHECK(std::abs(static_cast<double>(until - exact)) <= 30.0);  // a thousandth
    }
  }

  TEST_CASE("a logarithmic histogram has equal ratios, and is of values above zero") {
    const Ranks ranks = summary_of({1.0, 2.0, 5.0, 20.0, 50.0, 200.0, 1000.0}).ranks();
    const Histogram found = ranks.logarithmic_histogram(3);
    CHECK(found.edges[1] == doctest::Approx(10.0));
    CHECK(found.counts == std::vector<std::uint64_t>{3, 2, 2});
    CHECK(summary_of({-1.0, 2.0}).ranks().logarithmic_histogram(3).counts.empty());
    CHECK(summary_of({4.0, 4.0}).ranks().histogram(2).counts == std::vector<std::uint64_t>{0, 2});
  }

  TEST_CASE("covariances are those of their definition, for complete points") {
    auto a = column(5000, 8), b = column(5000, 9);
    for (std::size_t i = 0; i < a.size(); ++i) b[i] += 0.5 * a[i];
    const double* const columns[] = {a.data(), b.data()};
    const Covariances whole(columns, a.size());
    std::vector<double> x, y;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (std::isnan(b[i])) continue;  // a is in it
      x.push_back(a[i]);
      y.push_back(b[i]);
    }
    const long double mx = power_mean(x, 0.0L, 1), my = power_mean(y, 0.0L, 1);
    long double xy = 0.0L;
    for (std::size_t i = 0; i < x.size(); ++i) xy += (x[i] - mx) * (y[i] - my);
    const auto n = static_cast<long double>(x.size());
    CHECK(whole.count() == x.size());
    CHECK(whole.covariance(0, 1) == doctest::Approx(static_cast<double>(xy / (n - 1.0L))).epsilon(1e-12));
    const double correlation =
        static_cast<double>(xy / n / std::sqrt(power_mean(x, mx, 2)) / std::sqrt(power_mean(y, my, 2)));
    CHECK(whole.correlation(0, 1) == doctest::Approx(correlation).epsilon(1e-12));
    CHECK(whole.correlation(1, 0) == whole.correlation(0, 1));
    CHECK(whole.correlation(1, 1) == doctest::Approx(1.0).epsilon(1e-15));
  }

  TEST_CASE("covariances of blocks in any grouping have the same bytes") {
    const auto a = column(5000, 10), b = column(5000, 11);
    const std::size_t blocks = blocks_of(a);
    const auto feed = [&](Forest<Covariances>& shard, std::size_t block) {
      const auto x = block_of(a, block), y = block_of(b, block);
      const double* const columns[] = {x.data(), y.data()};
      CHECK(shard.add(block, Covariances(columns, x.size())));
    };
    const auto merge = [](Forest<Covariances>& into, const Forest<Covariances>& from) { CHECK(into.merge(from)); };
    const auto first = sharded(Forest<Covariances>(), blocks, 0, feed, merge);
    for (unsigned seed = 1; seed < 10; ++seed)
      CHECK_UNARY(bytes_of(sharded(Forest<Covariances>(), blocks, seed, feed, merge)) == bytes_of(first));
    const double* const columns[] = {a.data(), b.data()};
    CHECK(first.total().covariance(0, 1) == doctest::Approx(Covariances(columns, a.size()).covariance(0, 1)));
    const std::string bytes = bytes_of(first);
    Reader reader(bytes), cut(std::string_view(bytes).substr(0, 100));
    Forest<Covariances> again, part;
    again.load(reader);
    part.load(cut);
    CHECK_UNARY(bytes_of(again) == bytes);
    CHECK(cut.failed());
    const double constant[] = {2.0, 2.0}, varied[] = {1.0, 3.0};
    const double* const two[] = {constant, varied};
    CHECK(std::isnan(Covariances(two, 2).correlation(0, 1)));
  }
}
