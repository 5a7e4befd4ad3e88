// Springs and dampers: by hand, and invariants of every mechanism.
#include "lib/mechanism/groups/system.hpp"
#include "lib/mechanism/model/spring.hpp"
#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

/// The slider-crank with a spring from rod to ground, one between crank and piston, one that turns against the crank.
Model sprung() {
  Model model = slider_crank();
  model.springs.push_back({"a", Spring::Kind::linear, 1, ground, {0.1, 0.02}, {0.1, -0.3}, 2000.0, 0.2, 15.0});
  model.springs.push_back({"b", Spring::Kind::linear, 0, 2, {0.05, 0.0}, {0.0, 0.05}, 500.0, 0.1, 0.0});
  model.springs.push_back({"c", Spring::Kind::turning, 0, ground, {}, {}, 3.0, 0.2, 0.05});
  return model;
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("a stretched spring pulls its ends together, a damper resists their separation") {
    Model model;
    const int block = add_link(model, "block", {});
    slide(model, "guide", block, {}, ground, {});
    drive_sliding(model, "drive", 0);
    model.springs.push_back({"k", Spring::Kind::linear, block, ground, {}, {-0.3, 0.4}, 1000.0, 0.4, 20.0});
    const Solved solved = solve(model, {{0.0, 0.5, 0.0}});
    REQUIRE(solved.status == Status::closed);
    // 0.5 m long, parting with 0.6 * 0.5 m/s.
    const double effort = 1000.0 * 0.1 + 20.0 * 0.3;
    CHECK(solved.at.effort[0] == doctest::Approx(0.6 * effort));
    CHECK(spring_now(model.springs[0], solved.at).effort == doctest::Approx(effort));
  }

  TEST_CASE("a damper resists with the rate at which its ends separate, between rotating links too") {
    Model model = slider_crank();
    const double c = 15.0, dt = 1e-6, speed = 7.0;
    model.springs.push_back({"c", Spring::Kind::linear, 1, 0, {0.1, 0.02}, {0.03, -0.01}, 0.0, 0.0, c});
    WholeSystem system(model);
    REQUIRE(system.assemble() == Status::closed);
    const double start = system.coordinate(0);
    const auto at_time = [&](double t) { return solve(model, {{start + 0.4 + speed * t, speed, 0.0}}).at; };
    const auto span = [&](const Position& at) {
      const auto now = spring_now(model.springs[0], at);
      return length(now.at_i - now.at_j);
    };
    const double rate = (span(at_time(dt)) - span(at_time(-dt))) / (2.0 * dt);
    CHECK(spring_now(model.springs[0], at_time(0.0)).effort == doctest::Approx(c * rate).epsilon(1e-7));
  }

  TEST_CASE("where its ends coincide a spring has no direction, unless it has no force there") {
    Model model;
    const int block = add_link(model, "block", {});
    slide(model, "guide", block, {}, ground, {});
    const Position at = blank_position(model);
    const Spring free_length{"k", Spring::Kind::linear, block, ground, {}, {}, 1000.0, 0.4, 0.0};
    const Spring damper{"c", Spring::Kind::linear, block, ground, {}, {}, 0.0, 0.0, 20.0};
    const Spring no_length{"0", Spring::Kind::linear, block, ground, {}, {}, 1000.0, 0.0, 0.0};
    CHECK(std::isnan(spring_now(free_length, at).effort));
    CHECK(std::isnan(spring_now(free_length, at).force.x));
    CHECK(std::isnan(spring_now(damper, at).effort));
    CHECK(spring_now(no_length, at).effort == 0.0);
    CHECK(length(spring_now(no_length, at).force) == 0.0);
    model.springs = {no_length};
    CHECK_FALSE(some_spring_has_no_direction(model, at));
    model.springs.push_back(damper);
    CHECK(some_spring_has_no_direction(model, at));
  }

  TEST_CASE("with springs the links are in equilibrium, the power balances and both solvers agree") {
    const Model model = sprung();
    GroupSystem groups(model);
    WholeSystem whole(model);
    REQUIRE(groups.assemble() == Status::closed);
    REQUIRE(whole.assemble() == Status::closed);
    Position a = blank_position(model), b = a;
    for (int k = 0; k < 60; ++k) {
      const Drive drive{1.0 + 0.1 * k, 12.0, 30.0};
      REQUIRE(groups.solve({&drive, 1}, a) == Status::closed);
      REQUIRE(whole.solve({&drive, 1}, b) == Status::closed);
      CHECK(a.effort[0] == doctest::Approx(b.effort[0]).epsilon(1e-11));
      const Residuals left = residuals(model, {&drive, 1}, false, a);
      CHECK(left.force <= 1e-9);
      CHECK(left.moment <= 1e-9);
      CHECK(std::abs(left.power) <= 1e-11 * left.power_scale);
    }
  }

  TEST_CASE("over a full revolution springs return the energy they take") {
    Model model = sprung();
    for (Spring& spring : model.springs) spring.damping = 0.0;
    model.loads.clear();
    model.springs.pop_back();  // a turning spring winds up
    GroupSystem system(model);
    REQUIRE(system.assemble() == Status::closed);
    Position at = blank_position(model);
    double work = 0.0;
    for (int k = 0; k < 360; ++k) {
      const Drive drive{1.0 + k * 3.14159265358979323846 / 180.0, 12.0, 0.0};
      REQUIRE(system.solve({&drive, 1}, at) == Status::closed);
      work += at.effort[0];
    }
    CHECK(std::abs(work) <= 1e-9);
  }
}
