// Faulty rolling bearing designs that must not pass: an engineer rejects them.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string id = "bearing.rolling";
const std::string bare = "f_0 = \nF_a = \n";
const std::string rollers = bare + "kind = \"cylindrical_roller_NU\"\n";
const std::string tapered = "f_0 = \nkind = \"tapered_roller\"\ne = 0.37\nY = 1.6\nY_0 = 0.9\n";

}  // namespace

TEST_SUITE("found bearing") {
  TEST_CASE("a bearing without ribs takes no axial load, in operation or at rest, and none in the wrong direction") {
    CHECK(mode_with(id, rollers, "axial") == "pass");
    CHECK(mode_with(id, rollers + "F_a = \"10 N\"", "axial") == "fail");
    CHECK(mode_with(id, rollers + "F_a = \"-10 N\"", "axial") == "fail");
    CHECK(mode_with(id, rollers + "F_r0 = \"1 kN\"\nF_a0 = \"1 kN\"", "axial") == "fail");
    CHECK(mode_with(id, tapered + "F_a = \"2 kN\"", "axial") == "pass");
    CHECK(mode_with(id, tapered + "F_a = \"-2 kN\"", "axial") == "fail");
    CHECK(mode_with(id, tapered + "F_a = \"-2 kN\"", "mate") == "not-covered");
    CHECK(mode_with(id, "F_a = \"-1 kN\"", "axial") == "pass");  // a deep groove takes it in both directions
  }

  TEST_CASE("ribs take half of the radial load, and what the manufacturer allows") {
    const std::string ribs = "f_0 = \nkind = \"cylindrical_roller_NJ\"\ne = 0.2\nY = 0.6\n";
    CHECK(mode_with(id, ribs + "F_a = \"1 kN\"", "ribs") == "not-judged");
    CHECK(mode_with(id, ribs + "F_a = \"1 kN\"\nF_a_adm = \"1.1 kN\"", "ribs") == "pass");
    CHECK(mode_with(id, ribs + "F_a = \"1 kN\"\nF_a_adm = \"0.9 kN\"", "ribs") == "fail");
    CHECK(mode_with(id, ribs + "F_a = \"1.3 kN\"\nF_a_adm = \"2 kN\"", "axial") == "fail");
    CHECK(mode_with(id, ribs + "F_a = \"-0.5 kN\"\nF_a_adm = \"2 kN\"", "axial") == "fail");
  }

  TEST_CASE("a thrust bearing takes no radial load, and skids without an axial one") {
    const std::string thrust = bare + "kind = \"thrust_ball\"\n";
    CHECK(mode_with(id, thrust + "F_r = \"0 N\"\nF_a = \"2 kN\"", "radial") == "pass");
    CHECK(mode_with(id, thrust + "F_a = \"2 kN\"", "radial") == "fail");
    CHECK(mode_with(id, thrust + "F_r = \"0 N\"", "skidding") == "not-judged");
    CHECK(mode_with(id, thrust + "F_r = \"0 N\"\nF_a = \"-2 kN\"", "axial") == "fail");
  }

  TEST_CASE("a tapered bearing with less axial load than its radial load induces is not covered") {
    CHECK(mode_with(id, tapered + "F_a = \"0 kN\"", "mate") == "not-covered");
    CHECK(mode_with(id, tapered + "F_a = \"0.7 kN\"", "mate") == "not-covered");
    CHECK(mode_with(id, tapered + "F_a = \"0.8 kN\"", "mate") == "pass");
  }

  TEST_CASE("an overload at standstill dents a bearing whose load in operation is small") {
    CHECK(mode_with(id, "F_r0 = \"8 kN\"", "static") == "pass");
    CHECK(mode_with(id, "F_r0 = \"9.1 kN\"", "static") == "fail");
    CHECK(mode_with(id, "F_r0 = \"2 kN\"\nF_a0 = \"-16 kN\"", "static") == "fail");
    CHECK(mode_with(id, "F_r0 = \"2 kN\"\nF_a0 = \"-16 kN\"", "ribs") == "fail");
    CHECK(mode_with(id, "n = \"0 rpm\"\nL_h = \nn_max = \nF_r = \"12 kN\"", "static") == "fail");
    CHECK(mode_with(id, "blocks = [{ q = 0.999 }, { q = 0.001, k = 4, n = \"0 rpm\" }]", "static") == "fail");
  }

  TEST_CASE("missing input is not assessed") {
    CHECK(mode_with(id, "L_h = ", "fatigue") == "not-judged");
    CHECK(mode_with(id, "s_0 = ", "static") == "not-judged");
    CHECK(mode_with(id, "n_max = ", "speed") == "not-judged");
    CHECK(mode_with(id, "n = \"0 rpm\"\nL_h = \nn_max = ", "fatigue") == "none");
  }

  TEST_CASE("a rule of thumb for the minimum load does not decide, the manufacturer's value does") {
    const std::string low = bare + "F_r = \"200 N\"\n";  // 0.01 C is 291 N
    CHECK(mode_with(id, low, "skidding") == "not-judged");
    CHECK(mode_with(id, low + "accept = { skidding = \"preloaded by a spring washer\" }", "skidding") == "accepted");
    CHECK(mode_with(id, low + "P_min = \"0.1 kN\"", "skidding") == "pass");
    CHECK(mode_with(id, low + "P_min = \"0.3 kN\"", "skidding") == "fail");
    CHECK(mode_with(id, bare + "F_r = \"300 N\"", "skidding") == "pass");
    CHECK(mode_with(id, bare + "F_r = \"0 N\"", "skidding") == "not-judged");
    CHECK(mode_with(id, "blocks = [{ q = 0.5 }, { q = 0.5, k = 0 }]", "skidding") == "not-judged");
  }

  TEST_CASE("a speed above the limiting speed fails") {
    CHECK(mode_with(id, "n = \"8600 rpm\"\nL_h = \"1000 h\"", "speed") == "fail");
    CHECK(mode_with(id, "blocks = [{ q = 0.9 }, { q = 0.1, n = \"9000 rpm\" }]", "speed") == "fail");
  }

  TEST_CASE("beyond half of C, and beyond C_0, there is no rating life") {
    CHECK(mode_with(id, bare + "F_r = \"15 kN\"\nL_h = \"1 h\"", "fatigue") == "not-covered");
    CHECK(mode_with(id, bare + "C_0 = \"10 kN\"\nF_r = \"11 kN\"\nL_h = \"1 h\"", "fatigue") == "not-covered");
  }

  TEST_CASE("99 % reliability needs more than 90 %") {
    CHECK(mode_with(id, "", "fatigue") == "pass");
    CHECK(mode_with(id, "a_1 = 0.25", "fatigue") == "fail");
    CHECK(mode_with(id, "K_A = 1.3", "fatigue") == "fail");
  }
}

