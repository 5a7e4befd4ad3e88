#include "lib/draw/svg.hpp"

#include "tests/lib/draw/figures.hpp"
#include "tests/lib/draw/svg_reader.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace loadpath::draw;
using namespace loadpath::figure;
using namespace loadpath::draw::test;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

/// Contents that a failed or trivial calculation may leave behind.
std::vector<Figure> odd_figures() {
  std::vector<Figure> all;
  const auto add = [&](auto content) { all.push_back({"odd", "Odd", std::move(content)}); };
  const auto plot = [&](std::vector<double> x, std::vector<double> y, bool filled = false) {
    Plot p;
    p.x = {"x", "", "mm"};
    p.y = {"y", "", ""};
    p.curves = {{"y", std::move(x), std::move(y), filled}};
    p.marks = {{0.0, nan, "peak"}};
    p.bounds = {{infinite, "bound"}};
    add(p);
  };
  add(Plot{}), add(Scheme{}), add(Shaft{});
  plot({}, {});
  plot({1.0}, {1.0});
  plot({1.0}, {1.0}, true);
  plot({0, 1, 2}, {nan, nan, nan});
  plot({0, 1, 2}, {nan, 5.0, nan}, true);
  plot({0, 1, 2}, {3.0, 3.0, 3.0}, true);
  plot({0, 0, 0}, {0.0, 0.0, 0.0}, true);
  plot({nan, infinite, 1}, {1.0, 1.0, infinite});
  plot({0, 1}, {1e-12, 2e-12});
  plot({0, 1e-12}, {-1e12, 1e12});
  plot({0, 1}, {-1e308, 1e308});
  plot({0, 1}, {5e-324, 1e-310});
  plot({0, 1, 2}, {1.0, 2.0});
  Scheme scheme;
  scheme.bodies = {{"1", {{0, 0}, {0, 0}}}, {"2", {{nan, 0}, {1, 1}}}, {"3", {}}};
  scheme.joints = {{"A", {0, 0}}, {"B", {nan, nan}}, {"C", {0, 0}, Scheme::Pin::slider, true, nan}};
  scheme.arrows = {{{0, 0}, {nan, 1}, "F"}, {{0, 0}, {0, 0}, "G"}, {{0, 0}, {1e12, 1e-12}, "H"}};
  scheme.moments = {{{0, 0}, nan, "M"}, {{0, 0}, 0.0, "N"}};
  scheme.guides = {{{0, 0}, {infinite, 0}, true}, {{0, 0}, {0, 0}, true}};
  scheme.paths = {{"A", {{0, 0}, {nan, nan}}}};
  add(scheme);
  scheme.joints.push_back({"D", {1e12, 1e-12}, Scheme::Pin::revolute, true});
  add(scheme);
  Shaft shaft;
  shaft.parts = {{0.0, 0.05, 0.0}, {nan, 0.05, 0.0}, {0.001, 1e3, 2e3}, {1e4, 0.001, nan}};
  shaft.torques = {{nan, 1.0, "T"}, {5e9, 1.0, "T"}, {0.0, nan, "T"}, {0.0, 0.0, "T"}};
  add(shaft);
  return all;
}

std::vector<Figure> good_figures() {
  return {{"moment", "Moment", moment_plot()}, {"reactions", "Reactions", reaction_plot()},
          {"torque", "Torque", torque_plot()}, {"lever", "Lever", lever()},
          {"six-bar", "Six-bar", six_bar()},   {"shaft", "Shaft", stepped_shaft()}};
}

}  // namespace

TEST_SUITE("draw") {
  TEST_CASE("every figure is well formed, without nan and inf, with at most two decimals") {
    auto figures = odd_figures();
    for (auto& figure : good_figures()) figures.push_back(std::move(figure));
    for (std::size_t i = 0; i < figures.size(); ++i) {
      CAPTURE(i);
      const std::string text = svg(figures[i]);
      CHECK(well_formed(text));
      CHECK_FALSE(has(text, "nan"));
      CHECK_FALSE(has(text, "inf"));
      CHECK(most_decimals(text) <= 2);
      CHECK(text.size() < 20000);
    }
  }

  TEST_CASE("equal figures are equal to the byte") {
    for (const Figure& figure : good_figures()) CHECK(svg(figure) == svg(figure));
  }

  TEST_CASE("no text of a valid figure covers another") {
    for (const Figure& figure : good_figures()) CHECK_MESSAGE(overlap(svg(figure)) == "", figure.id);
  }

  TEST_CASE("a figure has a title and a description for screen readers") {
    const std::string text = svg({"m", "Driving moment", moment_plot()});
    CHECK(has(text, "<title>Driving moment</title>"));
    CHECK(has(text, "<desc>driving moment M in N·m over crank angle φ in "));
    CHECK(has(text, "peak: -86 N·m at 202.7"));
    CHECK(has(text, "role=\"img\""));
  }

  TEST_CASE("text of the user is escaped and control characters are dropped") {
    Plot plot = moment_plot();
    plot.marks[0].label = "<b>\"a\" & b\x01</b>";
    plot.curves.push_back({"]]><script>", {0, 1}, {1, 2}});
    const std::string text = svg({"m", "1 < 2 & 3", plot});
    CHECK(well_formed(text));
    CHECK(has(text, "<title>1 &lt; 2 &amp; 3</title>"));
    CHECK(has(text, "&lt;b&gt;&quot;a&quot; &amp; b&lt;/b&gt; −86 N·m"));
    CHECK_FALSE(has(text, "<script>"));
    CHECK_FALSE(has(text, "\x01"));
  }

  TEST_CASE("colours are variables of the page with fallbacks, and nothing is fetched") {
    const std::string text = drawn(lever());
    for (const char* name : {"--ink", "--muted", "--grid", "--accent", "--accent2", "--accent3", "--paper"}) {
      CHECK(has(text, "var(" + std::string(name) + ",#"));
    }
    CHECK_FALSE(has(text, "href"));
    CHECK_FALSE(has(text, "url("));
    CHECK_FALSE(has(text, "<script"));
  }

  TEST_CASE("a figure scales with the page") {
    const std::string text = drawn(torque_plot());
    CHECK(has(text, "viewBox=\"0 0 480 "));
    CHECK(has(text, "max-width:100%;height:auto"));
  }
}
