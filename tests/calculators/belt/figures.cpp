// Drives as drawn: the belt touches both pulleys, wraps and forces are those computed.
#include "calculators/belt/figures.hpp"

#include "calculators/belt/course.hpp"
#include "calculators/belt/flat.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/draw/drawing/drawings.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace loadpath;
using namespace loadpath::draw::test;
using belt::TwoWheels;
using figure::Drawing;
using figure::Point;

namespace {

belt::Flat::Input fan() {
  belt::Flat::Input in;
  in.P = 15.0 * kW, in.n_1 = 1450.0 * rpm;
  in.d_1 = 200.0 * mm, in.d_2 = 500.0 * mm, in.a = 1200.0 * mm;
  in.mu = 0.4, in.delta = 2.5 * mm;
  in.rho = 1100.0 * kg_per_m3, in.sigma_adm = 6.0 * MPa;
  return in;
}

figure::Figure figure_of(const belt::Flat::Input& in) {
  return belt::Flat::figures(in, test::evaluated<belt::Flat>(in)).at(0);
}

constexpr double pairs[][3] = {{200, 500, 1200}, {200, 200, 300}, {500, 200, 800}, {60, 1000, 560}, {100, 101, 5000}};

TwoWheels wheels(const double (&sizes)[3], bool crossed) {
  TwoWheels w;
  w.d_1 = 1e-3 * sizes[0], w.d_2 = 1e-3 * sizes[1], w.a = 1e-3 * sizes[2], w.crossed = crossed;
  return w;
}

}  // namespace

