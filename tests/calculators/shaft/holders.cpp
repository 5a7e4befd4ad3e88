// Fastening of hubs and rings along a shaft and around it: set screws, retaining rings.
#include "calculators/shaft/circlip.hpp"
#include "calculators/shaft/set_screw.hpp"
#include "lib/table/library.hpp"
#include "lib/table/table.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace {

using namespace loadpath;
using loadpath::test::mode_with;
using loadpath::test::rel;
using shaft::Circlip;
using shaft::SetScrew;

double column(std::string_view group, std::string_view name, std::string_view key) {
  const auto row = table::find_row(group, name);
  REQUIRE(row);
  const auto value = table::property(*row, key);
  REQUIRE(value);
  return value->si;
}

}  // namespace

TEST_SUITE("set screws") {
  TEST_CASE("[SPS]: torques that screws of sizes 0, 1 and 2 hold on shafts of an eighth and a quarter of an inch") {
    SetScrew::Input in;
    in.T = 0.1 * N_m, in.S = 1.5;
    constexpr double lbf_in = 0.112984829;
    const auto holds = [&](const char* name, double inches) {
      in.F_h = from_si<Force>(column("set_screw", name, "F_h")), in.d = from_si<Length>(inches * 0.0254);
      return in_si(test::evaluated<SetScrew>(in).T_h) / lbf_in;
    };
    CHECK(std::abs(holds("#0", 0.125) - 3.1) < 0.051);
    CHECK(std::abs(holds("#1", 0.125) - 4.0) < 0.07);
    CHECK(std::abs(holds("#2", 0.125) - 5.3) < 0.051);
    CHECK(std::abs(holds("#2", 0.25) - 10.6) < 0.051);
  }

  TEST_CASE("designs that must not pass") {
    CHECK(mode_with("shaft.set_screw", "", "slip") == "pass");
    CHECK(mode_with("shaft.set_screw", "F_a = \"-9 kN\"", "slip") == "fail");
    CHECK(mode_with("shaft.set_screw", "K_A = 6", "slip") == "fail");
    CHECK(mode_with("shaft.set_screw", "load_case = \"dynamic\"", "safety") == "fail");
    CHECK(mode_with("shaft.set_screw", "load_case = \"dynamic\"\nS = 4", "safety") == "pass");
    CHECK(mode_with("shaft.set_screw", "load_case = \nK_A = 1.5", "safety") == "fail");
    CHECK(mode_with("shaft.set_screw", "load_case = \nS = 1", "safety") == "fail");
  }
}

TEST_SUITE("retaining rings") {
  TEST_CASE("[DIN471]: the load capacities of the grooves printed in the standard follow from 200 MPa and 1.2") {
    for (const std::string name : {"3x0.4", "4x0.4", "5x0.6", "6x0.7", "7x0.8", "8x0.8", "9x1", "10x1", "11x1", "12x1",
                                   "13x1", "14x1", "15x1", "16x1", "17x1", "18x1.2"}) {
      CAPTURE(name);
      Circlip::Input in;
      in.F_a = 1.0 * N, in.R_e = 200.0 * MPa;
      in.d_1 = from_si<Length>(column("circlip", name, "d_1")),
      in.d_2 = from_si<Length>(column("circlip", name, "d_2"));
      in.w = from_si<Length>(column("circlip", name, "w_min"));
      const auto r = test::evaluated<Circlip>(in);
      CHECK(rel(in_si(r.F_N), column("circlip", name, "F_N")) < 0.0215);
      CHECK(r.x_w > 3.0 - 1e-9);
    }
  }

  TEST_CASE("designs that must not pass") {
    CHECK(mode_with("shaft.circlip", "", "groove") == "pass");
    CHECK(mode_with("shaft.circlip", "F_a = \"-5 kN\"", "groove") == "fail");
    CHECK(mode_with("shaft.circlip", "w = \"1 mm\"", "groove") == "not-covered");
    CHECK(mode_with("shaft.circlip", "w = \"1 mm\"\nq = 3", "groove") == "fail");
    CHECK(mode_with("shaft.circlip", "c = \"2 mm\"", "ring") == "fail");
    const std::string of_its_own = "circlip = \nd_1 = \"18 mm\"\nw = \"20 mm\"\nd_2 = ";
    CHECK(mode_with("shaft.circlip", of_its_own + "\"17 mm\"", "groove") == "pass");
    CHECK(mode_with("shaft.circlip", of_its_own + "\"8 mm\"", "groove") == "not-covered");  // a neck
    const test::ExampleStep other("shaft.circlip", "d_2 = \"8 mm\"");
    CHECK(other.fault().find("the circlip '18x1.2', which has 17 mm") != std::string::npos);
    CHECK(mode_with("shaft.circlip", "c = ", "ring") == "not-judged");
    CHECK(mode_with("shaft.circlip", "n = \"40000 rpm\"", "opening") == "fail");
  }
}
