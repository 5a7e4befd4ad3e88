// Technical mechanics (in Bulgarian), chapter 31: compound motion of a point.
#include "lib/mechanism/studies/relative_motion.hpp"

#include "lib/mechanism/model/point_motion.hpp"
#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

struct Absolute {
  Vec velocity, acceleration;
};

Absolute pin_of(const Joint& joint, const Position& at) {
  if (joint.i == ground) return {};
  const auto k = static_cast<std::size_t>(joint.i);
  const Vec arm = turn(at.pose[k].phi)(joint.point_i);
  return {point_velocity(at.velocity[k], arm), point_acceleration(at.acceleration[k], at.velocity[k].phi, arm)};
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("a point that moves uniformly along a uniformly rotating body has the Coriolis acceleration 2 omega v_r") {
    const Model model = telescope();
    const double omega = 3.0, v = 0.4, xi = 0.8;
    const Solved solved = solve(model, {{0.7, omega, 0.0}, {xi, v, 0.0}});
    REQUIRE(solved.status == Status::closed);
    const RelativeMotion motion = relative_motion(model.joints[1], solved.at);
    CHECK(motion.s == doctest::Approx(xi));
    CHECK(motion.s_dot == doctest::Approx(v));
    CHECK(length(motion.a_r) <= 1e-12);
    CHECK(dot(motion.a_C, normal(motion.along)) == doctest::Approx(2.0 * omega * v));
    CHECK(std::abs(dot(motion.a_C, motion.along)) <= 1e-12);
    const double from_axis = length(Vec{xi + 0.1, 0.05});
    CHECK(length(motion.v_e) == doctest::Approx(from_axis * omega));
    CHECK(length(motion.a_e) == doctest::Approx(from_axis * omega * omega));
  }

  TEST_CASE("relative, transport and Coriolis parts add up to the absolute velocity and acceleration") {
    const Model models[] = {slotted_lever(), slotted_lever(true), slot_on_a_moving_link(false),
                            slot_on_a_moving_link(true), slider_crank()};
    for (const Model& model : models) {
      const Solved solved = solve(model, {{model.links[0].pose.phi + 0.1, 12.0, -40.0}});
      REQUIRE(solved.status == Status::closed);
      int guided = 0;
      for (const Joint& joint : model.joints) {
        if (!is_guided(joint)) continue;
        ++guided;
        const RelativeMotion m = relative_motion(joint, solved.at);
        const Absolute pin = pin_of(joint, solved.at);
        CHECK(length(m.v_r + m.v_e - pin.velocity) <= 1e-12 * (1.0 + length(pin.velocity)));
        CHECK(length(m.a_r + m.a_e + m.a_C - pin.acceleration) <= 1e-12 * (1.0 + length(pin.acceleration)) * 10.0);
      }
      CHECK(guided == 1);
    }
  }

  TEST_CASE("in a fixed guide there is neither a transport nor a Coriolis part") {
    const Model model = slider_crank();
    const Solved solved = solve(model, {{1.0, 10.0, 5.0}});
    REQUIRE(solved.status == Status::closed);
    const RelativeMotion m = relative_motion(model.joints[3], solved.at);
    CHECK(length(m.v_e) == 0.0);
    CHECK(length(m.a_e) == 0.0);
    CHECK(length(m.a_C) == 0.0);
    CHECK(m.s == doctest::Approx(solved.at.pose[2].x));
    CHECK(m.s_dot == doctest::Approx(solved.at.velocity[2].x));
    CHECK(m.s_ddot == doctest::Approx(solved.at.acceleration[2].x));
  }
}
