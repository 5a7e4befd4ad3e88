// Planetary sets as drawn: every planet meshes with sun and ring, where it can be put in.
#include "calculators/gear/planetary/planetary.hpp"
#include "lib/draw/dxf.hpp"
#include "lib/draw/svg.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/draw/drawing/drawings.hpp"

#include <doctest/doctest.h>

using namespace loadpath;
using namespace loadpath::draw::test;
using figure::Drawing;
using figure::Point;
using Member = gear::Planetary::Member;

namespace {

using Input = gear::Planetary::Input;

Input set_of(int z_s, int z_p, int planets) {
  Input in;
  in.z_s = z_s, in.z_p = z_p, in.N_p = planets, in.m_n = 2.0 * mm;
  in.n_s = 1450.0 * rpm, in.h_ar = 0.9;
  return in;
}

figure::Figure figure_of(const Input& in) {
  const auto figures = gear::Planetary::figures(in, test::evaluated<gear::Planetary>(in));
  REQUIRE(figures.size() == 1);
  check_drawn(figures[0]);
  return figures[0];
}

bool is_within(Point p, const std::vector<Point>& outline) {
  bool within = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point a = outline[i], b = outline[(i + 1) % outline.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) within = !within;
  }
  return within;
}

/// How deep the points of an outline lie on the wrong side of another.
double depth(const std::vector<Point>& points, const std::vector<Point>& other, bool shall_be_within) {
  double deepest = 0.0;
  for (const Point p : points) {
    if (is_within(p, other) != shall_be_within) deepest = std::max(deepest, distance_to(p, other));
  }
  return deepest;
}

}  // namespace

TEST_SUITE("gear planetary figure") {
  TEST_CASE("no tooth of a planet overlaps sun or ring gear, evenly spaced or not, with even and odd tooth numbers") {
    for (const Input& in :
         {set_of(24, 30, 3), set_of(25, 31, 3), set_of(24, 30, 4), set_of(30, 18, 6), set_of(21, 40, 3)}) {
      CAPTURE(in.N_p);
      const auto figure = figure_of(in);
      std::vector<std::vector<Point>> outlines;
      for (const auto& path : drawing_of(figure).views[0].paths) {
        if (path.line == Drawing::Line::outline) outlines.push_back(path.points);
      }
      REQUIRE(outlines.size() == static_cast<std::size_t>(in.N_p) + 2);
      for (std::size_t k = 2; k < outlines.size(); ++k) {
        CHECK(depth(outlines[k], outlines[0], true) < 0.01e-3);   // the ring, at its inside
        CHECK(depth(outlines[k], outlines[1], false) < 0.01e-3);  // the sun
        CHECK(depth(outlines[1], outlines[k], false) < 0.01e-3);
      }
    }
  }

  TEST_CASE("rotating members have an arrow in their direction, the fixed one has a word") {
    Input in = set_of(24, 30, 3);
    const auto figure = figure_of(in);
    const auto& view = drawing_of(figure).views[0];
    REQUIRE(view.turns.size() == 3);  // sun, planet, carrier
    CHECK(view.turns[0].counter_clockwise);
    CHECK_FALSE(view.turns[1].counter_clockwise);
    CHECK(view.turns[2].counter_clockwise);
    const std::string text = draw::svg(figure);
    CHECK(says(text, "at rest"));
    CHECK(says(text, "nc = 322.2 rpm"));
    CHECK(overlap(text) == "");
  }

  TEST_CASE("without a module the figure has no scale and no CAD drawing") {
    Input in = set_of(24, 30, 3);
    CHECK(draw::is_to_scale(figure_of(in)));
    in.m_n = unset<Length>;
    CHECK_FALSE(draw::is_to_scale(figure_of(in)));
    CHECK(draw::dxf_of(figure_of(in)).empty());
  }

  TEST_CASE("unusual sets: one planet, fine teeth, a ring gear made coaxial by shift, one that cannot mesh") {
    figure_of(set_of(24, 30, 1));
    figure_of(set_of(240, 300, 3));
    Input shifted = set_of(24, 30, 3);
    shifted.z_r = 85, shifted.x_p = 0.3;
    figure_of(shifted);
    Input none = set_of(24, 30, 3);
    none.z_r = 140;
    CHECK(gear::Planetary::figures(none, test::evaluated<gear::Planetary>(none)).empty());
  }
}
