// The designs of a sweep against a count over all of its points, for every way to share the points out.
#include "lib/project/sweep/designs.hpp"

#include "lib/account/fold.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace loadpath;
using account::State;
using project::DesignRow;
using project::Designs;
using project::DesignsRequest;
using project::SolvedBlock;

constexpr double refused = account::refused_state;

/// All points: one result, state and utilisation of the project, then of one mode.
struct Points {
  std::vector<double> result, state, utilisation;
};

Points drawn(std::uint64_t designs, std::uint64_t samples, unsigned seed) {
  std::mt19937 draw(seed);
  std::normal_distribution<double> scatter(0.0, 0.1);
  Points all;
  for (std::uint64_t design = 0; design < designs; ++design) {
    for (std::uint64_t i = 0; i < samples; ++i) {
      const double u = 0.6 + 0.05 * static_cast<double>(design % 13) + scatter(draw);
      const bool is_refused = design % 7 == 6 || (design % 5 == 4 && i % 9 == 0);
      all.result.push_back(is_refused ? NAN : static_cast<double>(design % 11));
      all.utilisation.push_back(is_refused ? NAN : u);
      all.state.push_back(is_refused ? refused : account::number(u > 1.0 ? State::fail : State::pass));
    }
  }
  return all;
}

SolvedBlock block_of(const Points& all, std::size_t first, std::size_t n) {
  const auto part = [&](const std::vector<double>& column) {
    const auto from = column.begin() + static_cast<std::ptrdiff_t>(first);
    return std::vector<double>(from, from + static_cast<std::ptrdiff_t>(n));
  };
  SolvedBlock block;
  block.first = first;
  block.count = n;
  block.results = {part(all.result), part(all.state), part(all.utilisation), part(all.state), part(all.utilisation)};
  return block;
}

DesignsRequest asked(std::uint64_t samples, std::size_t most = 1000) {
  return {.samples = samples, .results = 1, .modes = 1, .quantile = 0.9, .most = most};
}

/// In blocks of 256 points.
Designs of(const Points& all, std::uint64_t samples, std::size_t most = 1000) {
  Designs designs(asked(samples, most));
  for (std::size_t first = 0; first < all.state.size(); first += 256)
    designs.add(block_of(all, first, std::min<std::size_t>(256, all.state.size() - first)));
  return designs;
}

double quantile_of(std::vector<double> values, double p) {
  std::erase_if(values, [](double v) { return std::isnan(v); });
  std::sort(values.begin(), values.end());
  const double place = p * static_cast<double>(values.size() - 1);
  const auto rank = static_cast<std::size_t>(place);
  const double next = values[std::min(rank + 1, values.size() - 1)];
  return values[rank] + (place - static_cast<double>(rank)) * (next - values[rank]);
}

void check_row(const DesignRow& row, const Points& all, std::uint64_t samples) {
  const std::size_t first = row.design * samples;
  std::uint64_t passing = 0, failing = 0;
  std::vector<double> used;
  for (std::size_t i = first; i < first + samples; ++i) {
    passing += all.state[i] == account::number(State::pass) ? 1U : 0U;
    failing += all.state[i] == account::number(State::fail) || all.state[i] == refused ? 1U : 0U;
    used.push_back(all.utilisation[i]);
  }
  CHECK(row.tally.samples == samples);
  CHECK(row.tally.passing == passing);
  CHECK(row.tally.failing == failing);
  CHECK(row.median == doctest::Approx(quantile_of(used, 0.5)).epsilon(1e-12));
  CHECK(row.quantile == doctest::Approx(quantile_of(used, 0.9)).epsilon(1e-12));
  CHECK(row.tally.worst.value == doctest::Approx(quantile_of(used, 1.0)).epsilon(1e-15));
}

std::string bytes_of(const Designs& designs) {
  sweep::Writer writer;
  designs.store(writer);
  return writer.bytes();
}

}  // namespace

