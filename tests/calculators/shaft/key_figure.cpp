// A key as drawn: it fills its keyways as far as the standard has it, and its dimensions are true.
#include "calculators/shaft/key.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/draw/drawing/drawings.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace loadpath;
using namespace loadpath::draw::test;
using figure::Drawing;
using figure::Point;
using Key = shaft::Key;

namespace {

/// DIN 6885: a key 14x9 in a shaft of 50 mm.
Key::Input seat() {
  Key::Input in;
  in.T = 450.0 * N_m, in.torque = shaft::Sense::one_way;
  in.d = 50.0 * mm, in.b = 14.0 * mm, in.h = 9.0 * mm, in.t_1 = 5.5 * mm, in.t_2 = 3.8 * mm;
  in.l = 70.0 * mm, in.l_n = 75.0 * mm, in.R_e_1 = 370.0 * MPa, in.R_e_2 = 300.0 * MPa;
  return in;
}

figure::Figure figure_of(const Key::Input& in) { return Key::figures(in, test::evaluated<Key>(in)).at(0); }

double highest(const std::vector<Point>& points) {
  return std::max_element(points.begin(), points.end(), [](Point a, Point b) { return a.y < b.y; })->y;
}

}  // namespace

TEST_SUITE("key figure") {
  TEST_CASE("every dimension is true to scale, with one key or two, in a hollow shaft, without hub sizes") {
    Key::Input two = seat(), hollow = seat(), bare = seat(), geared = seat();
    two.i = 2;
    hollow.d_bore = 20.0 * mm;
    bare.t_2 = unset<Length>, bare.l_n = unset<Length>;
    geared.d_f = 80.0 * mm;
    for (const Key::Input& in : {seat(), two, hollow, bare, geared}) check_drawn(figure_of(in));
  }

  TEST_CASE("the key rests on the bottom of its keyway, with clearance to that of the hub") {
    const auto figure = figure_of(seat());
    const auto& view = drawing_of(figure).views[0];
    const auto& hub = view.areas[0].hole;
    const auto& key = view.areas[2].outline;
    CHECK(highest(key) == doctest::Approx(25e-3 - 5.5e-3 + 9e-3));
    CHECK(highest(hub) == doctest::Approx(25e-3 + 3.8e-3));
    CHECK(key.front().y == doctest::Approx(19.5e-3));
    CHECK(distance_to({0.0, 19.5e-3}, view.areas[1].outline) < 1e-12);
    for (const Point p : view.areas[1].outline) CHECK(figure::length(p) < 25e-3 * (1.0 + 1e-12));
  }

  TEST_CASE("the forces on the key are equal and opposite") {
    const auto figure = figure_of(seat());
    const auto& forces = drawing_of(figure).views[0].forces;
    REQUIRE(forces.size() == 2);
    CHECK(figure::length(forces[0].force) == doctest::Approx(2.0 * 450.0 / 0.05));
    CHECK(figure::length(forces[0].force + forces[1].force) < 1e-9);
    CHECK(forces[0].at.y > forces[1].at.y);  // the hub presses above the shaft
  }

  TEST_CASE("two keys have two keyways") {
    Key::Input in = seat();
    in.i = 2;
    const auto figure = figure_of(in);
    const auto& shaft = drawing_of(figure).views[0].areas[1].outline;
    CHECK(distance_to({0.0, 19.5e-3}, shaft) < 1e-12);
    CHECK(distance_to({0.0, -19.5e-3}, shaft) < 1e-12);
  }
}