TEST_SUITE("found bearing ratings") {
  TEST_CASE("factors that belong together need a reason where they do not agree") {
    const std::string loads = "F_r = \"2 kN\"\nF_a = \"8 kN\"\nC = \"90 kN\"\nC_0 = \"90 kN\"\ns_0 = 3\n";
    const auto state = [&](const std::string& factors, const char* mode) {
      return mode_with(id, "f_0 = \nkind = \"tapered_roller\"\n" + loads + factors, mode);
    };
    CHECK(state("e = 0.4\nY = 1.5\nY_0 = 0.8", "static") == "pass");
    CHECK(state("e = 0.4\nY = 1.5\nY_0 = 0.3", "static") == "not-judged");
    CHECK(state("e = 0.4\nY = 0.5\nY_0 = 0.8", "fatigue") == "not-judged");
    CHECK(state("e = 0.4\nY = 1.5\nY_0 = 0.8\nX = 0.1\nL_h = \"1000 h\"", "fatigue") == "not-judged");
    CHECK(state("e = 0.4\nY = 0.5\nY_0 = 0.8\nbecause.Y = \"catalogue\"", "fatigue") == "pass");
  }

  TEST_CASE("P1: C and C_0 must belong to the same bearing") {
    const auto fault = [](const std::string& lines) { return ExampleStep("bearing.rolling", lines).fault(); };
    CHECK(fault("").empty());
    CHECK_FALSE(fault("C_0 = \"179 kN\"").empty());
    CHECK_FALSE(fault("C_0 = \"1.79 kN\"").empty());
    CHECK_FALSE(fault("C = \"17.9 kN\"\nC_0 = \"29.1 kN\"").empty());  // one for the other
    CHECK(fault("C = \"444 kN\"\nC_0 = \"807 kN\"").empty());          // 16096, a large one
    const std::string bare = "f_0 = \nF_a = \"0 N\"\n";
    CHECK_FALSE(fault(bare + "kind = \"cylindrical_roller_NU\"\nC_0 = \"160 kN\"").empty());
    CHECK_FALSE(fault(bare + "kind = \"self_aligning_ball\"\nC_0 = \"29 kN\"").empty());
    CHECK(fault(bare + "kind = \"cylindrical_roller_NU\"\nC_0 = \"30 kN\"").empty());
  }

  TEST_CASE("without a speed the life is in revolutions, and is assessed in them") {
    const std::string turns = "n = \nL_h = \nn_max = \nL_m = ";
    const ExampleStep bearing("bearing.rolling", turns + "1");
    CHECK(std::abs(bearing("L_10") / ExampleStep("bearing.rolling", "")("L_10") - 1.0) < 1e-12);
    CHECK(mode_with("bearing.rolling", turns + "1", "fatigue") == "pass");
    CHECK(mode_with("bearing.rolling", turns + "1e6", "fatigue") == "fail");
    CHECK(mode_with("bearing.rolling", "n = \nL_h = \nL_m = 1", "speed") == "open");
    CHECK(mode_with("bearing.rolling", "n = \nL_h = \nn_max = ", "fatigue") == "not-judged");
    CHECK_FALSE(ExampleStep("bearing.rolling", "n = ").fault().empty());
  }
}
