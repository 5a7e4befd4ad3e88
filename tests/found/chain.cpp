// Regression tests of chains: faults found in use.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string pull_alone = "p_adm = \nS_min = \nP_R = \n";

}  // namespace

TEST_SUITE("found chain") {
  TEST_CASE("A6: a pull below the breaking load alone is not a pass") {
    const std::string row =
        pull_alone + "chain = \"08B\"\nz_1 = 19\nn_1 = \"100 rpm\"\nP = \"5.5 kW\"\na = \"500 mm\"\nK_A = 1";
    CHECK(ExampleStep("chain.roller", row)("p_r") == doctest::Approx(274e6).epsilon(0.005));
    for (const char* id : {"joints", "breaking", "plates", "rollers"})
      CHECK(mode_with("chain.roller", row, id) == "not-judged");
    CHECK(mode_with("chain.roller", pull_alone + "P = \"50 kW\"\nK_A = 1", "breaking") != "pass");
  }

  TEST_CASE("each of the three modes needs its own input, and is assessed by it alone") {
    CHECK(mode_with("chain.roller", pull_alone + "p_adm = \"35 MPa\"", "joints") == "pass");
    CHECK(mode_with("chain.roller", pull_alone + "p_adm = \"35 MPa\"", "plates") == "not-judged");
    CHECK(mode_with("chain.roller", pull_alone + "S_min = 7.6", "breaking") == "pass");
    CHECK(mode_with("chain.roller", pull_alone + "P_R = \"5.5 kW\"", "plates") == "pass");
    CHECK(mode_with("chain.roller", pull_alone + "P_R = \"3 kW\"", "rollers") == "fail");
    CHECK(mode_with("chain.roller", pull_alone + "P = ", "joints") == "none");
  }

  TEST_CASE("the breaking load of a silent chain is compared with its full pull, and fits its width") {
    CHECK(mode_with("chain.inverted_tooth", "", "breaking") == "pass");
    CHECK(mode_with("chain.inverted_tooth", "q = ", "breaking") == "not-judged");
    CHECK(mode_with("chain.inverted_tooth", "F_u = \"300 kN\"", "breaking") == "not-judged");
    CHECK(mode_with("chain.inverted_tooth", "F_u = \"300 kN\"\nbecause.F_u = \"tested\"", "breaking") == "pass");
    CHECK(mode_with("chain.inverted_tooth", "P_b = \"50 kW\"", "rating") == "not-judged");
    CHECK(mode_with("chain.inverted_tooth", "v_max = \"60 m/s\"", "speed") == "not-judged");
    CHECK(mode_with("chain.inverted_tooth", "b = \"500 mm\"", "rating") == "not-judged");
    CHECK(mode_with("chain.inverted_tooth", "a = \"6 m\"", "breaking") == "not-judged");
  }

  TEST_CASE("a sag factor fits the inclination, and long spans need guides") {
    CHECK(mode_with("chain.roller", "theta = \"0 deg\"\nK_f = 1", "breaking") == "not-judged");
    CHECK(mode_with("chain.roller", "theta = \"0 deg\"\nK_f = 6", "breaking") == "pass");
    CHECK(mode_with("chain.roller", "theta = \"90 deg\"\nK_f = 1", "breaking") == "pass");
    CHECK(mode_with("chain.roller", "a = \"3 m\"", "breaking") == "not-judged");
  }

  TEST_CASE("a chain at standstill has no fatigue, as far as its speed is known") {
    const std::string still = pull_alone + "P = \nn_1 = \nT_1 = \"200 N*m\"";
    CHECK(mode_with("chain.roller", still, "plates") == "open");
    CHECK(mode_with("chain.roller", still, "joints") == "not-judged");
  }
}
