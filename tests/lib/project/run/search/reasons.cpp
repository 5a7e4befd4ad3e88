// What a search without a result says about the candidate that is nearest to passing.
#include "calculators/catalogue.hpp"
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace loadpath;
using namespace loadpath::test;

TEST_SUITE("reasons of searches") {
  TEST_CASE("a shoulder that is too low for every bearing is shown with the required one") {
    const Solved solved(R"([b]
calculator = "bearing.rolling"
bearing = { stock = "bearing/63" }
F_r = "3 kN"
n = "1000 rpm"
L_h = "10000 h"
d_s = "40 mm"
d_f = "47 mm"
)");
    REQUIRE_MESSAGE(solved.errors().empty(), solved.errors());
    const std::string reason = solved.origin("b", "bearing");
    CHECK_MESSAGE(contains(reason, "x_a = 1.043"), reason);
    // 6308: d_a 49 mm by the table of the maker
    CHECK_MESSAGE(contains(reason, "least diameter / diameter of the shoulder: d_a = 49 mm, d_f = 47 mm"), reason);
  }

  TEST_CASE("torques of a connection that are too low are reported with their place") {
    for (const ModeInfo& mode : find_calculator(calculators(), "shaft.design")->modes) {
      if (std::string(mode.id) == "connection") CHECK(contains(mode.advice, "give T_max in the step of the key"));
    }
  }
}
