#include "lib/draw/drawing/fit.hpp"
#include "lib/draw/dxf.hpp"
#include "lib/draw/svg.hpp"
#include "tests/lib/draw/drawing/drawings.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace loadpath;
using namespace loadpath::draw;
using namespace loadpath::figure;
using namespace loadpath::draw::test;

namespace {

using Side = Drawing::Side;

/// A plate of 200 by 100 mm with a hole.
Drawing::View plate() {
  Drawing::View view;
  const std::vector<Point> outline{{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}};
  view.areas.push_back({outline, Drawing::Kind::cut, "plate"});
  view.circles.push_back({{0.05, 0.05}, 0.02});
  view.lengths = {{{0, 0}, {0.2, 0}, {"l", 0.2, "mm"}, Side::below},
                  {{0, 0}, {0.05, 0.05}, {"x", 0.05, "mm"}, Side::below},
                  {{0.2, 0}, {0.2, 0.1}, {"h", 0.1, "mm"}, Side::right}};
  view.radii = {{{0.05, 0.05}, 0.02, 0.7, {"d", 0.04, "mm"}, true}};
  return view;
}

Figure figure_of(const Drawing::View& view) {
  auto drawing = std::make_shared<Drawing>();
  drawing->views = {view};
  return {"plate", "A plate", Drawn(std::move(drawing))};
}

std::vector<Point> square(double half) { return {{-half, -half}, {half, -half}, {half, half}, {-half, half}}; }

}  // namespace

TEST_SUITE("drawing") {
  TEST_CASE("lengths, radii and their values are drawn, for screen readers too") {
    const Figure figure = figure_of(plate());
    const std::string text = svg(figure);
    for (const char* const words : {"l = 200 mm", "x = 50 mm", "h = 100 mm", "d = 40 mm"}) {
      CAPTURE(words);
      CHECK(says(text, words));
      CHECK(text.find(words) < text.find("</desc>"));
    }
    CHECK(overlap(text) == "");
    check_drawn(figure);
  }

  TEST_CASE("both directions have the same scale, and the shorter dimension is nearer") {
    const ViewFit placed = fit(plate(), {0.0, 0.0}, view_width);
    CHECK(placed.extent.width() == doctest::Approx(2.0 * placed.extent.height()));
    CHECK(placed.extent.width() == doctest::Approx(0.2 * placed.scale));
    REQUIRE(placed.rows.size() == 3);
    CHECK(placed.rows[0].length == 1);  // x
    CHECK(placed.rows[0].row == 0);
    CHECK(placed.rows[2].length == 0);  // l
    CHECK(placed.rows[2].row == 1);
    CHECK(placed.area.contains(placed.extent));
  }

  TEST_CASE("a dimension too short for its text has it outside its line, and nothing overlaps") {
    Drawing::View view = plate();
    view.lengths.push_back({{0.05, 0}, {0.052, 0}, {"a", 0.002, "mm"}, Side::below});
    view.lengths.push_back({{0.052, 0}, {0.06, 0}, {"b", 0.008, "mm"}, Side::below});
    view.lengths.push_back({{0, 0}, {0, 0.003}, {"c", 0.003, "mm"}, Side::left});
    const std::string text = svg(figure_of(view));
    CHECK(overlap(text) == "");
    check_drawn(figure_of(view));
  }

  TEST_CASE("an element without a place or value is left out") {
    Drawing::View view = plate();
    view.lengths[0].value.si = std::nan("");
    view.circles.push_back({{INFINITY, 0.0}, 0.1});
    view.forces.push_back({{0.0, 0.0}, {std::nan(""), 1.0}, {"F", 1.0, "N"}});
    view.paths.push_back({{{0.0, 0.0}, {std::nan(""), 0.0}}});
    view.angles.push_back({{0.0, 0.0}, 0.01, 0.0, std::nan(""), {"phi", std::nan(""), "deg"}});
    const std::string text = svg(figure_of(view));
    CHECK_FALSE(has(text, "nan"));
    CHECK_FALSE(has(text, "l = "));
    CHECK_FALSE(has(text, "F = "));
    CHECK(svg(figure_of({})).find("</svg>") != std::string::npos);
  }

  TEST_CASE("views that fit are side by side") {
    auto drawing = std::make_shared<Drawing>();
    Drawing::View left = plate(), right = plate();
    left.share = 0.6, right.share = 0.4;
    drawing->views = {left, right};
    const Figure both{"two", "Two plates", Drawn(drawing)};
    check_drawn(both);
    const std::string text = svg(both);
    const auto lines = elements(text, "circle");
    REQUIRE(lines.size() == 2);
    CHECK(number(lines[0].tag, "cx") < 0.6 * view_width);
    CHECK(number(lines[1].tag, "cx") > 0.6 * view_width);
  }

  TEST_CASE("hatching lies within the face and not in its hole") {
    std::vector<Point> face = square(10.0);
    face.push_back(face.front());
    std::vector<Point> hole = square(4.0);
    face.insert(face.end(), hole.rbegin(), hole.rend());
    face.push_back(hole.back());
    const auto strokes = hatching(face, 1.0);
    CHECK(strokes.size() > 20);
    for (const auto& [from, to] : strokes) {
      const Point middle = 0.5 * (from + to);
      CHECK(std::max(std::fabs(middle.x), std::fabs(middle.y)) <= 10.0);
      CHECK(std::max(std::fabs(middle.x), std::fabs(middle.y)) >= 4.0 - 1e-9);
    }
  }

  TEST_CASE("a window shows what lies in it: parts of lines, the part of a face") {
    const Box window{0.0, 0.0, 10.0, 10.0};
    const auto pieces = clipped({{-5, 5}, {5, 5}, {5, 15}, {8, 15}, {8, 5}}, window);
    REQUIRE(pieces.size() == 2);
    CHECK(pieces[0].front().x == doctest::Approx(0.0));
    CHECK(pieces[0].back().y == doctest::Approx(10.0));
    CHECK(pieces[1].front().y == doctest::Approx(10.0));
    const auto face = clipped_area({{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, window);
    CHECK(face.size() == 4);
    for (const Point p : face) CHECK(window.grown(1e-9).contains(Box::around(p, 0.0, 0.0)));
    CHECK(clipped({{-5, -5}, {-5, 20}}, window).empty());
  }

  TEST_CASE("the thickness of a thin face is its area over half of its circumference") {
    CHECK(mean_thickness({{0, 0}, {100, 0}, {100, 1}, {0, 1}}) == doctest::Approx(1.0).epsilon(0.02));
  }

  TEST_CASE("for CAD it is 1:1 in mm, with its dimensions as lines and texts") {
    const Figure figure = figure_of(plate());
    REQUIRE(is_to_scale(figure));
    const std::string text = dxf_of(figure);
    CHECK(has(text, "\nCIRCLE\n8\noutlines\n"));
    CHECK(has(text, "\n40\n20\n"));  // its radius
    CHECK(has(text, "l = 200 mm"));
    CHECK(has(text, "\n8\ndimensions\n"));
    CHECK_FALSE(has(text, "nan"));
    CHECK(text.ends_with("0\nENDSEC\n0\nEOF\n"));
    CHECK(dxf_of(Figure{"none", "A plot", Plot{}}).empty());
    CHECK_FALSE(is_to_scale(Figure{"none", "A plot", Plot{}}));
  }
}
