// Slots and linear drivers against a second formulation of the same mechanism.
#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

void check_near(double mine, double other, double scale) { CHECK(std::abs(mine - other) <= 1e-11 * scale); }

// The closed form of the crank's angle when the piston of the slider-crank drives.
double crank_angle(double x) { return std::acos((x * x + 0.1 * 0.1 - 0.3 * 0.3) / (2.0 * 0.1 * x)); }

// The boom's angle by the law of cosines, for the length of the cylinder.
double boom_angle(double cylinder) {
  const double foot = std::hypot(0.7, 0.5);
  const double head = std::hypot(1.2, 0.05);
  const double between = std::acos((foot * foot + head * head - cylinder * cylinder) / (2.0 * foot * head));
  return between + std::atan2(-0.5, 0.7) - std::atan2(-0.05, 1.2);
}

// Value, first and second derivative by central differences of fourth order.
template <class Function>
std::array<double, 3> derivatives(Function f, double x, double h) {
  const double m2 = f(x - 2.0 * h), m1 = f(x - h), c = f(x), p1 = f(x + h), p2 = f(x + 2.0 * h);
  return {c, (m2 - 8.0 * m1 + 8.0 * p1 - p2) / (12.0 * h),
          (-m2 + 16.0 * m1 - 30.0 * c + 16.0 * p1 - p2) / (12.0 * h * h)};
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("a slot equals a massless slider with a pin, over the full revolution") {
    const Model plain = slot_on_a_moving_link(false);
    const Model detailed = slot_on_a_moving_link(true);
    WholeSystem slot_system(plain);
    WholeSystem slider_system(detailed);
    REQUIRE(slot_system.assemble() == Status::closed);
    REQUIRE(slider_system.assemble() == Status::closed);
    Position a = slot_system.blank();
    Position b = slider_system.blank();
    for (int k = 0; k < 8; ++k) {
      const Drive drive{0.4 + 0.05 * k, 12.0, -40.0};
      REQUIRE(slot_system.solve({&drive, 1}, a) == Status::closed);
      REQUIRE(slider_system.solve({&drive, 1}, b) == Status::closed);
      for (std::size_t link = 0; link < plain.links.size(); ++link) {
        check_near(a.pose[link].phi, b.pose[link].phi, 1.0);
        check_near(a.velocity[link].phi, b.velocity[link].phi, 12.0);
        check_near(a.acceleration[link].phi, b.acceleration[link].phi, 1000.0);
        check_near(a.acceleration[link].x, b.acceleration[link].x, 1000.0);
      }
      for (std::size_t joint = 0; joint < plain.joints.size(); ++joint) {
        check_near(a.reactions[joint].force.x, b.reactions[joint].force.x, 1000.0);
        check_near(a.reactions[joint].force.y, b.reactions[joint].force.y, 1000.0);
      }
      check_near(b.reactions.back().couple, 0.0, 1000.0);
      check_near(a.effort[0], b.effort[0], 1000.0);
    }
  }

  TEST_CASE("a slot pushes perpendicular to its line only") {
    const Solved solved = solve(slotted_lever(), {{0.9, 45.0, 0.0}});
    REQUIRE(solved.status == Status::closed);
    const double phi = solved.at.pose[1].phi;
    const Vec force = solved.at.reactions[2].force;
    CHECK(std::abs(dot(force, {std::cos(phi), std::sin(phi)})) <= 1e-12 * length(force));
    CHECK(solved.at.reactions[2].couple == 0.0);
  }

  TEST_CASE("a driving piston gives the crank the motion of the closed form") {
    const double speed = 0.7;
    const double acceleration = -2.0;
    for (const double x : {0.25, 0.3, 0.34, 0.38}) {
      const Solved solved = solve(driven_piston(), {{x + 0.05, speed, acceleration}});
      REQUIRE(solved.status == Status::closed);
      const auto [phi, first, second] = derivatives(crank_angle, x, 1e-3 * (0.4 - x));
      CHECK(solved.at.pose[0].phi == doctest::Approx(phi).epsilon(1e-13));
      CHECK(solved.at.velocity[0].phi == doctest::Approx(first * speed).epsilon(1e-8));
      CHECK(solved.at.acceleration[0].phi ==
            doctest::Approx(second * speed * speed + first * acceleration).epsilon(1e-6));
    }
  }

  TEST_CASE("a swinging cylinder gives the boom the motion of the closed form") {
    const double speed = 0.3;
    const double acceleration = 0.8;
    for (const double cylinder : {0.75, 0.9, 1.1, 1.3}) {
      const Solved solved = solve(boom(), {{cylinder, speed, acceleration}});
      REQUIRE(solved.status == Status::closed);
      const auto [phi, first, second] = derivatives(boom_angle, cylinder, 1e-3);
      CHECK(solved.at.pose[0].phi == doctest::Approx(phi).epsilon(1e-13));
      CHECK(solved.at.velocity[0].phi == doctest::Approx(first * speed).epsilon(1e-8));
      CHECK(solved.at.acceleration[0].phi ==
            doctest::Approx(second * speed * speed + first * acceleration).epsilon(1e-6));
    }
  }

  TEST_CASE("the force of a cylinder follows from virtual power") {
    const double cylinder = 1.0;
    const Solved solved = solve(boom(), {{cylinder, 0.0, 0.0}});
    REQUIRE(solved.status == Status::closed);
    const Model model = boom();
    const auto potential = [&](double length_of_cylinder) {
      const Solved at = solve(model, {{length_of_cylinder, 0.0, 0.0}});
      double energy = 0.0;
      for (std::size_t k = 0; k < model.links.size(); ++k) {
        energy += model.links[k].mass * 9.81 * (at.at.pose[k].y + turn(at.at.pose[k].phi)(model.links[k].centre).y);
      }
      return energy + 2000.0 * turn(at.at.pose[0].phi)({2.4, 0.0}).y;
    };
    CHECK(solved.at.effort[0] == doctest::Approx(derivatives(potential, cylinder, 1e-3)[1]).epsilon(1e-9));
  }

  TEST_CASE("equilibrium and power balance hold with slots and cylinders in motion") {
    const struct {
      Model model;
      Drive drive;
    } rows[] = {{slot_on_a_moving_link(false), {0.6, 12.0, -40.0}},
                {slot_on_a_moving_link(true), {0.6, 12.0, -40.0}},
                {driven_piston(), {0.38, 0.7, 3.0}},
                {boom(), {1.0, 0.3, 0.8}}};
    for (const auto& [model, drive] : rows) {
      const Solved solved = solve(model, {drive});
      REQUIRE(solved.status == Status::closed);
      CHECK(solved.left.force <= 1e-10);
      CHECK(solved.left.moment <= 1e-10);
      CHECK(std::abs(solved.left.power) <= 1e-12 * solved.left.power_scale);
    }
  }

  TEST_CASE("a linear driver in a slot pushes along the slot") {
    Model model;
    const int block = add_link(model, "block", {0.3, 0.0, 0.0}, 2.0, 0.1);
    const int lever = add_link(model, "lever", {0.0, 0.0, 0.5}, 1.0, 0.05, {0.2, 0.0});
    pin(model, "B", lever, {}, ground, {});
    slot(model, "S", block, {}, lever, {});
    drive_turning(model, "angle", lever);
    drive_sliding(model, "reach", 1);
    drive_turning(model, "heading", block);
    load(model, "P", block, {}, {10.0, -20.0}, 0.5);
    const Solved solved = solve(model, {{0.5, 0.0, 0.0}, {0.3, 0.0, 0.0}, {0.0, 0.0, 0.0}});
    REQUIRE(solved.status == Status::closed);
    const Vec line{std::cos(0.5), std::sin(0.5)};
    CHECK(solved.at.effort[1] == doctest::Approx(-dot({10.0, -20.0}, line)).epsilon(1e-12));
    CHECK(solved.at.effort[2] == doctest::Approx(-0.5).epsilon(1e-12));
    CHECK(length(solved.at.reactions[1].force - (-dot({10.0, -20.0}, normal(line))) * normal(line)) < 1e-12);
  }
}
