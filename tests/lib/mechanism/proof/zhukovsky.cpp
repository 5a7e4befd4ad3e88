#include "lib/mechanism/proof/zhukovsky.hpp"

#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

void check_near(Vec mine, Vec other, double scale) { CHECK(length(mine - other) <= 1e-13 * scale); }

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("in the lever of a crank mechanism the crank is its own image") {
    const Model model = slider_crank();
    const Solved solved = solve(model, {{1.1, 15.0, 0.0}});
    REQUIRE(solved.status == Status::closed);
    Instant instant(model);
    instant.take(solved.at, false);
    const Vec crank = turn(solved.at.pose[0].phi)({0.1, 0.0});
    check_near(image(instant, 0, 0, crank), crank, 0.1);
    check_near(image(instant, 0, 1, {}), crank, 0.1);
    // The piston runs along x: its image is on the y axis, as far from the pole as it moves per radian.
    const Vec piston = image(instant, 0, 2, {});
    check_near(piston, {0.0, -solved.at.velocity[2].x / 15.0}, 0.1);
  }

  TEST_CASE("the forces on the lever, with their arms, balance the driving moment") {
    const Model model = slider_crank();
    const Solved solved = solve(model, {{1.1, 15.0, 40.0}});
    REQUIRE(solved.status == Status::closed);
    Instant instant(model);
    instant.take(solved.at, false);
    ZhukovskyLever lever;
    find_lever(instant, 0, lever);
    double moment = lever.effort, pairs = 0.0;
    for (const auto& f : lever.forces) {
      CHECK(f.arm * length(f.force) == doctest::Approx(cross(f.image, f.force)).epsilon(1e-12));
      moment += cross(f.image, f.force);
      pairs += f.of_couple ? 1.0 : 0.0;
    }
    CHECK(lever.effort == doctest::Approx(solved.at.effort[0]).epsilon(1e-12));
    CHECK(std::abs(moment) <= 1e-12 * std::abs(lever.effort));
    CHECK(lever.forces.size() == 3 + 3 + 1 + 4);  // weights, inertia, gas; the couples of crank and rod as pairs
    CHECK(pairs == 4.0);
  }
}
