#include "calculators/section/polygon.hpp"

#include "calculators/section/shapes/rectangle.hpp"
#include "tests/calculators/section/sections.hpp"

#include <initializer_list>

using namespace loadpath;
using namespace loadpath::section;

namespace {

using Input = section::Polygon::Input;
using Point = std::pair<double, double>;  // mm

template <class Corners>
void put(Corners& corners, std::initializer_list<Point> points) {
  for (const auto& [y, z] : points) corners.push_back({y * mm, z * mm});
}

Input polygon(std::initializer_list<Point> points, std::initializer_list<std::initializer_list<Point>> holes = {}) {
  Input in;
  put(in.points, points);
  for (const auto& hole : holes) {
    in.holes.push_back({});
    put(in.holes.back().points, hole);
  }
  return in;
}

FieldFault fault(const Input& in) {
  for (const auto& rule : section::Polygon::rules) {
    if (!rule.holds(in)) return rule.particulars == nullptr ? FieldFault{{}, say(rule.text), {}} : rule.particulars(in);
  }
  return {};
}

}  // namespace

TEST_SUITE("section polygon") {
  TEST_CASE("a triangle of base b and height h: I = b h^3 / 36, product b^2 h^2 / 72") {
    const auto p = solve<section::Polygon>(polygon({{0, 0}, {60, 0}, {0, 90}}));
    CHECK(in_si(p.I_y) == doctest::Approx(60.0 * 90 * 90 * 90 / 36 * 1e-12).epsilon(1e-12));
    CHECK(in_si(p.I_z) == doctest::Approx(90.0 * 60 * 60 * 60 / 36 * 1e-12).epsilon(1e-12));
    CHECK(in_si(p.I_yz) == doctest::Approx(-60.0 * 60 * 90 * 90 / 72 * 1e-12).epsilon(1e-12));
    CHECK(in_si(p.y_S) == doctest::Approx(0.02).epsilon(1e-12));
    CHECK(in_si(p.z_S) == doctest::Approx(0.03).epsilon(1e-12));
  }

  TEST_CASE("neither the direction of the contour nor the first corner matters") {
    const auto p = solve<section::Polygon>(polygon({{0, 0}, {80, 0}, {80, 20}, {20, 60}, {0, 60}}));
    const auto q = solve<section::Polygon>(polygon({{20, 60}, {80, 20}, {80, 0}, {0, 0}, {0, 60}}));
    CHECK(rel(p.I_min, q.I_min) < 1e-12);
    CHECK(p.alpha == doctest::Approx(q.alpha).epsilon(1e-12));
  }

  TEST_CASE("a rotated rectangle far from the origin keeps its principal second moments") {
    Input in;
    const double turn = 0.3;
    for (const auto& [y, z] : {Point{0, 0}, {60, 0}, {60, 20}, {0, 20}}) {
      in.points.push_back({(500 + y * std::cos(turn) - z * std::sin(turn)) * mm,
                           (-300 + y * std::sin(turn) + z * std::cos(turn)) * mm});
    }
    const auto p = solve<section::Polygon>(in);
    const auto q = solve<section::Rectangle>({20.0 * mm, 60.0 * mm});
    CHECK(rel(p.I_max, q.I_max) < 1e-9);
    CHECK(rel(p.I_min, q.I_min) < 1e-9);
    CHECK(rel(p.W_max, q.W_max) < 1e-9);
    CHECK(rel(p.W_min, q.W_min) < 1e-9);
    CHECK(p.alpha == doctest::Approx(turn - 0.5 * pi).epsilon(1e-9));
  }

  TEST_CASE("a square has no product of area wherever it is, and any axis is principal") {
    const auto p = solve<section::Polygon>(polygon({{1000, 1000}, {1050, 1000}, {1050, 1050}, {1000, 1050}}));
    CHECK(in_si(p.I_yz) == 0.0);
    CHECK(rel(p.I_min, p.I_max) < 1e-9);
  }

  TEST_CASE("a hole subtracts what it would be by itself") {
    const auto p = solve<section::Polygon>(
        polygon({{0, 0}, {60, 0}, {60, 100}, {0, 100}}, {{{10, 10}, {50, 10}, {50, 90}, {10, 90}}}));
    CHECK(in_si(p.A) == doctest::Approx((60.0 * 100 - 40 * 80) * 1e-6).epsilon(1e-12));
    CHECK(in_si(p.I_y) == doctest::Approx((60e6 - 40.0 * 512e3) / 12 * 1e-12).epsilon(1e-12));
  }

  TEST_CASE("contours that cross or touch themselves, and holes that are not inside, are refused with their sides") {
    CHECK(fault(polygon({{0, 0}, {10, 0}})).message.text() == "a contour and each hole need at least three corners");
    CHECK(fault(polygon({{0, 0}, {10, 10}, {10, 0}, {0, 10}})).message.text() ==
          "sides 1 and 3 of 'points' touch or cross");
    CHECK(fault(polygon({{0, 0}, {10, 0}, {10, 0}, {0, 10}})).message.text() ==
          "sides 1 and 2 of 'points' touch or cross");
    CHECK(fault(polygon({{0, 0}, {10, 0}, {20, 0}})).message.text() == "sides 2 and 3 of 'points' touch or cross");
    const std::initializer_list<Point> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    CHECK(fault(polygon(square, {{{8, 8}, {12, 8}, {12, 12}}})).path == "holes[1]");
    CHECK(fault(polygon(square, {{{20, 20}, {30, 20}, {30, 30}}})).path == "holes[1]");
    CHECK(fault(polygon(square, {{{1, 1}, {5, 1}, {5, 5}}, {{2, 1.5}, {4, 1.5}, {4, 3}}})).path == "holes[2]");
    CHECK(fault(polygon(square, {{{1, 1}, {5, 1}, {5, 5}}, {{6, 6}, {9, 6}, {9, 9}}})).message.empty());
  }

  TEST_CASE("a corner in line with its neighbours changes nothing and is not an error") {
    const Input in = polygon({{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}});
    CHECK(fault(in).message.empty());
    CHECK(in_si(solve<section::Polygon>(in).A) == doctest::Approx(100e-6).epsilon(1e-12));
  }
}
