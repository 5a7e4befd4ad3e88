// Regression tests of lifts: faults found in use.
#include "tests/found/modes.hpp"

#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string pulled(const std::string& weight, const std::string& M_d) {
  return "s = \"2 m\"\nweights = [{ m = \"10 kg\"" + weight +
         " }]\nwheels = [{ J = \"0.01 kg*m^2\", r = \"100 mm\", M_d = \"" + M_d + "\" }]";
}

}  // namespace

TEST_SUITE("found dynamics") {
  TEST_CASE("A23: a rope does not push") {
    const ExampleStep pushed("dynamics.lift", pulled("", "500 N*m"));
    CHECK(std::abs(pushed("T_hang") + 4537.0) < 1.0);
    CHECK(mode_with("dynamics.lift", pulled("", "500 N*m"), "slack") == "fail");
    CHECK(mode_with("dynamics.lift", pulled("", "0 N*m"), "slack") == "pass");
    CHECK(mode_with("dynamics.lift", "", "slack") == "pass");
  }

  TEST_CASE("A23: nor down a slope, where a thread from below might pull; on a level track this is open") {
    const std::string slope = ", alpha = \"30 deg\"", level = ", alpha = \"0 deg\"";
    CHECK(mode_with("dynamics.lift", pulled(slope, "500 N*m"), "slack_slope") == "not-covered");
    CHECK(mode_with("dynamics.lift", pulled(slope, "0.4 N*m"), "slack_slope") == "pass");
    CHECK(mode_with("dynamics.lift", pulled(level, "5 N*m"), "slack_level") == "open");
    CHECK(mode_with("dynamics.lift", pulled("", "0 N*m"), "slack_level") == "none");
  }

  TEST_CASE("the load on a lift at rest pulls by its weight") {
    const ExampleStep stands(
        "dynamics.lift",
        "weights = [{ m = \"1 kg\" }]\nwheels = [{ J = \"0.01 kg*m^2\", r = \"100 mm\", M_f = \"5 N*m\" }]");
    CHECK(std::abs(stands("T_hang") - 9.81) < 1e-9);
  }
}

TEST_SUITE("found throw") {
  TEST_CASE("W1: a throw reaches the distance of its own angle") {
    CHECK(mode_with("dynamics.throw", "theta = \"10 deg\"\nL_req = \"30 m\"", "reach") == "fail");
    CHECK(mode_with("dynamics.throw", "theta = \"80 deg\"\nL_req = \"30 m\"", "reach") == "fail");
    CHECK(mode_with("dynamics.throw", "theta = \"45 deg\"\nL_req = \"30 m\"", "reach") == "pass");
    CHECK(mode_with("dynamics.throw", "theta = \"90 deg\"\nL_req = \"30 m\"", "reach") != "pass");
  }
}
