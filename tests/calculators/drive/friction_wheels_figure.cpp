// Friction wheels as drawn: they touch, forces balance, cones have one apex.
#include "calculators/drive/friction_wheels.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/draw/drawing/drawings.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace loadpath;
using namespace loadpath::draw::test;
using figure::Drawing;
using figure::Point;
using Wheels = drive::FrictionWheels;
using Shape = Wheels::Shape;

namespace {

Wheels::Input drawn_wheels(Shape shape, double d_2) {
  Wheels::Input in;
  in.T_1 = 30.0 * N_m, in.n_1 = 600.0 * rpm;
  in.d_1 = 200.0 * mm, in.d_2 = d_2 * mm, in.b = 60.0 * mm;
  in.mu = 0.2, in.shape = shape;
  if (shape == Shape::grooved) in.alpha = 15.0 * deg.one;
  return in;
}

figure::Figure figure_of(const Wheels::Input& in) { return Wheels::figures(in, test::evaluated<Wheels>(in)).at(0); }

Point force_of(const Drawing::View& view, std::string_view symbol) {
  for (const auto& f : view.forces) {
    if (f.value.symbol == symbol) return f.force;
  }
  FAIL("no force");
  return {};
}

}  // namespace

TEST_SUITE("friction wheels figure") {
  TEST_CASE("every dimension is true to scale, and nothing is drawn outside the frame") {
    for (const Shape shape : {Shape::cylindrical, Shape::grooved, Shape::bevel}) {
      for (const double d_2 : {100.0, 200.0, 600.0, 1500.0}) {
        CAPTURE(d_2);
        check_drawn(figure_of(drawn_wheels(shape, d_2)));
      }
    }
  }

  TEST_CASE("the wheels touch between their centres, and the force drives the other rim in its direction") {
    const auto figure = figure_of(drawn_wheels(Shape::cylindrical, 500.0));
    const auto& view = drawing_of(figure).views[0];
    CHECK(view.circles[1].centre.x == doctest::Approx(0.35));
    CHECK(view.circles[0].radius + view.circles[1].radius == doctest::Approx(0.35));
    CHECK_FALSE(view.turns[0].counter_clockwise);  // its rim moves down where it touches the other
    CHECK(view.turns[1].counter_clockwise);
    CHECK(force_of(view, "F_t").y == doctest::Approx(-300.0));  // 2 x 30 N m / 0.2 m
    CHECK(force_of(view, "F_p").x == doctest::Approx(1.5 * 300.0 / 0.2));
    CHECK(force_of(view, "F_p").x + force_of(view, "F_r2").x == doctest::Approx(0.0));
  }

  TEST_CASE("cones have one apex and share the line of contact, across which the normal force acts") {
    for (const double Sigma : {60.0, 90.0, 120.0}) {
      CAPTURE(Sigma);
      Wheels::Input in = drawn_wheels(Shape::bevel, 500.0);
      in.Sigma = Sigma * deg.one;
      const auto figure = figure_of(in);
      check_drawn(figure);
      const auto& view = drawing_of(figure).views[0];
      const auto contact = paths_of(view, Drawing::Line::contact).at(0);
      CHECK(figure::length(contact[1] - contact[0]) == doctest::Approx(0.06));
      CHECK(std::fabs(figure::cross(contact[0], contact[1])) < 1e-12);
      for (const auto& area : view.areas) {
        for (const Point p : contact) CHECK(distance_to(p, area.outline) < 1e-12);
      }
      CHECK(std::fabs(figure::dot(force_of(view, "F_n"), contact[1])) < 1e-9);
      CHECK(view.angles[0].sweep + view.angles[1].sweep == doctest::Approx(in.Sigma));
    }
  }

  TEST_CASE("the flanks of a ridge touch the groove over b, at the angle of the groove") {
    const auto figure = figure_of(drawn_wheels(Shape::grooved, 500.0));
    const auto& view = drawing_of(figure).views[1];
    const auto flanks = paths_of(view, Drawing::Line::contact);
    REQUIRE(flanks.size() == 2);
    for (const auto& flank : flanks) {
      const Point along = flank[1] - flank[0];
      CHECK(figure::length(along) == doctest::Approx(0.06));
      CHECK(std::atan2(std::fabs(along.x), along.y) * 180.0 / pi == doctest::Approx(15.0));
    }
  }
}
