#include "lib/mechanism/proof/opened_chain.hpp"

#include "tests/lib/mechanism/worked_models.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

std::vector<std::string> opened(const Model& model) {
  std::vector<std::string> names;
  const OpenedChain chain{Instant(model)};
  for (const std::size_t joint : chain.opened_joints()) names.push_back(model.joints[joint].name);
  return names;
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("a chain is opened at one joint for each loop") {
    CHECK(opened(telescope()).empty());
    CHECK(opened(four_bar()).size() == 1);
    CHECK(opened(six_bar()).size() == 2);
    CHECK(opened(crank_with_six_link_group()).size() == 3);  // text D, example 3
    CHECK(opened(loader()).size() == 3);
  }

  TEST_CASE("a chain is opened at a slot rather than at a pin: one unknown less") {
    CHECK(opened(slotted_lever()) == std::vector<std::string>{"A"});
    CHECK(opened(slot_on_a_moving_link(false)).back() == "F");
  }
}
