// Friction in joints: textbook cases by hand, and invariants of every mechanism with friction.
#include "lib/mechanism/forces/induced.hpp"
#include "lib/mechanism/forces/mixed_friction.hpp"
#include "lib/mechanism/groups/system.hpp"
#include "tests/lib/mechanism/cam_models.hpp"
#include "tests/lib/mechanism/models.hpp"
#include "tests/lib/mechanism/proof/methods.hpp"
#include "tests/lib/mechanism/wheel_models.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

template <class System>
Status solve_by(const Model& model, std::vector<Drive> drives, Position& at, bool statics = false) {
  System system(model);
  at = blank_position(model);
  const Status status = system.assemble();
  return status == Status::closed ? system.solve(drives, at, statics) : status;
}

Position position_of(const Model& model, std::vector<Drive> drives, bool statics = false) {
  Position at;
  REQUIRE(solve_by<GroupSystem>(model, std::move(drives), at, statics) == Status::closed);
  return at;
}

/// A block in a horizontal guide, pulled by a drive against a load of 100 N whose line is `height` above the middle.
Model drawer(double height, double coefficient) {
  Model model;
  const int block = add_link(model, "block", {});
  slide(model, "guide", block, {}, ground, {});
  model.joints[0].guide_length = 0.2;
  model.joints[0].friction.coefficient = coefficient;
  drive_sliding(model, "pull", 0);
  load(model, "resistance", block, {0.0, height}, {-100.0, 0.0});
  return model;
}

Model rubbing_lever(double coefficient) {
  Model model = slotted_lever();
  for (Joint& joint : model.joints) {
    joint.friction.coefficient = coefficient;
    joint.friction.pin_radius = 0.008;
  }
  return model;
}