TEST_SUITE("belt figures") {
  TEST_CASE("both spans are tangent to both pulleys, open and crossed") {
    for (const auto& sizes : pairs) {
      for (const bool crossed : {false, true}) {
        const TwoWheels w = wheels(sizes, crossed);
        if (crossed && w.a < 0.5 * (w.d_1 + w.d_2)) continue;
        for (const auto& span : belt::spans_of(w)) {
          const Point e{std::cos(span.direction), std::sin(span.direction)};
          const Point arm_1 = span.from, arm_2 = span.to - Point{w.a, 0.0};
          CHECK(figure::length(arm_1) == doctest::Approx(0.5 * w.d_1));
          CHECK(figure::length(arm_2) == doctest::Approx(0.5 * w.d_2));
          CHECK(std::fabs(figure::dot(unit(arm_1), e)) < 1e-9);
          CHECK(std::fabs(figure::dot(unit(arm_2), e)) < 1e-9);
          // On one side of an open belt, on both sides of a crossed one.
          CHECK((figure::cross(e, arm_1) * figure::cross(e, arm_2) > 0.0) == !crossed);
        }
      }
    }
  }

  TEST_CASE("the line of the belt is closed, as long as computed, and never cuts a pulley") {
    for (const auto& sizes : pairs) {
      belt::Flat::Input in = fan();
      in.d_1 = sizes[0] * mm, in.d_2 = sizes[1] * mm, in.a = sizes[2] * mm;
      for (const auto arrangement : {belt::Arrangement::open, belt::Arrangement::crossed}) {
        in.arrangement = arrangement;
        const bool crossed = arrangement == belt::Arrangement::crossed;
        if (crossed && sizes[2] < 0.5 * (sizes[0] + sizes[1])) continue;
        const auto r = test::evaluated<belt::Flat>(in);
        const auto figure = figure_of(in);
        check_drawn(figure);
        const auto line = paths_of(drawing_of(figure).views[0], Drawing::Line::belt).at(0);
        double length = 0.0;
        for (std::size_t i = 0; i < line.size(); ++i) {
          const Point to = line[(i + 1) % line.size()];
          length += figure::length(to - line[i]);
          const Point middle = 0.5 * (line[i] + to);
          CHECK(figure::length(middle) > 0.5e-3 * sizes[0] * (1.0 - 1e-3));
          CHECK(figure::length(middle - Point{1e-3 * sizes[2], 0.0}) > 0.5e-3 * sizes[1] * (1.0 - 1e-3));
        }
        CHECK(length == doctest::Approx(in_si(r.L)).epsilon(2e-4));
      }
    }
  }

  TEST_CASE("the tight span runs onto the driving pulley and has the larger pull; the shafts are pulled together") {
    const auto figure = figure_of(fan());
    const auto r = test::evaluated<belt::Flat>(fan());
    const auto& view = drawing_of(figure).views[0];
    CHECK_FALSE(view.turns[0].counter_clockwise);  // so that it draws in the belt from below
    CHECK_FALSE(view.turns[1].counter_clockwise);
    double tight = 0.0, slack = 0.0;
    for (const auto& f : view.forces) {
      if (f.value.symbol == "S_1") tight = figure::length(f.force);
      if (f.value.symbol == "S_2") slack = figure::length(f.force);
      if (f.value.symbol != "R")
        CHECK((f.at.y < 0.0) == (f.value.symbol == "S_1"));
      else
        CHECK(f.force.x * (f.at.x > 0.0 ? -1.0 : 1.0) > 0.0);
    }
    CHECK(tight == doctest::Approx(in_si(r.S_1)));
    CHECK(slack == doctest::Approx(in_si(r.S_2)));
    CHECK(tight > slack);
    belt::Flat::Input crossed = fan();
    crossed.arrangement = belt::Arrangement::crossed;
    CHECK(drawing_of(figure_of(crossed)).views[0].turns[1].counter_clockwise);
  }

  TEST_CASE("the shaft load is the sum of the pulls, as drawn") {
    belt::Flat::Input in = fan();
    in.n_1 = 10.0 * rpm, in.P = 0.1 * kW;  // slow: no tension is centrifugal
    for (const auto arrangement : {belt::Arrangement::open, belt::Arrangement::crossed}) {
      in.arrangement = arrangement;
      Point pulls, load;
      const figure::Figure figure = figure_of(in);
      for (const auto& f : drawing_of(figure).views[0].forces) {
        if (f.value.symbol == "R" && f.at.x == 0.0) load = f.force;
        if (f.value.symbol != "R") pulls = pulls + f.force;
      }
      CHECK(pulls.x == doctest::Approx(load.x).epsilon(1e-3));
      CHECK(pulls.y == doctest::Approx(load.y).epsilon(1e-2));
    }
  }

  TEST_CASE("a belt around many pulleys: its own path, the wraps, the travel of the tensioner") {
    belt::Course::Input in;
    in.n_1 = 1450.0 * rpm, in.mu = 0.5, in.L = 2360.0 * mm;
    in.turns = belt::Course::Turns::cw;
    const double places[][3] = {{0, 0, 160}, {60, 280, 80}, {300, 480, 200}, {600, 100, 250}};
    for (const auto& place : places) {
      belt::Course::Pulley p;
      p.x = place[0] * mm, p.y = place[1] * mm, p.d = place[2] * mm;
      in.pulleys.push_back(p);
    }
    in.pulleys[1].side = belt::Course::Side::outside, in.pulleys[1].along = -30.0 * deg.one;
    in.pulleys[2].P = 3.0 * kW, in.pulleys[3].P = 4.0 * kW;
    const auto figure = belt::Course::figures(in, test::evaluated<belt::Course>(in)).at(0);
    check_drawn(figure);
    const auto& view = drawing_of(figure).views[0];
    CHECK(view.names.size() == 4);
    CHECK(view.lengths.at(0).value.symbol == "s");
    // The roller on the back rotates in the opposite direction.
    CHECK(view.turns[1].counter_clockwise != view.turns[0].counter_clockwise);
  }

  TEST_CASE("what was not computed is not drawn") {
    TwoWheels w = wheels(pairs[0], false);
    const auto figure = belt::drive_figure(w, {});
    check_drawn(figure);
    CHECK(drawing_of(figure).views[0].forces.empty());
    CHECK_FALSE(drawing_of(figure).views[0].turns[0].value.has_value());
  }
}