TEST_SUITE("designs of sweeps") {
  TEST_CASE("each design as a count over its samples, within blocks and across them") {
    for (const std::uint64_t samples : {2U, 10U, 200U, 256U, 300U, 1000U}) {
      CAPTURE(samples);
      const Points all = drawn(40, samples, 7);
      const Designs designs = of(all, samples);
      const auto rows = designs.rows();
      CHECK(rows.size() == designs.counts().valid());
      CHECK(designs.counts().invalid == 5);  // every seventh
      for (const DesignRow& row : rows) check_row(row, all, samples);
      const auto fails = [](const DesignRow& row) { return row.tally.failing; };
      CHECK(
          std::is_sorted(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return fails(a) < fails(b); }));
    }
  }

  TEST_CASE("the first rows are those that always pass, by the first result") {
    const auto rows = of(drawn(60, 50, 3), 50).rows();
    for (std::size_t i = 1; i < rows.size() && rows[i].tally.failing == 0; ++i)
      CHECK(rows[i - 1].results[0] <= rows[i].results[0]);
  }

  TEST_CASE("split and merged in any order, stored and resumed: the same bytes") {
    const std::uint64_t samples = 300;
    const Points all = drawn(30, samples, 11);
    const std::string whole = bytes_of(of(all, samples));
    std::vector<Designs> parts;
    for (std::size_t first = 0; first < all.state.size(); first += 512) {
      Designs part(asked(samples));
      for (std::size_t at = first; at < std::min(first + 512, all.state.size()); at += 256)
        part.add(block_of(all, at, std::min<std::size_t>(256, all.state.size() - at)));
      parts.push_back(std::move(part));
    }
    std::shuffle(parts.begin(), parts.end(), std::mt19937(5));
    Designs merged(asked(samples));
    for (const Designs& part : parts) {
      merged.merge(part);
      const std::string bytes = bytes_of(merged);
      sweep::Reader reader(bytes);
      Designs again(asked(samples));
      again.load(reader);
      CHECK(reader.at_end());
      CHECK_FALSE(reader.failed());
      merged = again;
    }
    CHECK(bytes_of(merged) == whole);
  }

  TEST_CASE("without samples the first rows are those of all points") {
    Points all = drawn(4000, 1, 9);
    for (std::size_t i = 0; i < all.result.size(); ++i) all.result[i] = std::sin(static_cast<double>(i));
    std::vector<std::size_t> passing;
    for (std::size_t i = 0; i < all.state.size(); ++i) {
      if (all.state[i] == account::number(State::pass)) passing.push_back(i);
    }
    std::sort(passing.begin(), passing.end(), [&](auto a, auto b) { return all.result[a] < all.result[b]; });
    const auto rows = of(all, 1).rows();
    REQUIRE(rows.size() == 12);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      CHECK(rows[i].design == passing[i]);
      CHECK(rows[i].results[0] == all.result[passing[i]]);
      CHECK(rows[i].quantile == all.utilisation[passing[i]]);
    }
  }

  TEST_CASE("only the best rows are kept, and all are counted") {
    const Points all = drawn(500, 20, 2);
    const auto every = of(all, 20).rows();
    const Designs few = of(all, 20, 17);
    const auto rows = few.rows();
    REQUIRE(rows.size() == 17);
    for (std::size_t i = 0; i < rows.size(); ++i) CHECK(rows[i].design == every[i].design);
    CHECK(few.counts().valid() == every.size());
  }

  TEST_CASE("the Pareto set is of quantiles, not of lucky samples") {
    DesignsRequest two = asked(100);
    two.columns = {0};
    two.aims = {sweep::Aim::max};
    Designs designs(two);
    Points all = drawn(6, 100, 1);
    for (std::size_t i = 0; i < all.result.size(); ++i) all.result[i] = i < 100 ? (i == 50 ? 99.0 : 1.0) : 2.0;
    for (std::size_t first = 0; first < all.state.size(); first += 256)
      designs.add(block_of(all, first, std::min<std::size_t>(256, all.state.size() - first)));
    REQUIRE(designs.pareto().size() == 1);
    CHECK(designs.pareto()[0].index != 0);  // one sample of 99 among ones
    CHECK(designs.pareto()[0].values[0] == 2.0);
  }
}
