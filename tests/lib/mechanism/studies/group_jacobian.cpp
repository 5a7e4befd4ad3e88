// The Jacobian determinant of structural groups: a printed one, closed forms of dyads, and its independence of the
// choice of the equations.
#include "lib/mechanism/studies/group_jacobian.hpp"

#include "lib/mechanism/groups/system.hpp"
#include "tests/lib/mechanism/worked_models.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

Position assembled(const Model& model) {
  GroupSystem system(model);
  Position at = blank_position(model);
  REQUIRE(system.assemble() == Status::closed);
  const Drive drive{system.coordinate(0), 0.0, 0.0};
  REQUIRE(system.solve({&drive, 1}, at, true) == Status::closed);
  return at;
}

/// Of the second group, after the initial link.
struct Jacobian {
  double magnitude = 0.0;
  int metres = 0;
};
Jacobian of_second_group(const Model& model) {
  GroupJacobians jacobians(model);
  REQUIRE(jacobians.plan().groups.size() >= 2);
  jacobians.take(assembled(model).pose);
  CHECK(jacobians.magnitude(0) == 1.0);
  return {jacobians.magnitude(1), jacobians.metres(1)};
}

}  // namespace

TEST_SUITE("mechanism jacobian of a group") {
  TEST_CASE("text D, example 2: J = -482.605 m^6 of the six-link group, by equations (5), (6) and (7)") {
    const Jacobian found = of_second_group(crank_with_six_link_group());
    CHECK(std::abs(found.magnitude - 482.605) < 5e-4);
    CHECK(found.magnitude == doctest::Approx(482.6053028146532).epsilon(1e-9));  // (7) from the exact data
    CHECK(found.metres == 6);
  }

  TEST_CASE("the order of joints, by which loops are chosen, does not change it") {
    Model model = crank_with_six_link_group();
    const double stated = of_second_group(model).magnitude;
    std::ranges::reverse(model.joints);
    CHECK(of_second_group(model).magnitude == doctest::Approx(stated).epsilon(1e-12));
    std::swap(model.joints[1], model.joints[5]);
    CHECK(of_second_group(model).magnitude == doctest::Approx(stated).epsilon(1e-12));
  }

  TEST_CASE("a dyad of three pins: l_1 l_2 sin of the angle between them") {
    const Model model = four_bar();
    const Position at = assembled(model);
    const double between = at.pose[1].phi - at.pose[2].phi;
    const Jacobian found = of_second_group(model);
    CHECK(found.magnitude == doctest::Approx(0.35 * 0.3 * std::abs(std::sin(between))).epsilon(1e-12));
    CHECK(found.metres == 2);
  }

  TEST_CASE("a rod and a slider: l cos of its angle to the guide") {
    const Model model = slider_crank();
    const Jacobian found = of_second_group(model);
    CHECK(found.magnitude == doctest::Approx(0.3 * std::cos(assembled(model).pose[1].phi)).epsilon(1e-12));
    CHECK(found.metres == 1);
  }

  TEST_CASE("a slotted lever: the distance of its pivots, as a slot or with a slider") {
    for (const bool with_slider : {false, true}) {
      const Model model = slotted_lever(with_slider);
      const Position at = assembled(model);
      const Joint& pin = *std::ranges::find(model.joints, "A", &Joint::name);
      const Joint& pivot = *std::ranges::find(model.joints, "B", &Joint::name);
      const Pose& crank = at.pose[0];
      const Vec a = Vec{crank.x, crank.y} + turn(crank.phi)(pin.i == 0 ? pin.point_i : pin.point_j);
      const Vec b = pivot.i == ground ? pivot.point_i : pivot.point_j;
      const Jacobian found = of_second_group(model);
      CHECK(found.magnitude == doctest::Approx(length(a - b)).epsilon(1e-9));
      CHECK(found.metres == 1);
    }
  }

  TEST_CASE("at a change point it is 0") {
    Model model = four_bar();
    std::ranges::find(model.joints, "A", &Joint::name)->point_j = {0.35, 0.0};
    GroupJacobians jacobians(model);
    // Crank, coupler and rocker in line: 0.35 m + 0.35 m = 0.4 m + 0.3 m.
    const std::vector<Pose> flat{{0.0, 0.0, 0.0}, {0.35, 0.0, 0.0}, {0.4, 0.0, 0.0}};
    jacobians.take(flat);
    CHECK(jacobians.magnitude(1) == 0.0);
  }
}
