// Moving and solving take no memory: sweeps of dimensions run through them millions of times.
#include "tests/allocations.hpp"
#include "tests/lib/mechanism/cam_models.hpp"
#include "tests/lib/mechanism/wheel_models.hpp"

#include <doctest/doctest.h>

#include <cstddef>

TEST_SUITE("mechanism") {
  TEST_CASE_TEMPLATE("a revolution of the crank allocates nothing, nor does a move that fails", System,
                     loadpath::mechanism::WholeSystem, loadpath::mechanism::GroupSystem) {
    using namespace loadpath::mechanism;
    Model rocker_driven = models::four_bar();
    rocker_driven.drivers[0].i = 2;
    Model rubbing = models::slider_crank();
    for (Joint& joint : rubbing.joints) joint.friction = {.coefficient = 0.1, .pin_radius = 0.01};
    Model losing = models::gear_train(0.349);
    losing.joints.back().friction.loss = 0.1;
    for (const Model& model :
         {models::slider_crank(), models::six_bar(), models::slotted_lever(), models::class_three(), rubbing, losing,
          rocker_driven, models::cam_with_roller(), models::cam_with_arm(), models::oval_with_flat_arm()}) {
      System system(model);
      Position at = blank_position(model);
      const std::size_t before = loadpath::tests::allocations();
      int failed = system.assemble() == Status::closed ? 0 : 1;
      const double start = system.coordinate(0);
      for (int k = 0; k < 72; ++k) {
        const Drive drive{start + 0.1 * k, k % 2 == 0 ? 10.0 : 0.0, 0.0, 1.0};
        failed += system.solve({&drive, 1}, at) == Status::closed ? 0 : 1;
      }
      const std::size_t after = loadpath::tests::allocations();
      CHECK(after == before);
      CHECK((failed > 0) == (model.links[0].name == "crank" && model.drivers[0].i == 2));
    }
  }
}
