#include "lib/draw/svg.hpp"
#include "tests/lib/draw/figures.hpp"
#include "tests/lib/draw/svg_reader.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace loadpath::draw;
using namespace loadpath::figure;
using namespace loadpath::draw::test;

namespace {

int curves_in(std::string_view svg) { return count(svg, "<path class=\"curve "); }

Plot noisy_plot() {
  Plot plot = moment_plot();
  plot.marks.clear();
  Curve noise{"M", {}, {}};
  unsigned seed = 7;
  for (int i = 0; i < 3600; ++i) {
    seed = seed * 1664525U + 1013904223U;
    noise.x.push_back(0.1 * i * degree);
    noise.y.push_back(static_cast<double>(seed >> 8U));
  }
  plot.curves = {noise};
  return plot;
}

}  // namespace

TEST_SUITE("draw") {
  TEST_CASE("the axes show symbol, meaning and unit") {
    const std::string text = drawn(moment_plot());
    CHECK(says(text, "driving moment M in N·m"));
    CHECK(has(text, "crank angle <tspan class=\"s\">φ</tspan> in "));
    for (const char* tick : {"0", "45", "90", "180", "360", "−20", "−100"}) CHECK_MESSAGE(says(text, tick), tick);
  }

  TEST_CASE("a plain number has no unit, a large one a power of ten") {
    Plot plot = torque_plot();
    plot.y = {"u", "utilisation", "-"};
    CHECK(says(drawn(plot), "utilisation u"));
    for (double& y : plot.curves[0].y) y *= 1e9;
    CHECK(says(drawn(plot), "utilisation u in 10¹²"));
  }

  TEST_CASE("a unit with a prefix takes the power of ten, at the marks too") {
    Plot plot = moment_plot();
    for (auto& curve : plot.curves) {
      for (double& y : curve.y) y *= 5e3;
    }
    for (auto& mark : plot.marks) mark.y *= 5e3;
    const std::string text = drawn(plot);
    CHECK(says(text, "driving moment M in kN·m"));
    CHECK(has(text, "peak −430 kN·m at 202.7"));
  }

  TEST_CASE("a mark has its label, value and position") {
    const std::string text = drawn(moment_plot());
    CHECK(has(text, "peak −86 N·m at 202.7"));
    CHECK(count(text, "<circle class=\"solid\"") == 1);
  }

  TEST_CASE("a bound is a dashed line with its value, inside the plot") {
    const std::string text = drawn(reaction_plot());
    CHECK(count(text, "<path class=\"bound\"") == 1);
    CHECK(says(text, "Radm 1900 N"));
    CHECK(says(text, "2000"));
  }

  TEST_CASE("curves are distinguished by dashes and labelled directly") {
    const std::string text = drawn(reaction_plot());
    CHECK(has(text, "<path class=\"curve c0 d0\""));
    CHECK(has(text, "<path class=\"curve c1 d1\""));
    CHECK(says(text, "R12"));
    CHECK(says(text, "R23"));
    CHECK(curves_in(text) == 2);
  }

  TEST_CASE("the label of a single curve is not repeated when the axis shows it") {
    CHECK_FALSE(says(drawn(moment_plot()), "M"));
  }

  TEST_CASE("curves without space for labels are named below the plot") {
    Plot plot = reaction_plot();
    plot.bounds.clear();
    const Curve curve = plot.curves[0];
    plot.curves.clear();
    for (int k = 0; k < 30; ++k) {
      plot.curves.push_back(curve);
      plot.curves.back().label = "R_" + std::to_string(k);
      for (double& y : plot.curves.back().y) y += 20.0 * k;
    }
    const std::string text = drawn(plot);
    CHECK(curves_in(text) == 60);
    CHECK(says(text, "R29"));
    CHECK(overlap(text) == "");
  }

  TEST_CASE("isolated points are named below the plot by a dot") {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    Plot plot = torque_plot();
    plot.curves = {{"tests", {1.0, 1.5, 2.0}, {5.0, none, 6.0}}, {"mean", {1.0, 2.0}, {5.0, 6.0}}};
    const std::string text = drawn(plot);
    CHECK(says(text, "tests"));
    CHECK(count(text, "<circle class=\"f0\"") == 3);
    CHECK(curves_in(text) == 2);
  }

  TEST_CASE("the value is shown in each segment of a diagram along a shaft") {
    const std::string text = drawn(torque_plot());
    for (const char* value : {"900", "−2700", "−1200"}) CHECK_MESSAGE(says(text, value), value);
    CHECK(count(text, "class=\"area ") == 1);
  }

  TEST_CASE("a segment sampled by many points is one segment") {
    Plot plot = torque_plot();
    plot.curves = {{"T", {}, {}, true}};
    for (int i = 0; i <= 100; ++i) {
      plot.curves[0].x.push_back(0.01 * i);
      plot.curves[0].y.push_back(i <= 50 ? 123.0 : -77.0);
    }
    int values = 0;
    for (const std::string& t : texts(drawn(plot))) values += t == "123" || t == "−77" ? 1 : 0;
    CHECK(values == 2);
  }

  TEST_CASE("a missing value breaks the curve") {
    Plot plot = moment_plot();
    plot.curves[0].y[100] = std::numeric_limits<double>::quiet_NaN();
    CHECK(curves_in(drawn(plot)) == 2);
  }

  TEST_CASE("a value between missing ones is a dot") {
    Plot plot = torque_plot();
    const double missing = std::numeric_limits<double>::quiet_NaN();
    plot.curves = {{"T", {0, 0.5, 1}, {missing, 7.0, missing}}};
    CHECK(count(drawn(plot), "<circle class=\"f0\"") == 1);
  }

  TEST_CASE("on a logarithmic scale values of zero or less are left out") {
    Plot plot;
    plot.x = {"N", "cycles", "-", true};
    plot.y = {"S", "stress", "MPa", true};
    plot.curves.push_back({"", {0.0, 1e4, 1e6}, {1e8, -1e8, 1e8}});
    const std::string drawn = svg({"a", "", plot});
    CHECK(drawn.find("nan") == std::string::npos);
    CHECK(drawn.find("inf") == std::string::npos);
    CHECK(drawn.find("<circle") != std::string::npos);
  }

  TEST_CASE("a plot without any value states so") {
    Plot plot = torque_plot();
    for (double& y : plot.curves[0].y) y = std::numeric_limits<double>::quiet_NaN();
    CHECK(says(drawn(plot), "not available"));
    CHECK(says(drawn(Plot{}), "not available"));
  }

  TEST_CASE("a curve of 3600 points stays below 10 KB") {
    const std::string text = drawn(noisy_plot());
    for (const Element& e : elements(text, "path")) CHECK(attribute(e.tag, "d").size() < 10000);
  }
}
