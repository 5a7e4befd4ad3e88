// Mechanisms whose joints hold more than is needed: what is unique is found, what is not is named.
#include "lib/mechanism/groups/released_system.hpp"
#include "lib/mechanism/proof/proof.hpp"
#include "lib/mechanism/structure/release.hpp"
#include "lib/mechanism/structure/structure.hpp"
#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

namespace {

constexpr double r = 0.2;  // m, of the cranks

// A heavy coupler on parallel cranks whose feet are these.
Model parallel_cranks(std::span<const Vec> feet, double angle) {
  Model model;
  const Vec tip = turn(angle)({r, 0.0});
  const int coupler = add_link(model, "coupler", {tip.x, tip.y, 0.0}, 3.0, 0.02, {0.1, 0.05});
  for (std::size_t k = 0; k < feet.size(); ++k) {
    const std::string name = std::to_string(k + 1);
    const int crank = add_link(model, "crank" + name, {feet[k].x, feet[k].y, angle});
    pin(model, "O" + name, crank, {}, ground, feet[k]);
    pin(model, "A" + name, coupler, feet[k], crank, {r, 0.0});
  }
  drive_turning(model, "motor", 1);
  load(model, "push", coupler, {0.5, 0.3}, {-40.0, 25.0});
  model.gravity = {0.0, -9.81};
  return model;
}

constexpr std::array<Vec, 3> in_a_triangle{Vec{0.0, 0.0}, Vec{0.3, 0.0}, Vec{0.1, 0.2}};

// By the powers: the coupler does not turn, each of its points goes round with the radius r.
double effort_of_the_powers(double angle, double omega) {
  const Vec weight{0.0, -3.0 * 9.81}, push{-40.0, 25.0};
  const Vec velocity = omega * r * Vec{-std::sin(angle), std::cos(angle)};
  return -dot(weight + push, velocity) / omega;  // the inertia force points outward, across the velocity
}

}  // namespace

TEST_SUITE("mechanism held too much") {
  TEST_CASE("three parallel cranks: all is solved, the drive is unique, no pin is") {
    const Model model = parallel_cranks(in_a_triangle, 1.1);
    Structure structure;
    REQUIRE(diagnose(model, structure).empty());
    CHECK(structure.redundant.size() == 1);
    CHECK(structure.mobility == 1);
    for (const Uniqueness& unique : uniqueness(model)) CHECK_FALSE(unique.force);
  }

  TEST_CASE("a third crank out of line carries a parallelogram over its change points") {
    const Model model = parallel_cranks(in_a_triangle, 1.1);
    ReleasedSystem system(model, true);
    REQUIRE(system.assemble() == Status::closed);
    Position at = blank_position(model);
    for (int k = 0; k <= 720; ++k) {
      const double angle = std::numbers::pi / 180.0 * k;  // 0, 180 and 360 degrees among them
      const std::array drives{Drive{angle, 5.0, 0.0}};
      CAPTURE(k);
      REQUIRE(system.solve(drives, at) == Status::closed);
      CHECK(std::abs(at.pose[0].phi) < 1e-12);
      CHECK(at.velocity[0].phi == doctest::Approx(0.0).epsilon(1e-12));
      CHECK(at.effort[0] == doctest::Approx(effort_of_the_powers(angle, 5.0)).epsilon(1e-10));
      Prover prover(system.model());
      CHECK(prover.prove(drives, false, at).trustworthy());
    }
  }

  TEST_CASE("it passes them in one long move as well") {
    const Model model = parallel_cranks(in_a_triangle, 1.1);
    ReleasedSystem system(model, true);
    REQUIRE(system.assemble() == Status::closed);
    Position at = blank_position(model);
    REQUIRE(system.solve(std::array{Drive{5.9, 5.0, 0.0}}, at) == Status::closed);
    CHECK(std::abs(at.pose[0].phi) < 1e-12);
    CHECK(at.pose[3].phi == doctest::Approx(5.9));
  }

  TEST_CASE("a press between two columns: what the columns share is not unique, everything else is") {
    Model model = slider_crank();
    slide(model, "column", 2, {0.0, 0.1}, ground, {0.0, 0.1});
    load(model, "work", 2, {0.0, 0.02}, {-1000.0, 0.0});
    Model alone = model;
    alone.joints.pop_back();
    Structure structure;
    REQUIRE(diagnose(model, structure).empty());
    CHECK(structure.redundant.size() == 2);
    const auto unique = uniqueness(model);
    for (std::size_t k = 0; k < 3; ++k) CHECK((unique[k].force && unique[k].couple));
    for (std::size_t k = 3; k < 5; ++k) CHECK_FALSE((unique[k].force || unique[k].couple));

    GroupSystem of_one(alone);
    ReleasedSystem of_both(model, true);
    REQUIRE(of_one.assemble() == Status::closed);
    REQUIRE(of_both.assemble() == Status::closed);
    Position one = blank_position(alone), both = blank_position(model);
    for (int k = 0; k < 24; ++k) {
      const std::array drives{Drive{1.0 + 0.25 * k, 10.0, 0.0}};
      REQUIRE(of_one.solve(drives, one) == Status::closed);
      REQUIRE(of_both.solve(drives, both) == Status::closed);
      CHECK(both.effort[0] == doctest::Approx(one.effort[0]).epsilon(1e-10));
      for (std::size_t n = 0; n < 3; ++n)
        CHECK(length(both.reactions[n].force - one.reactions[n].force) < 1e-9 * length(one.reactions[n].force));
      CHECK(both.reactions[3].force.y + both.reactions[4].force.y == doctest::Approx(one.reactions[3].force.y));
    }
  }

  TEST_CASE("friction on a non-unique reaction is refused with its joint") {
    Model model = parallel_cranks(in_a_triangle, 1.1);
    model.joints[2].friction = {.coefficient = 0.1, .pin_radius = 0.01};
    const auto findings = diagnose(model);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].index == 2);
    CHECK(findings[0].message.text().starts_with("friction, tooth or belt forces of joint 'O2'"));
  }

  TEST_CASE("two parallel pairs of gears share the moment in any proportion") {
    Model model;
    const int a = add_link(model, "a", {0.0, 0.0, 0.0}, 1.0, 0.01);
    const int b = add_link(model, "b", {0.3, 0.0, 0.0}, 1.0, 0.01);
    pin(model, "A", a, {}, ground, {});
    pin(model, "B", b, {}, ground, {0.3, 0.0});
    for (const char* name : {"left", "right"}) {
      Joint gear{name, JointKind::gear, a, b, {}, {0.0, 0.0}};
      gear.radius_i = 0.1;
      gear.radius_j = 0.2;
      model.joints.push_back(gear);
    }
    take_phases(model);
    drive_turning(model, "motor", a);
    load(model, "brake", b, {}, {}, 6.0);
    REQUIRE(diagnose(model).empty());
    const auto unique = uniqueness(model);
    CHECK(unique[0].force);
    CHECK_FALSE(unique[2].force);
    CHECK_FALSE(unique[3].force);
    ReleasedSystem system(model, true);
    REQUIRE(system.assemble() == Status::closed);
    Position at = blank_position(model);
    REQUIRE(system.solve(std::array{Drive{0.4, 3.0, 0.0}}, at) == Status::closed);
    CHECK(at.effort[0] == doctest::Approx(3.0));  // half the moment, at twice the speed and in the opposite direction
    CHECK(length(at.reactions[0].force) == doctest::Approx(30.0));  // 3 N m at 0.1 m
  }
}
