// Technical mechanics (in Bulgarian), chapter 29: plane motion of a body, its instantaneous centre.
#include "lib/mechanism/studies/instant_centres.hpp"

#include "lib/mechanism/model/pair.hpp"
#include "lib/mechanism/model/point_motion.hpp"
#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;
using Kind = InstantCentre::Kind;

/// One link at the origin that moves so.
Position moving(Pose velocity, Pose acceleration = {}) {
  return {{{}}, {velocity}, {acceleration}, {velocity}, {}, {}, {}};
}

void check_at(const InstantCentre& centre, Vec place) {
  REQUIRE(centre.kind == Kind::point);
  CHECK(length(centre.at - place) <= 1e-12 * (1.0 + length(place)));
}

/// A wheel of 0.35 m that rolls on the ground.
Model wheel() {
  Model model;
  const int link = add_link(model, "wheel", {0.0, 0.35, 0.0}, 1.0, 0.1);
  Joint joint;
  joint.name = "contact";
  joint.kind = JointKind::rolling_on_line;
  joint.i = link;
  joint.radius_i = 0.35;
  model.joints.push_back(joint);
  take_phases(model);
  drive_turning(model, "hand", link);
  return model;
}

/// In homogeneous coordinates; zero where there is no centre.
std::array<double, 3> homogeneous(const InstantCentre& centre) {
  if (centre.kind == Kind::point) return {centre.at.x, centre.at.y, 1.0};
  return {centre.direction.x, centre.direction.y, 0.0};
}

double determinant(std::array<double, 3> a, std::array<double, 3> b, std::array<double, 3> c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

double size_of(std::array<double, 3> a) { return std::hypot(a[0], a[1], a[2]); }

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("first case: the centre lies where the normals to two velocities meet") {
    const Solved solved = solve(four_bar(), {{1.0, 5.0, 0.0}});
    REQUIRE(solved.status == Status::closed);
    const Pose& crank = solved.at.pose[0];
    const Pose& rocker = solved.at.pose[2];
    // O + p (cos, sin of the crank) = C + q (cos, sin of the rocker)
    const Vec e{std::cos(crank.phi), std::sin(crank.phi)}, f{std::cos(rocker.phi), std::sin(rocker.phi)};
    const double p = cross({0.4, 0.0}, f) / cross(e, f);
    check_at(instant_centre(solved.at, 1, ground, 0.5), p * e);
    const double v_a = 0.1 * 5.0;
    CHECK(std::abs(solved.at.velocity[1].phi) == doctest::Approx(v_a / std::abs(p - 0.1)));
  }

  TEST_CASE("second case: two parallel velocities divide the line of their points") {
    // A at the origin with 1 m/s, B 3 m away with 2 m/s in the opposite direction, then in the same.
    check_at(instant_centre(moving({0.0, 1.0, -1.0}), 0, ground, 1.0), {1.0, 0.0});
    check_at(instant_centre(moving({0.0, 1.0, 1.0 / 3.0}), 0, ground, 1.0), {-3.0, 0.0});
  }

  TEST_CASE("equal velocities: the centre is at infinity, perpendicular to the motion") {
    const InstantCentre centre = instant_centre(moving({0.0, 2.0, 0.0}), 0, ground, 1.0);
    CHECK(centre.kind == Kind::at_infinity);
    CHECK(std::abs(cross(centre.direction, {1.0, 0.0})) <= 1e-15);
    CHECK(instant_centre(moving({}), 0, ground, 1.0).kind == Kind::at_rest);
  }

  TEST_CASE("a wheel that rolls turns about its contact, and its top is twice as fast as its centre") {
    const Solved solved = solve(wheel(), {{0.3, -4.0, 0.0}});
    REQUIRE(solved.status == Status::closed);
    const Pose& pose = solved.at.pose[0];
    check_at(instant_centre(solved.at, 0, ground, 0.35), {pose.x, 0.0});
    const double top = length(point_velocity(solved.at.velocity[0], {0.0, 0.35}));
    CHECK(top == doctest::Approx(2.0 * length(point_velocity(solved.at.velocity[0], {}))));
  }

  TEST_CASE("the centres of any three links lie on a line") {
    const Model models[] = {four_bar(), slider_crank(), six_bar(), class_three(), slot_on_a_moving_link(true)};
    for (const Model& model : models) {
      const Solved solved = solve(model, {{model.links[0].pose.phi + 0.1, 2.0, 1.0}});
      REQUIRE(solved.status == Status::closed);
      const int links = static_cast<int>(model.links.size());
      const auto centre = [&](int i, int j) { return homogeneous(instant_centre(solved.at, i, j, 0.5)); };
      for (int i = 0; i < links; ++i) {
        for (int j = i + 1; j < links; ++j) {
          for (int k = j + 1; k <= links; ++k) {
            const int third = k == links ? ground : k;
            const auto a = centre(i, j), b = centre(j, third), c = centre(i, third);
            CHECK(std::abs(determinant(a, b, c)) <= 1e-10 * size_of(a) * size_of(b) * size_of(c));
          }
        }
      }
    }
  }

  TEST_CASE("every pair of links has one centre: n (n - 1) / 2 with the ground among the n") {
    const Solved solved = solve(slider_crank(), {{1.0, 2.0, 0.0}});
    REQUIRE(solved.status == Status::closed);
    const auto all = instant_centres(solved.at, 0.5);
    CHECK(all.size() == 6);
    CHECK(std::ranges::count(all, Kind::at_infinity, [](const auto& c) { return c.centre.kind; }) == 1);
  }
}
