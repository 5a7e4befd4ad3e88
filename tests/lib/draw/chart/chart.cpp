// Charts of many designs: their marks, their descriptions, and that no word of a user ends the script.
#include "lib/draw/chart/chart.hpp"

#include "lib/draw/chart/picture.hpp"
#include "lib/draw/svg.hpp"
#include "tests/lib/draw/svg_reader.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <limits>

using namespace loadpath::draw;
using namespace loadpath::figure;
using namespace loadpath::draw::test;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
using Verdict = Chart::Verdict;

/// Four dots over mass and utilisation.
Chart cloud() {
  Chart chart;
  chart.x = {"mass", "", "kg"};
  chart.y = {"u", "", "-"};
  chart.dots = {{1.0, 1.2, Verdict::fails, 0}, {2.0, 0.8, Verdict::passes}, {3.0, 0.9, Verdict::open}, {nan, nan}};
  chart.modes = {"strut.buckling"};
  chart.front = {0, 1};
  chart.worst = {0};
  chart.steps = true;
  chart.points = {7, 8, 9, 10};
  chart.readout = {{"material", "", {0.0, 1.0, 0.0, 1.0}, {"</script><b>", "S\"235\\"}},
                   {"mass", "kg", {1.0, 2.0, 3.0, nan}},
                   {"verdict", "", {0.0, 1.0, 2.0, 2.0}, {"fails", "passes", "no result"}}};
  chart.command = "loadpath run a.toml --point ";
  chart.shown = 1;
  return chart;
}

/// Utilisation x*y over two lengths; beyond y = 4 m nothing is judged.
Chart plane() {
  Chart chart;
  chart.x = {"strut.a", "", "m"};
  chart.y = {"strut.b", "", "m"};
  chart.columns = 21;
  chart.level = "utilisation";
  chart.is_limited = true;
  chart.modes = {"strut.buckling", "strut.yield"};
  for (int j = 0; j < 21; ++j) {
    for (int i = 0; i < 21; ++i) {
      const double x = 0.1 + 0.1 * i, y = 0.1 + 0.1 * j, u = x * y;
      const Verdict verdict = y > 1.85 && u < 1.0 ? Verdict::none : u > 1.0 ? Verdict::fails : Verdict::passes;
      chart.dots.push_back({x, y, verdict, static_cast<std::size_t>(x > y ? 1 : 0)});
      chart.levels.push_back(u);
      chart.points.push_back(chart.points.size());
    }
  }
  return chart;
}

Figure figure_of(Chart chart) { return {"c", "Points", std::make_shared<const Chart>(std::move(chart))}; }

}  // namespace

TEST_SUITE("charts") {
  TEST_CASE("a cloud has dots, crosses and rings, and states how many of each") {
    const std::string drawn = svg(figure_of(cloud()));
    CHECK(well_formed(drawn));
    CHECK(most_decimals(drawn) <= 2);
    CHECK(has(drawn, "<title>Points</title>"));
    CHECK(has(drawn,
              "u over mass in kg; 4 points drawn: 1 pass; 1 fail by strut.buckling; 1 have no result; 1 are invalid "
              "designs; 2 of them in the Pareto set: less mass is better, less u is better"));
    for (const char* style : {"passing", "failing", "ring", "hole", "front"})
      CHECK_MESSAGE(count(drawn, "<path class=\"" + std::string(style) + "\"") >= 1, style);
    for (const char* words : {">passes<", ">fails<", ">no result<", ">Pareto set<", ">largest utilisation<"})
      CHECK_MESSAGE(has(drawn, words), words);
    CHECK(!has(drawn, "data-here"));
  }

  TEST_CASE("the Pareto front follows the worse of two neighbours") {
    Chart chart = cloud();
    const auto corner_of = [](const Chart& of) {
      const auto places = chart_picture(of).places;
      const std::string drawn = svg(figure_of(of));
      const auto paths = elements(drawn, "path");
      const auto stairs =
          std::find_if(paths.begin(), paths.end(), [](const auto& path) { return has(path.tag, "class=\"thin\""); });
      REQUIRE(stairs != paths.end());
      const std::string way(attribute(stairs->tag, "d"));  // "M x y l dx dy dx dy": first across, or first down
      const double across = std::stod(way.substr(way.find('l') + 1));
      return std::abs(across) > 1e-9;
    };
    CHECK(corner_of(chart));  // least of both: the corner has the larger mass
    chart.more_x = chart.more_y = true;
    CHECK(!corner_of(chart));
  }

  TEST_CASE("a plane hatches failures, names their modes and dots invalid designs") {
    const std::string drawn = svg(figure_of(plane()));
    CHECK(well_formed(drawn));
    CHECK(has(drawn, "utilisation over strut.a in m and strut.b in m"));
    for (const char* style : {"hatch", "speckle", "level", "limit"})
      CHECK_MESSAGE(has(drawn, "class=\"" + std::string(style) + "\""), style);
    for (const char* words : {">strut.buckling<", ">strut.yield<", ">passes<"}) CHECK_MESSAGE(has(drawn, words), words);
    CHECK(drawn.size() < 40'000);
  }

  TEST_CASE("the limit lies where the utilisation is one") {
    Chart chart = plane();
    const PlotFrame frame = frame_of(chart);
    const ChartPicture picture = chart_picture(chart);
    CHECK(picture.places.size() == 441);
    const std::string drawn = svg(figure_of(chart));
    for (const auto& path : elements(drawn, "path")) {
      if (!has(path.tag, "class=\"limit\"")) continue;
      const std::string way(attribute(path.tag, "d"));
      const auto corner = frame.place(0.1, 0.1), far = frame.place(2.1, 2.1);
      const double x0 = std::stod(way.substr(1)), y0 = std::stod(way.substr(way.find(' ') + 1));
      const double x = 0.1 + 2.0 * (x0 - corner->x) / (far->x - corner->x);
      const double y = 0.1 + 2.0 * (y0 - corner->y) / (far->y - corner->y);
      CHECK(x * y == doctest::Approx(1.0).epsilon(0.02));
    }
  }

  TEST_CASE("the data are JSON that cannot end a script") {
    const InteractiveChart drawn = interactive_chart(figure_of(cloud()));
    CHECK(well_formed(drawn.svg));
    CHECK(has(drawn.svg, "data-here"));
    CHECK(!has(drawn.data, "<"));
    const auto data = boost::json::parse(drawn.data).as_object();
    CHECK(data.at("points").as_array().size() == 3);  // the last has no place
    CHECK(data.at("shown").as_int64() == 1);
    const auto& material = data.at("readout").as_array().at(0).as_array();
    CHECK(material.at(0).as_array().at(0).as_string() == "</script><b>");
    CHECK(material.at(0).as_array().at(1).as_string() == "S\"235\\");
    CHECK(material.at(1).as_string() == "0 1 0");
    CHECK(data.at("readout").as_array().at(1).as_array().at(1).as_string() == "1 2 3");
  }

  TEST_CASE("a chart without any dot states so") {
    Chart chart;
    chart.x = chart.y = {"u", "", "-"};
    const std::string drawn = svg(figure_of(std::move(chart)));
    CHECK(well_formed(drawn));
    CHECK(has(drawn, "not available"));
  }
}
