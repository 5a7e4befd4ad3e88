// The split of reactions and efforts by cause.
#include "lib/mechanism/studies/causes.hpp"

#include "lib/mechanism/groups/system.hpp"
#include "tests/allocations.hpp"
#include "tests/lib/mechanism/wheel_models.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

Position in_motion(const Model& model) {
  GroupSystem system(model);
  Position at = blank_position(model);
  REQUIRE(system.assemble() == Status::closed);
  std::vector<Drive> drives;
  for (std::size_t k = 0; k < model.drivers.size(); ++k) drives.push_back({system.coordinate(k) + 0.01, 7.0, 20.0});
  REQUIRE(system.solve(drives, at) == Status::closed);
  return at;
}

void check_sum(const CauseSplit& split, const Position& at) {
  double scale = 0.0;
  for (std::size_t c = 0; c < split.causes().size(); ++c) {
    for (const Reaction& r : split.share(c).reactions) scale = std::max(scale, length(r.force));
  }
  for (std::size_t k = 0; k < at.reactions.size(); ++k) {
    Reaction sum{at.reactions[k].at, {}};
    for (std::size_t c = 0; c < split.causes().size(); ++c) sum = sum + split.share(c).reactions[k];
    CHECK(difference(at.reactions[k], sum, 1.0) <= 1e-12 * scale);
  }
  for (std::size_t d = 0; d < at.effort.size(); ++d) {
    double sum = 0.0;
    for (std::size_t c = 0; c < split.causes().size(); ++c) sum += split.share(c).effort[d];
    CHECK(std::abs(sum - at.effort[d]) <= 1e-12 * std::max(scale, std::abs(at.effort[d])));
  }
}

Model with_friction(Model model) {
  for (Joint& joint : model.joints) joint.friction = {.coefficient = 0.1, .pin_radius = 0.008};
  for (Joint& joint : model.joints) joint.guide_width = 0.02;
  return model;
}

Model sprung_lever() {
  Model model = slotted_lever();
  model.springs.push_back({"a", Spring::Kind::linear, 1, ground, {0.1, 0.02}, {0.1, -0.3}, 2000.0, 0.2, 15.0});
  model.springs.push_back({"c", Spring::Kind::turning, 0, 1, {}, {}, 3.0, 0.2, 0.05});
  return model;
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("the contributions of all causes sum up to the reactions and efforts") {
    std::vector<Case> all = cases();
    for (const Model& model :
         {slider_crank(), four_bar(), six_bar(), slotted_lever(), class_three(), five_bar(), boom(), telescope(),
          trammel(), with_friction(slider_crank()), with_friction(slotted_lever()), sprung_lever()}) {
      all.push_back({model.links.back().name.c_str(), model});
    }
    for (const Case& c : all) {
      CAPTURE(c.model.links.back().name);
      const Position at = in_motion(c.model);
      CauseSplit split(c.model);
      REQUIRE(split.find(at));
      check_sum(split, at);
    }
  }

  TEST_CASE("a contribution is the result of the mechanism with only this cause") {
    const Model model = six_bar();
    CauseSplit split(model);
    REQUIRE(split.find(in_motion(model)));
    for (std::size_t c = 0; c < split.causes().size(); ++c) {
      const Cause cause = split.causes()[c];
      Model alone = model;
      if (cause.kind != Cause::Kind::load) alone.loads.clear();
      if (cause.kind != Cause::Kind::weights) alone.gravity = {};
      for (std::size_t k = 0; k < alone.links.size(); ++k) {
        const bool only_weights = cause.kind == Cause::Kind::weights;
        const bool moves = cause.kind == Cause::Kind::inertia && cause.index == k;
        if (!moves) alone.links[k].inertia = 0.0;
        if (!moves && !only_weights) alone.links[k].mass = 0.0;
      }
      GroupSystem system(alone);
      Position at = blank_position(alone);
      REQUIRE(system.assemble() == Status::closed);
      const Drive drive{system.coordinate(0) + 0.01, 7.0, 20.0};
      REQUIRE(system.solve({&drive, 1}, at, cause.kind == Cause::Kind::weights) == Status::closed);
      CHECK(split.share(c).effort[0] == doctest::Approx(at.effort[0]).epsilon(1e-10));
      for (std::size_t k = 0; k < at.reactions.size(); ++k) {
        CHECK(length(split.share(c).reactions[k].force - at.reactions[k].force) <= 1e-9);
      }
    }
  }

  TEST_CASE("friction in one pin causes the difference of the moment, and no force changes without it") {
    Model model = slider_crank();
    model.gravity = {};
    model.joints[0].friction = {.coefficient = 0.2, .pin_radius = 0.01};
    const Position at = in_motion(model);
    CauseSplit split(model);
    REQUIRE(split.find(at));
    const Forces& friction = split.share(split.causes().size() - 1);
    // The crank's bearing: M = mu r R against the turning.
    CHECK(friction.effort[0] == doctest::Approx(0.2 * 0.01 * length(at.reactions[0].force)).epsilon(1e-9));
    CHECK(friction.reactions[0].couple == doctest::Approx(-friction.effort[0]).epsilon(1e-9));
    CHECK(length(friction.reactions[2].force) <= 1e-9);
  }

  TEST_CASE("splitting allocates nothing") {
    const Model model = six_bar();
    const Position at = in_motion(model);
    CauseSplit split(model);
    bool found = split.find(at);
    const std::size_t before = loadpath::tests::allocations();
    found = split.find(at) && found;
    CHECK(loadpath::tests::allocations() == before);
    CHECK(found);
  }
}
