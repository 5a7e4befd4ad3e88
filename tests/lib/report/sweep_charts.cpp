// The figures of a sweep: which points they have, that these are those of the sweep, and that they stay small.
#include "lib/figure/chart.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/report/sweep/charts.hpp"
#include "lib/report/sweep/sweep.hpp"
#include "tests/lib/project/sweep/swept.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <set>

using namespace loadpath;
using test::Swept;

namespace {

const std::string shaft = "[shaft]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\n";
const std::string grid = shaft +
                         "d = { from = \"30 mm\", to = \"60 mm\", count = 13 }\nT = [\"200 N*m\", \"100 N*m\", "
                         "\"400 N*m\"]\n";
const std::vector<std::string> results{"A = shaft.d^2", "tau = shaft.tau_max"};

project::Keep kept() { return {5, {{0, sweep::Aim::min}, {1, sweep::Aim::min}}}; }

report::DrawnPoints drawn_of(const Swept& swept) {
  return report::points_to_draw(swept.plan, swept.sum, project::all_blocks(swept.plan),
                                [&] { return swept.read_again(); });
}

bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

void check_values(const Swept& swept, const report::SolvedPoints& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < points.results.size(); ++k) {
      const double there = swept.columns[k][points.numbers[i]], here = points.results[k][i];
      CHECK((same(here, there) || (here != here && there != there)));
    }
  }
}

const figure::Chart* chart_in(const std::vector<report::Block>& blocks, const std::string& id) {
  for (const report::Block& block : blocks) {
    const auto* const figure = std::get_if<figure::Figure>(&block);
    if (figure != nullptr && figure->id == id) return std::get<figure::Charted>(figure->content).get();
  }
  return nullptr;
}

}  // namespace

