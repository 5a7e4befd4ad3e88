#include "lib/mechanism/studies/strokes.hpp"

#include "lib/mechanism/groups/assemblies.hpp"
#include "lib/mechanism/groups/system.hpp"
#include "lib/mechanism/studies/position_functions.hpp"
#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

constexpr double pi = std::numbers::pi;

struct Turn360 {
  std::vector<double> at;
  std::vector<Position> derivatives;
};

Turn360 turn_of(const Model& model, int positions) {
  GroupSystem system(model);
  REQUIRE(system.assemble() == Status::closed);
  PositionFunctions functions(model);
  Turn360 all;
  Position position = blank_position(model);
  for (int k = 0; k < positions; ++k) {
    all.at.push_back(system.coordinate(0) + (k == 0 ? 0.0 : 2.0 * pi / positions));
    const Drive drive{all.at.back(), 0.0, 0.0};
    REQUIRE(system.solve({&drive, 1}, position) == Status::closed);
    REQUIRE(functions.derive(position));
    all.derivatives.push_back(position);
  }
  return all;
}

std::vector<Stroke> strokes_of(const Model& model, int positions = 72) {
  const Turn360 all = turn_of(model, positions);
  return strokes(model, {all.at, 2.0 * pi, all.derivatives, std::vector<bool>(all.at.size(), true)});
}

const Stroke& stroke_of(const std::vector<Stroke>& all, Stroke::Of of, std::size_t index) {
  for (const Stroke& s : all) {
    if (s.of == of && s.index == index) return s;
  }
  FAIL("does not move");
  return all.front();
}

double modulo_turn(double angle) { return angle - 2.0 * pi * std::floor(angle / (2.0 * pi)); }