/// The power that a joint's force takes out of the motion.
double loss(const Model& model, const Position& at, std::size_t k) {
  const Joint& joint = model.joints[k];
  const Reaction& r = at.reactions[k];
  const auto power = [&](int link, double sense) {
    if (link == ground) return 0.0;
    const Pose &p = at.pose[static_cast<std::size_t>(link)], &v = at.velocity[static_cast<std::size_t>(link)];
    const Vec speed = Vec{v.x, v.y} + v.phi * normal(r.at - Vec{p.x, p.y});
    return sense * (dot(r.force, speed) + r.couple * v.phi);
  };
  return -power(joint.i, 1.0) - power(joint.j, -1.0);
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("a drawer is harder to pull the farther the load lies from its middle, and jams at l / (2 mu)") {
    const double mu = 0.25, l = 0.2;
    for (const double part : {0.0, 0.2, 0.5, 0.9, 0.99}) {
      CAPTURE(part);
      const double h = part * l / (2.0 * mu);
      // The drive pulls in the middle: the couple 100 h rests on both edges.
      const Position at = position_of(drawer(h, mu), {{0.0, 0.1, 0.0}});
      CHECK(at.effort[0] == doctest::Approx(100.0 * (1.0 + part)).epsilon(1e-12));
    }
  }

  TEST_CASE("a block pushed off its middle jams when its own friction holds it") {
    // Pushed by a link at an arm h: the couple grows with the push. F = P / (1 - 2 mu h / l).
    const double mu = 0.25, l = 0.2;
    const auto pushed = [&](double h) {
      Model model;
      const int block = add_link(model, "block", {});
      const int rod = add_link(model, "rod", {-0.3, h, 0.0});
      slide(model, "guide", block, {}, ground, {});
      slide(model, "rail", rod, {}, ground, {0.0, h});
      slot(model, "push", block, {-0.1, h}, rod, {0.2, 0.0}, 1.5707963267948966);
      model.joints[0].guide_length = l;
      model.joints[0].friction.coefficient = mu;
      drive_sliding(model, "drive", 1);
      load(model, "resistance", block, {}, {-100.0, 0.0});
      return model;
    };
    const double limit = l / (2.0 * mu);
    for (const double part : {0.1, 0.5, 0.9, 0.99}) {
      CAPTURE(part);
      Position at;
      REQUIRE(solve_by<GroupSystem>(pushed(part * limit), {{-0.3, 0.1, 0.0}}, at) == Status::closed);
      CHECK(at.effort[0] == doctest::Approx(100.0 / (1.0 - part)).epsilon(1e-9));
    }
    for (const double part : {1.01, 1.5, 4.0}) {
      CAPTURE(part);
      Position at;
      CHECK(solve_by<GroupSystem>(pushed(part * limit), {{-0.3, 0.1, 0.0}}, at) == Status::jams);
      CHECK(solve_by<WholeSystem>(pushed(part * limit), {{-0.3, 0.1, 0.0}}, at) == Status::jams);
    }
  }

  TEST_CASE("a loaded pin resists with mu r F") {
    Model model;
    const int wheel = add_link(model, "wheel", {});
    pin(model, "O", wheel, {}, ground, {});
    model.joints[0].friction = {.coefficient = 0.12, .pin_radius = 0.02, .rolling_arm = 0.0, .viscous = 0.5};
    drive_turning(model, "motor", wheel);
    load(model, "belt", wheel, {}, {300.0, -400.0});
    CHECK(position_of(model, {{0.3, 2.0, 0.0}}).effort[0] == doctest::Approx(0.12 * 0.02 * 500.0 + 0.5 * 2.0));
    CHECK(position_of(model, {{0.3, -2.0, 0.0}}).effort[0] == doctest::Approx(-0.12 * 0.02 * 500.0 - 0.5 * 2.0));
    CHECK(position_of(model, {{0.3, 0.0, 0.0}}).effort[0] == doctest::Approx(0.0));
  }

  TEST_CASE("mixed friction falls from the coefficient at rest to that of fast sliding") {
    const Friction friction{.coefficient = 0.1, .rise = 2.0, .stribeck_speed = 0.2, .stribeck_exponent = 2.0};
    CHECK(coefficient_at(friction, 0.0) == doctest::Approx(0.3).epsilon(1e-15));
    CHECK(coefficient_at(friction, 0.1) == doctest::Approx(0.255760156614281).epsilon(1e-13));
    CHECK(coefficient_at(friction, -0.1) == coefficient_at(friction, 0.1));
    CHECK(coefficient_at(friction, 1e3) == 0.1);
    CHECK(coefficient_at(friction, 1e300) == 0.1);
    const Friction exponential{.coefficient = 0.1, .rise = 2.0, .stribeck_speed = 0.2, .stribeck_exponent = 1.0};
    CHECK(coefficient_at(exponential, 0.2) == doctest::Approx(0.1 + 0.2 * std::exp(-1.0)).epsilon(1e-15));
    CHECK(coefficient_at(Friction{.coefficient = 0.1}, 0.1) == 0.1);
  }

  TEST_CASE("the derivative of mixed friction by the speed is that of the curve") {
    using loadpath::numerics::Dual;
    BasicFriction<Dual> friction;
    friction.coefficient = 0.1;
    friction.rise = 2.0, friction.stribeck_speed = 0.2;
    Dual speed = -0.1;
    speed.d[0] = 1.0;
    const Dual mu = coefficient_at(friction, speed);
    CHECK(mu.value == doctest::Approx(0.255760156614281).epsilon(1e-13));
    // 0.2 exp(-(v/0.2)^2) (-2 v/0.04) at v = -0.1
    CHECK(mu.d[0] == doctest::Approx(0.2 * std::exp(-0.25) * 5.0).epsilon(1e-13));
    CHECK(coefficient_at(friction, Dual{0.0}).d[0] == 0.0);
  }

  TEST_CASE("a slide and a pin resist with the coefficient at their sliding speed") {
    Model block;
    slide(block, "guide", add_link(block, "block", {}), {}, ground, {});
    block.joints[0].friction = {.coefficient = 0.1, .viscous = 40.0, .rise = 2.0, .stribeck_speed = 0.2};
    drive_sliding(block, "pull", 0);
    load(block, "weight", 0, {}, {0.0, -200.0});
    const double sliding = 0.255760156614281 * 200.0;
    CHECK(position_of(block, {{0.0, 0.1, 0.0}}).effort[0] == doctest::Approx(sliding + 4.0).epsilon(1e-12));
    CHECK(position_of(block, {{0.0, -0.1, 0.0}}).effort[0] == doctest::Approx(-sliding - 4.0).epsilon(1e-12));

    Model wheel;
    pin(wheel, "O", add_link(wheel, "wheel", {}), {}, ground, {});
    wheel.joints[0].friction = {.coefficient = 0.1, .pin_radius = 0.02, .rise = 2.0, .stribeck_speed = 0.2};
    drive_turning(wheel, "motor", 0);
    load(wheel, "belt", 0, {}, {300.0, -400.0});
    const double turning = 0.255760156614281 * 0.02 * 500.0;  // 5 rad/s at 20 mm: 0.1 m/s
    CHECK(position_of(wheel, {{0.3, 5.0, 0.0}}).effort[0] == doctest::Approx(turning).epsilon(1e-12));
  }

  TEST_CASE("all proofs agree with mixed friction in every joint") {
    Model model = rubbing_slider_crank(0.1);
    for (Joint& joint : model.joints) {
      joint.friction.rise = 1.5, joint.friction.stribeck_speed = 0.5;
    }
    for (const double speed : {30.0, -3.0, 0.1}) {
      const std::vector<Drive> drives{{1.0, speed, 0.0}};
      Position at = position_of(model, drives);
      Prover prover(model);
      check_trustworthy(prover.prove(drives, false, at));
    }
  }

  TEST_CASE("friction takes power from every joint that moves, whichever way the drive turns") {
    for (const Model& model : {rubbing_slider_crank(0.15), rubbing_lever(0.1)}) {
      for (const double speed : {30.0, -30.0}) {
        GroupSystem groups(model);
        WholeSystem whole(model);
        REQUIRE(groups.assemble() == Status::closed);
        REQUIRE(whole.assemble() == Status::closed);
        Position at = blank_position(model), other = at;
        for (int k = 0; k < 72; ++k) {
          CAPTURE(k);
          const Drive drive{groups.coordinate(0) + 0.087, speed, 0.0};
          REQUIRE(groups.solve({&drive, 1}, at) == Status::closed);
          REQUIRE(whole.solve({&drive, 1}, other) == Status::closed);
          CHECK(at.effort[0] == doctest::Approx(other.effort[0]).epsilon(1e-10));
          double lost = 0.0;
          for (std::size_t j = 0; j < model.joints.size(); ++j) {
            CAPTURE(model.joints[j].name);
            CHECK(loss(model, at, j) >= -1e-9);
            lost += loss(model, at, j);
          }
          CHECK(lost > 0.0);
          const Residuals left = residuals(model, {&drive, 1}, false, at);
          CHECK(left.force <= 1e-9);
          CHECK(left.moment <= 1e-9);
          CHECK(std::abs(left.power) <= 1e-11 * left.power_scale);
        }
      }
    }
  }

  TEST_CASE("viscous friction takes power from every joint that moves, and the drive supplies it") {
    for (Model model : {slider_crank(), slotted_lever(), cam_with_roller(), rolling_wheel()}) {
      const std::vector<Drive> drives{{1.0, 30.0, 0.0}};
      const double without = position_of(model, drives).effort[0];
      for (Joint& joint : model.joints) joint.friction = {.pin_radius = 0.008, .viscous = 0.3};
      const Position at = position_of(model, drives);
      double lost = 0.0;
      for (std::size_t j = 0; j < model.joints.size(); ++j) {
        CAPTURE(model.joints[j].name);
        CHECK(loss(model, at, j) >= -1e-9);
        lost += loss(model, at, j);
      }
      CHECK(lost > 0.0);
      CHECK(30.0 * (at.effort[0] - without) == doctest::Approx(lost).epsilon(1e-9));
    }
  }

  TEST_CASE("all proofs agree with friction in every joint, and detect an effort without it") {
    for (const Model& model : {rubbing_slider_crank(0.15), rubbing_lever(0.1), drawer(0.1, 0.25)}) {
      const std::vector<Drive> drives{{1.0, 30.0, 0.0}};
      Position at = position_of(model, drives);
      Prover prover(model);
      check_trustworthy(prover.prove(drives, false, at));
      at.effort[0] *= 0.9;
      CHECK_FALSE(prover.prove(drives, false, at).trustworthy());
    }
  }

  TEST_CASE("without friction nothing changes, and little friction changes little") {
    const Drive drive{1.0, 30.0, 0.0};
    const Position none = position_of(slider_crank(), {drive}), zero = position_of(rubbing_slider_crank(0.0), {drive});
    CHECK(none.effort[0] == zero.effort[0]);
    const double first = position_of(rubbing_slider_crank(1e-4), {drive}).effort[0] - none.effort[0];
    const double second = position_of(rubbing_slider_crank(2e-4), {drive}).effort[0] - none.effort[0];
    CHECK(first > 0.0);
    CHECK(second == doctest::Approx(2.0 * first).epsilon(1e-3));
  }

  TEST_CASE("forces are solved once without friction, once with each friction, and once with all") {
    const Model model = rubbing_lever(0.1);
    Position at = position_of(model, {{0.5, 10.0, 0.0}});
    InducedForces induced(model);
    std::size_t solutions = 0;
    const auto find_forces = [&](const Induced& with) {
      ++solutions;
      for (Reaction& reaction : at.reactions) reaction = {.at = {}, .force = {100.0, -50.0}};
      for (std::size_t m = 0; m < with.modes.size(); ++m)
        at.reactions[with.modes[m].joint].force.x += 0.1 * with.amounts[m];
    };
    CHECK(induced.solve(at, find_forces));
    CHECK(solutions == induced.found().modes.size() + 2);
  }
}