TEST_SUITE("charts of a sweep") {
  TEST_CASE("two crossed inputs make a plane, its rows rising, with the points of the sweep") {
    const Swept swept(grid, results, 1, kept());
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    const report::DrawnPoints drawn = drawn_of(swept);
    REQUIRE(drawn.plane);
    CHECK(drawn.plane->columns == 13);
    CHECK(drawn.plane->points.size() == 39);
    CHECK(drawn.plane->points.numbers[0] == 1);  // 30 mm and 100 N*m, the second of the list
    check_values(swept, drawn.plane->points);
    const auto blocks = report::sweep_charts(swept.read_again(), swept.plan, swept.sum, drawn);
    const figure::Chart* const plane = chart_in(blocks, "plane");
    REQUIRE(plane != nullptr);
    CHECK(plane->is_limited);
    for (std::size_t i = 0; i < 39; ++i) {
      const double u = 16.0 * plane->dots[i].y / (M_PI * std::pow(plane->dots[i].x, 3)) / 30e6;
      CHECK(plane->levels[i] == doctest::Approx(u));
      CHECK(plane->dots[i].verdict == (u > 1.0 ? figure::Chart::Verdict::fails : figure::Chart::Verdict::passes));
    }
    CHECK(std::all_of(plane->modes.begin(), plane->modes.end(),
                      [](const std::string& mode) { return mode.starts_with("shaft."); }));
    CHECK(plane->dots[plane->shown].verdict == figure::Chart::Verdict::passes);
  }

  TEST_CASE("no other inputs make a plane") {
    const std::string d = "d = { from = \"30 mm\", to = \"60 mm\", count = 5 }\n";
    for (const std::string& other :
         {std::string("T = \"200 N*m\"\n"), std::string("T = { mean = \"200 N*m\", sd = \"10 %\" }\n"),
          std::string("T = [\"200 N*m\", \"300 N*m\"]\nl = [\"1 m\", \"2 m\"]\nG = \"81 GPa\"\ntheta_adm = \"0.25 "
                      "deg/m\"\n")}) {
      const Swept swept(shaft + d + other, results);
      REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
      CHECK_FALSE(drawn_of(swept).plane);
    }
    const Swept zipped(shaft + d +
                           "T = { from = \"100 N*m\", to = \"200 N*m\", count = 5 }\n[project.sweep]\nzip = "
                           "[[\"shaft.d\", \"shaft.T\"]]\n",
                       results);
    REQUIRE_MESSAGE(zipped.errors().empty(), zipped.errors());
    CHECK_FALSE(drawn_of(zipped).plane);
  }

  TEST_CASE("an input that varies together with one of the two does not prevent the plane") {
    const Swept swept(shaft +
                          "d = [\"30 mm\", \"40 mm\", \"50 mm\"]\nT = [\"100 N*m\", \"200 N*m\", \"300 N*m\"]\nl = "
                          "[\"1 m\", \"2 m\"]\nG = \"81 GPa\"\ntheta_adm = \"0.25 deg/m\"\n[project.sweep]\nzip = "
                          "[[\"shaft.d\", \"shaft.T\"]]\n",
                      results);
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    const report::DrawnPoints drawn = drawn_of(swept);
    REQUIRE(drawn.plane);
    CHECK(drawn.plane->points.size() == 6);
    check_values(swept, drawn.plane->points);
  }

  TEST_CASE("with samples the designs are drawn, each at its quantiles, with the Pareto set of them") {
    const Swept swept(shaft +
                          "d = { from = \"30 mm\", to = \"60 mm\", count = 7 }\nT = { mean = \"200 N*m\", sd = \"10 "
                          "%\" }\n[project.sweep]\nsamples = 300\n",
                      results, 1, kept());
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    const report::DrawnPoints drawn = drawn_of(swept);
    CHECK(drawn.cloud.numbers == std::vector<std::uint64_t>{0, 300, 600, 900, 1200, 1500, 1800});
    for (std::size_t i = 0; i < 7; ++i) {
      const double d = 0.030 + 0.005 * static_cast<double>(i), T = 200.0 * (1.0 + 0.1 * 2.326);  // 99 % of a normal law
      CHECK(drawn.cloud.results[0][i] == doctest::Approx(d * d));
      CHECK(drawn.cloud.results[1][i] == doctest::Approx(16.0 * T / (M_PI * d * d * d)).epsilon(0.05));
    }
    CHECK(swept.sum.designs().pareto().size() == 7);  // thicker is heavier and less stressed
    const auto blocks = report::sweep_charts(swept.read_again(), swept.plan, swept.sum, drawn);
    const figure::Chart* const cloud = chart_in(blocks, "cloud");
    REQUIRE(cloud != nullptr);
    CHECK(cloud->front.size() == 7);
  }

  TEST_CASE("of many points 2000 are drawn, the Pareto set and the worst among them") {
    const Swept swept(shaft +
                          "d = { from = \"30 mm\", to = \"60 mm\", count = 7 }\nT = { from = \"160 N*m\", to = "
                          "\"240 N*m\", count = 3000 }\n",
                      results, 1, kept());
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    const report::DrawnPoints drawn = drawn_of(swept);
    const auto& numbers = drawn.cloud.numbers;
    CHECK(numbers.size() == 2000);
    CHECK(std::is_sorted(numbers.begin(), numbers.end()));
    CHECK(numbers == drawn_of(swept).cloud.numbers);
    const auto has = [&](std::uint64_t number) { return std::binary_search(numbers.begin(), numbers.end(), number); };
    for (const auto& point : swept.sum.pareto()) CHECK(has(point.index));
    for (const auto& point : swept.sum.worst()) CHECK(has(point.index));
    check_values(swept, drawn.cloud);
    for (std::uint64_t part = 0; part < 21; ++part) {  // every thousand points alike
      const auto from = std::lower_bound(numbers.begin(), numbers.end(), 1000 * part);
      const auto to = std::lower_bound(numbers.begin(), numbers.end(), 1000 * (part + 1));
      CHECK(to - from > 80);
      CHECK(to - from < 115);
    }
    const report::Document document = report::sweep_document(swept.read_again(), swept.plan, swept.sum, "p", drawn);
    const std::string page = report::html(document);
    CHECK(page.size() < 400'000);
    CHECK(page.find("<span data-point>") != std::string::npos);
    CHECK(page.find("loadpath run part.toml --point ") != std::string::npos);
    const std::string markdown = report::markdown(document, "r").text;
    CHECK(markdown.find("r-1-cloud.svg") != std::string::npos);
    CHECK(markdown.find("2000 of 21000 points") != std::string::npos);
  }

  TEST_CASE("a shard draws its own points, and no plane") {
    const Swept swept(shaft +
                          "d = { from = \"30 mm\", to = \"60 mm\", count = 40 }\nT = { from = \"100 N*m\", to = \"300 "
                          "N*m\", count = 40 }\n",
                      results, 1, kept());
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    const project::BlockRange shard{2, 4};
    project::SweepStatistics found = project::nothing_found(swept.plan, swept.read_again(), kept());
    project::solve({swept.plan, [&] { return swept.read_again(); }, kept(), shard, 1, false},
                   [&](project::SweptPart&& part) { return found.merge(part.found); });
    const auto drawn = report::points_to_draw(swept.plan, found, shard, [&] { return swept.read_again(); });
    CHECK_FALSE(drawn.plane);
    CHECK(drawn.cloud.size() == 2 * project::block_size);
    CHECK(drawn.cloud.numbers.front() == 2 * project::block_size);
  }
}