/// The piston's guide this far above the crank's axis.
Model offset_slider_crank(double e) {
  Model model = slider_crank();
  model.joints[3].point_j.y = e;
  return model;
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("the derivatives of the position functions are those of the positions, at any speed") {
    for (const Model& model : {slider_crank(), four_bar(), six_bar(), class_three(), slotted_lever()}) {
      GroupSystem system(model);
      REQUIRE(system.assemble() == Status::closed);
      const double start = system.coordinate(0), omega = 3.0, epsilon = -2.0;
      Position at = blank_position(model);
      const Drive drive{start + 0.05, omega, epsilon};
      REQUIRE(system.solve({&drive, 1}, at) == Status::closed);
      Position derived = at;
      PositionFunctions functions(model);
      REQUIRE(functions.derive(derived));
      CHECK(drive_coordinate(model, 0, at) == doctest::Approx(start + 0.05));
      for (std::size_t k = 0; k < model.links.size(); ++k) {
        const double first = derived.velocity[k].phi, second = derived.acceleration[k].phi;
        CHECK(at.velocity[k].phi == doctest::Approx(omega * first).epsilon(1e-12));
        CHECK(std::abs(at.acceleration[k].phi - second * omega * omega - first * epsilon) <= 1e-11);
        CHECK(std::abs(at.velocity[k].x - omega * derived.velocity[k].x) <= 1e-12);
      }
    }
  }

  TEST_CASE("as many assemblies close with a positive determinant as with a negative one") {
    for (const Model& model : {four_bar(), slider_crank(), slotted_lever(), class_three()}) {
      double sum = 0.0;
      for (const Assembly& assembly : assemblies(model).list) {
        Position at = blank_position(model);
        at.pose = assembly.poses;
        PositionFunctions functions(model);
        REQUIRE(functions.derive(at));
        sum += functions.sign(functions.plan().groups.size() - 1);
      }
      CHECK(sum == 0.0);
    }
  }

  TEST_CASE("a move near a change point is followed in small steps, and this is recorded") {
    GroupSystem system(four_bar());
    REQUIRE(system.assemble() == Status::closed);
    Position at = blank_position(four_bar());
    const Drive near{1.1, 0.0, 0.0}, far{3.1, 0.0, 0.0};
    REQUIRE(system.solve({&near, 1}, at) == Status::closed);
    CHECK_FALSE(system.followed_in_steps());
    REQUIRE(system.solve({&far, 1}, at) == Status::closed);
    CHECK(system.followed_in_steps());
  }

  TEST_CASE("a central slider-crank has the stroke 2 r, with equal forward and return times") {
    const auto all = strokes_of(slider_crank());
    const Stroke& piston = stroke_of(all, Stroke::Of::guide, 3);
    REQUIRE(piston.reversals.size() == 2);
    CHECK(piston.range == doctest::Approx(0.2).epsilon(1e-12));
    CHECK(piston.time_ratio == doctest::Approx(1.0).epsilon(1e-9));
    CHECK(modulo_turn(piston.reversals[0].drive) == doctest::Approx(pi));
    CHECK(piston.reversals[0].coordinate == doctest::Approx(0.2));
    CHECK(piston.reversals[1].coordinate == doctest::Approx(0.4));
    CHECK(stroke_of(all, Stroke::Of::link, 0).reversals.empty());
    CHECK(stroke_of(all, Stroke::Of::link, 0).range == doctest::Approx(2.0 * pi).epsilon(1e-12));
  }

  TEST_CASE("an offset slider-crank: extremes where crank and rod are in line") {
    const double e = 0.05;
    const auto all = strokes_of(offset_slider_crank(e), 24);
    const Stroke& piston = stroke_of(all, Stroke::Of::guide, 3);
    REQUIRE(piston.reversals.size() == 2);
    const double far = std::sqrt(0.4 * 0.4 - e * e), near = std::sqrt(0.2 * 0.2 - e * e);
    CHECK(piston.range == doctest::Approx(far - near).epsilon(1e-11));
    const double psi = std::asin(e / 0.2) - std::asin(e / 0.4);
    CHECK(piston.time_ratio == doctest::Approx((pi + psi) / (pi - psi)).epsilon(1e-9));
  }

  TEST_CASE("a rocker swings between the positions where crank and coupler are in line") {
    const auto all = strokes_of(four_bar());
    const Stroke& rocker = stroke_of(all, Stroke::Of::link, 2);
    const auto angle = [](double reach) { return std::acos((0.16 + 0.09 - reach * reach) / 0.24); };
    CHECK(rocker.reversals.size() == 2);
    CHECK(rocker.range == doctest::Approx(angle(0.45) - angle(0.25)).epsilon(1e-11));
    CHECK(rocker.time_ratio > 1.0);
  }

  TEST_CASE("a slotted lever swings by twice asin(r / d), with a quick return") {
    const double half = std::asin(0.03 / 0.09);
    const auto all = strokes_of(slotted_lever(), 360);
    const Stroke& lever = stroke_of(all, Stroke::Of::link, 1);
    CHECK(lever.range == doctest::Approx(2.0 * half).epsilon(1e-11));
    CHECK(lever.time_ratio == doctest::Approx((pi + 2.0 * half) / (pi - 2.0 * half)).epsilon(1e-9));
  }

  TEST_CASE("an extreme at a position is found once, also the first one") {
    Model model = slider_crank();
    model.links[0].pose.phi = 0.0;
    model.links[1].pose = {0.1, 0.0, 0.0};
    model.links[2].pose = {0.4, 0.0, 0.0};
    const auto all = strokes_of(model, 12);
    CHECK(stroke_of(all, Stroke::Of::guide, 3).reversals.size() == 2);
    CHECK(stroke_of(all, Stroke::Of::guide, 3).range == doctest::Approx(0.2).epsilon(1e-12));
  }

  TEST_CASE("missing positions are not interpolated") {
    const Model model = slider_crank();
    const Turn360 all = turn_of(model, 72);
    std::vector<bool> known(all.at.size(), false);
    const auto none = strokes(model, {all.at, 2.0 * pi, all.derivatives, known});
    CHECK(none.empty());
    known[0] = known[1] = known[2] = true;
    const auto few = strokes(model, {all.at, 2.0 * pi, all.derivatives, known});
    for (const Stroke& s : few) CHECK(s.reversals.empty());
  }
}
