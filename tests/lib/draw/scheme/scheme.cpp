#include "lib/draw/scheme/fit.hpp"
#include "lib/draw/scheme/parts.hpp"
#include "tests/lib/draw/figures.hpp"
#include "tests/lib/draw/svg_reader.hpp"

#include <doctest/doctest.h>

#include <numbers>

using namespace loadpath::draw;
using namespace loadpath::figure;
using namespace loadpath::draw::test;

TEST_SUITE("draw") {
  TEST_CASE("a scheme shows its links, pins, supports, block, forces and couple") {
    const std::string text = drawn(lever());
    CHECK(count(text, "<path class=\"bar\"") == 2);
    CHECK(count(text, "<circle class=\"pin\"") == 3);
    CHECK(count(text, "<path class=\"pin\"") == 3);    // two supports and the block
    CHECK(count(text, "<path class=\"light\"") == 2);  // hatching
    CHECK(count(text, "<path class=\"force ") == 4);   // three forces and the couple
    for (const char* label : {"A", "B", "C", "O", "1", "3", "F", "RO", "RB", "M = -27.35 N·m"}) {
      CHECK_MESSAGE(says(text, label), label);
    }
  }

  TEST_CASE("scale bars give lengths and forces") {
    const std::string text = drawn(lever());
    CHECK(says(text, "20 mm"));
    CHECK(says(text, "200 N"));
    CHECK(says(drawn(six_bar()), "2 m"));
    Scheme heavy = lever();
    for (auto& arrow : heavy.arrows) arrow.force = {1e3 * arrow.force.x, 1e3 * arrow.force.y};
    CHECK(says(drawn(heavy), "200 kN"));
  }

  TEST_CASE("the largest force is a quarter of the drawing and the others follow its scale") {
    const Scheme scheme = lever();
    const Fit placed = fit(scheme);
    const auto shown = [&](const Scheme::Arrow& a) { return length(placed.tip(a) - placed.at(a.at)); };
    CHECK(shown(scheme.arrows[0]) == doctest::Approx(0.25 * 0.105 * placed.scale));
    CHECK(shown(scheme.arrows[1]) / shown(scheme.arrows[0]) == doctest::Approx(std::hypot(200.0, 420.0) / 500.0));
  }

  TEST_CASE("everything lies in the view, whatever the size of the mechanism and the forces") {
    for (const double size : {1e-6, 1.0, 1e6}) {
      for (const double strength : {1e-9, 1.0, 1e9}) {
        Scheme scheme = six_bar();
        for (auto& body : scheme.bodies) {
          for (Point& p : body.points) p = size * p;
        }
        for (auto& joint : scheme.joints) joint.at = size * joint.at;
        for (auto& arrow : scheme.arrows) arrow.at = size * arrow.at, arrow.force = strength * arrow.force;
        for (auto& moment : scheme.moments) moment.at = size * moment.at;
        const Fit placed = fit(scheme);
        const Box view{0.0, 0.0, view_width, placed.height};
        for (const auto& arrow : scheme.arrows) CHECK(view.contains(Box::around(placed.tip(arrow), 20.0, 20.0)));
        for (const auto& joint : scheme.joints) CHECK(view.contains(Box::around(placed.at(joint.at), 40.0, 40.0)));
      }
    }
  }

  TEST_CASE("three points off a line make a plate, on a line a bar") {
    Scheme scheme;
    scheme.bodies = {{"plate", {{0, 0}, {1, 0}, {0.5, 0.5}, {0.5, 0.2}}}, {"bar", {{0, 1}, {1, 1}, {0.5, 1}}}};
    const std::string text = drawn(scheme);
    CHECK(count(text, "<path class=\"plate\"") == 1);
    CHECK(count(text, "<path class=\"bar\"") == 1);
  }

  TEST_CASE("the hull has the outer points only") {
    CHECK(convex_hull({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {5, 5}, {5, 0}, {0, 0}}).size() == 4);
    CHECK(convex_hull({{0, 0}, {5, 5}, {10, 10}}).size() == 2);
    CHECK(convex_hull({{1, 1}, {1, 1}}).size() == 1);
    CHECK(convex_hull({}).empty());
  }

  TEST_CASE("points on a line but for rounding make a bar from end to end, whichever way it points") {
    for (int degrees = 0; degrees < 360; degrees += 15) {
      const double turn = degrees * std::numbers::pi / 180.0;
      for (const double size : {1e-3, 1.0, 1e5}) {
        const Point way = size * along(turn);
        const std::vector<Point> bar = convex_hull({{0.0, 0.0}, way, 0.5 * way + 1e-15 * size * across(along(turn))});
        CAPTURE(degrees);
        REQUIRE(bar.size() == 2);
        CHECK(length(bar[1] - bar[0]) == doctest::Approx(size).epsilon(1e-12));
      }
    }
    CHECK(convex_hull({{0.0, 0.0}, {1e-3, 0.0}, {5e-4, 1e-6}}).size() == 3);              // a plate, however small
    const Point middle{1.2246467991473532e-18, 0.02}, top{2.4492935982947064e-18, 0.04};  // of a crank at 90 deg
    CHECK(length(convex_hull({{0.0, 0.0}, top, middle}).front()) == 0.0);
  }

  TEST_CASE("a fixed slider without a guide gets hatched ground, with a guide the guide is hatched") {
    Scheme scheme;
    scheme.bodies = {{"rod", {{0, 0.1}, {0.2, 0}}}};
    scheme.joints = {{"B", {0.2, 0}, Scheme::Pin::slider, true, 0.0}};
    CHECK(count(drawn(scheme), "<path class=\"light\"") == 1);
    scheme.guides = {{{0.1, 0}, {0.3, 0}, true}};
    CHECK(count(drawn(scheme), "<path class=\"light\"") == 1);
  }

  TEST_CASE("a path is drawn thin and dashed") {
    Scheme scheme = lever();
    scheme.paths = {{"A", {{0.06, 0}, {0.09, 0.03}, {0.12, 0}}}};
    CHECK(count(drawn(scheme), "<path class=\"light dash\"") == 1);
  }

  TEST_CASE("forces and couples that were not computed are left out") {
    Scheme scheme = lever();
    scheme.arrows[0].force = {std::nan(""), 0.0};
    scheme.moments[0].value = std::nan("");
    const std::string text = drawn(scheme);
    CHECK_FALSE(says(text, "F"));
    CHECK(count(text, "<path class=\"force ") == 2);
  }

  TEST_CASE("the description names links, joints, forces and moments with their values") {
    const std::string text = drawn(lever());
    CHECK(has(text, "link 1; link 3"));
    CHECK(has(text, "fixed pin O"));
    CHECK(has(text, "force F = 500 N"));
    CHECK(has(text, "moment M = -27.35 N·m"));
  }
}
