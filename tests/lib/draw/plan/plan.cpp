#include "lib/draw/canvas/typeset.hpp"
#include "lib/draw/plan/picture.hpp"
#include "lib/draw/svg.hpp"
#include "tests/lib/draw/figures.hpp"
#include "tests/lib/draw/svg_reader.hpp"

#include <doctest/doctest.h>

using namespace loadpath::draw;
using namespace loadpath::figure;
using namespace loadpath::draw::test;

namespace {

/// Three forces that close a triangle.
Plan triangle(double size = 1.0) {
  return {"rod",
          "N",
          {{{0.0, 0.0}, {300.0 * size, 0.0}, "F", Plan::Tone::second},
           {{300.0 * size, 0.0}, {300.0 * size, 400.0 * size}, "R_A", Plan::Tone::first},
           {{300.0 * size, 400.0 * size}, {0.0, 0.0}, "R_B", Plan::Tone::first}}};
}

std::string drawn(std::vector<Plan> panels) { return svg({"plans", "Plans", Plans{std::move(panels)}}); }

}  // namespace

TEST_SUITE("draw") {
  TEST_CASE("a plan shows its vectors with heads and names, and a scale") {
    const std::string text = drawn({triangle()});
    CHECK(well_formed(text));
    CHECK(count(text, "<path class=\"force ") == 3);
    for (const char* label : {"rod", "F", "RA", "RB", "100 N"}) CHECK_MESSAGE(says(text, label), label);
  }

  TEST_CASE("a plan fills its panel to one scale, whatever the size of its vectors") {
    for (const double size : {1e-9, 1.0, 1e9}) {
      const Plan plan = triangle(size);
      const PlanFit placed = fit(plan, {10.0, 20.0}, 200.0, 180.0);
      for (const auto& v : plan.vectors) CHECK(placed.area.contains(Box::around(placed.at(v.to), 30.0, 30.0)));
      const Point base = placed.at(plan.vectors[0].to) - placed.at({}),
                  rise = placed.at(plan.vectors[1].to) - placed.at(plan.vectors[1].from);
      CHECK(length(rise) / length(base) == doctest::Approx(4.0 / 3.0));
    }
  }

  TEST_CASE("panels are side by side; two forces on a line are distinguishable") {
    const Plan pair{"crank", "N", {{{0.0, 0.0}, {0.0, 100.0}, "R_A"}, {{0.0, 100.0}, {0.0, 0.0}, "R_O"}}};
    const std::string text = drawn({triangle(), pair, triangle()});
    CHECK(well_formed(text));
    CHECK(says(text, "crank"));
    CHECK(count(text, "<path class=\"force ") == 8);
  }

  TEST_CASE("a title that is wider than its panel is broken into lines, and the next panel's stays clear of it") {
    Plan plan = triangle();
    plan.title = "joint_of_the_rod: connecting_rod on crosshead, in the axes of connecting_rod";
    const std::string text = drawn({plan, plan});
    CHECK(well_formed(text));
    CHECK_FALSE(says(text, plain(plan.title)));
    CHECK(overlap(text).empty());
    const double narrow = fit(plan, {}, 200.0, 180.0).area.height(), wide = fit(plan, {}, 900.0, 180.0).area.height();
    CHECK(narrow > wide);
  }

  TEST_CASE("the angles on a flat hodograph are next to their dots, off the scale bar") {
    Plan plan{"A: rod on slider", "N", {{{}, {100.0, 0.0}, "R_A"}}};
    Plan::Trace trace;
    for (int k = 0; k < 12; ++k) {
      trace.points.push_back({100.0 - 15.0 * k, 0.2 * (k % 3)});
      trace.marks.push_back({trace.points.back(), std::to_string(30 * k) + "°", k == 0});
    }
    plan.traces.push_back(trace);
    const std::string text = drawn({plan, plan});
    CHECK(overlap(text).empty());
    const PlanFit placed = fit(plan, {}, 236.0, 210.0);
    int named = 0;
    for (const Element& e : elements(text, "text")) {
      for (const auto& mark : trace.marks) {
        if (words(e.text) != mark.label || text_box(e).left > 236.0) continue;
        const Point dot = placed.at(mark.at);
        CHECK(length(text_box(e).centre() - dot) < 40.0);
        CHECK(text_box(e).bottom < placed.area.bottom - 20.0);
        ++named;
      }
    }
    CHECK(named >= 3);
  }

  TEST_CASE("the pole of a plan is a ring, moving points have a dot") {
    Plan plan{"", "m/s", {{{}, {1.0, 0.0}, ""}}};
    plan.points = {{"p", {}}, {"a", {1.0, 0.0}}};
    const std::string text = drawn({plan});
    CHECK(count(text, "<circle class=\"pin\"") == 1);
    CHECK(count(text, "<circle class=\"solid\"") == 1);
  }

  TEST_CASE("an empty plan, or one with values that are not numbers, is drawn without them") {
    CHECK(well_formed(drawn({})));
    CHECK(well_formed(drawn({Plan{"", "N", {}}})));
    CHECK(most_decimals(drawn({triangle(std::nan(""))})) <= 2);
  }

  TEST_CASE("wheels, belts and racks are drawn: circles, two spans, a pitch line") {
    Scheme scheme;
    scheme.wheels = {{{0.0, 0.0}, 0.05, 0.3, false}, {{0.3, 0.0}, 0.1, 0.0, false}};
    scheme.belts = {{{0.0, 0.0}, {0.3, 0.0}, 0.05, 0.1, false}};
    scheme.racks = {{{-0.1, -0.05}, {0.1, -0.05}, true, true, true}};
    const std::string text = svg({"wheels", "Wheels", scheme});
    CHECK(well_formed(text));
    CHECK(count(text, "<circle class=\"wheel\"") == 2);
    CHECK(count(text, "<path class=\"outline\"") == 3);
    CHECK(count(text, "<path class=\"centre\"") == 1);
  }
}
