// Friction where its sense is not that of a motion: impending motion, self-locking, joints that rest at dead points.
#include "lib/mechanism/groups/system.hpp"
#include "tests/lib/mechanism/models.hpp"
#include "tests/lib/mechanism/proof/methods.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

constexpr double weight = 1000.0;

/// A block on a plane that rises by alpha; the drive pushes it up along the plane.
Model inclined(double alpha, double mu) {
  Model model;
  const int block = add_link(model, "block", {0.0, 0.0, alpha});
  slide(model, "plane", block, {}, ground, {}, alpha, alpha);
  model.joints[0].guide_length = 0.1;
  model.joints[0].friction.coefficient = mu;
  drive_sliding(model, "push", 0);
  load(model, "weight", block, {}, {0.0, -weight});
  return model;
}

template <class System = GroupSystem>
Position solved(const Model& model, Drive drive, bool statics = false) {
  System system(model);
  Position at = blank_position(model);
  REQUIRE(system.assemble() == Status::closed);
  REQUIRE(system.solve({&drive, 1}, at, statics) == Status::closed);
  return at;
}

double effort(const Model& model, double impending) { return solved(model, {0.0, 0.0, 0.0, impending}).effort[0]; }

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("a block on a plane: the forces that push it up and let it down, and tan alpha = mu at the slip limit") {
    const double mu = 0.3;
    for (const double alpha : {0.1, 0.25, std::atan(mu) - 1e-6, std::atan(mu) + 1e-6, 0.6, 1.2}) {
      CAPTURE(alpha);
      const Model model = inclined(alpha, mu);
      const double up = weight * (std::sin(alpha) + mu * std::cos(alpha));
      const double down = weight * (std::sin(alpha) - mu * std::cos(alpha));
      CHECK(effort(model, 1.0) == doctest::Approx(up).epsilon(1e-12));
      CHECK(effort(model, -1.0) == doctest::Approx(down).epsilon(1e-9));
      CHECK(effort(model, 0.0) == doctest::Approx(weight * std::sin(alpha)).epsilon(1e-12));
      CHECK((effort(model, -1.0) <= 0.0) == (std::tan(alpha) <= mu));
      // A self-locking block is lifted with an efficiency below one half: eta = tan(alpha) / (tan(alpha) + mu).
      const double efficiency = effort(model, 0.0) / effort(model, 1.0);
      CHECK((efficiency <= 0.5) == (effort(model, -1.0) <= 0.0));
    }
  }

  TEST_CASE("impending motion has the friction of the slowest motion") {
    for (const double way : {1.0, -1.0}) {
      const Model model = rubbing_slider_crank(0.15);
      const Drive slow{1.0, 1e-6 * way, 0.0}, about{1.0, 0.0, 0.0, way};
      for (const bool statics : {false, true}) {
        const Position moving = solved(model, slow, statics), resting = solved(model, about, statics);
        CHECK(resting.effort[0] == doctest::Approx(moving.effort[0]).epsilon(1e-9));
        const Position whole = solved<WholeSystem>(model, about, statics);
        CHECK(whole.effort[0] == doctest::Approx(resting.effort[0]).epsilon(1e-10));
        Prover prover(model);
        check_trustworthy(prover.prove({&about, 1}, statics, resting));
      }
    }
  }

  TEST_CASE("with less friction the range is narrower, and closes without friction") {
    const Model model = rubbing_slider_crank(0.2);
    GroupSystem system(model);
    REQUIRE(system.assemble() == Status::closed);
    Position at = blank_position(model);
    const auto effort_of = [&](double share, double way) {
      system.take_friction({Resting::without_friction, share});
      const Drive drive{1.0, 0.0, 0.0, way};
      REQUIRE(system.solve({&drive, 1}, at, true) == Status::closed);
      return at.effort[0];
    };
    double before = effort_of(1.0, 1.0) - effort_of(1.0, -1.0);
    for (const double share : {0.75, 0.5, 0.1, 0.01}) {
      const double width = effort_of(share, 1.0) - effort_of(share, -1.0);
      CHECK(width > 0.0);
      CHECK(width < before);
      before = width;
      const Position scaled = solved(rubbing_slider_crank(0.2 * share), {1.0, 0.0, 0.0, 1.0}, true);
      CHECK(effort_of(share, 1.0) == doctest::Approx(scaled.effort[0]).epsilon(1e-10));
    }
    CHECK(effort_of(0.0, 1.0) == doctest::Approx(effort_of(0.0, -1.0)).epsilon(1e-12));
  }

  TEST_CASE("at a dead point the friction of the slide is that just before, just after, or none; never a random sign") {
    const Model model = rubbing_slider_crank(0.15);
    GroupSystem system(model);
    REQUIRE(system.assemble() == Status::closed);
    const double turn = 2.0 * std::acos(-1.0);
    for (const double dead : {0.0, 0.5 * turn, turn}) {
      for (const double speed : {30.0, -30.0}) {
        CAPTURE(dead);
        CAPTURE(speed);
        Position at = blank_position(model);
        const auto force_along_guide = [&](double angle, Resting resting) {
          system.take_friction({resting, 1.0});
          const Drive drive{angle, speed, 0.0};
          REQUIRE(system.solve({&drive, 1}, at) == Status::closed);
          return at.reactions[3].force.x;
        };
        CHECK(force_along_guide(dead, Resting::without_friction) == 0.0);
        CHECK(system.some_joint_rests());
        const double little = std::copysign(1e-5, speed);
        const double before = force_along_guide(dead - little, Resting::without_friction);
        CHECK_FALSE(system.some_joint_rests());
        const double after = force_along_guide(dead + little, Resting::without_friction);
        CHECK(before * after < 0.0);
        CHECK(force_along_guide(dead, Resting::as_before) == doctest::Approx(before).epsilon(1e-3));
        CHECK(force_along_guide(dead, Resting::as_after) == doctest::Approx(after).epsilon(1e-3));
      }
    }
  }
}
