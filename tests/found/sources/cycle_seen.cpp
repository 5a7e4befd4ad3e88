// Cycles that are not covered in full: positions that miss the largest load, speeds and directions of a pin joint,
// inertia of links without mass.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string press_with(const std::string& crank, const std::string& load = "F_x = \"-10 kN\", F_y = \"0 N\"") {
  return "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\nl = \"200 mm\"\n"
         "crank = { " +
         crank + " }\nloads = [{ name = \"F\", link = \"slider\", at = \"B\", " + load + " }]\n";
}

const std::string turning = "speed = \"60 rpm\", positions = 180";

std::string pin_with(const std::string& lines, const std::string& load = "load = \"=press.joints.B\"") {
  return "[pin]\ncalculator = \"pin.joint\"\n" + load +
         "\nheld = \"in_fork\"\nd = \"20 mm\"\nt_1 = \"15 mm\"\nt_2 = \"10 mm\"\nmaterial = \"C45E\"\n"
         "p_adm_1 = \"60 MPa\"\np_adm_2 = \"80 MPa\"\npv_adm = \"2 MPa*m/s\"\n" +
         lines;
}

std::string turned_by(const std::string& n) {
  return press_with(turning) + pin_with("loading = \"pulsating\"\nn = \"" + n + "\"\n");
}

std::string over(const std::string& shares) { return "F_x = \"-10 kN\", F_y = \"0 N\", over = [" + shares + "]"; }

const std::string peak_at_90 = over(R"(["0 deg", 0], ["25 deg", 0.05], ["90 deg", 1], ["200 deg", 0])");

std::string rod_at(const std::string& speed, const std::string& mass = "") {
  return press_with("speed = \"" + speed + "\", positions = 60") + mass +
         "[rod]\ncalculator = \"link.member\"\nload = \"=press.links.rod\"\nh = \"30 mm\"\nb = \"15 mm\"\n"
         "ends = \"pinned_pinned\"\nmaterial = \"S355\"\nmethod = \"johnson\"\nn_st = 3\nS = 2\n";
}

}  // namespace

TEST_SUITE("found cycle seen") {
  TEST_CASE("given crank angles include the largest factor of each load") {
    const std::string missing = press_with("speed = \"60 rpm\", at = [\"0 deg\", \"5 deg\", \"20 deg\"]", peak_at_90);
    CHECK(mode_of(solved_as_found(missing), "press", "courses") == "not-covered");
    const std::string seen = press_with("speed = \"60 rpm\", at = [\"0 deg\", \"90 deg\", \"200 deg\"]", peak_at_90);
    CHECK(mode_of(solved_as_found(seen), "press", "courses") == "pass");
    const std::string all = press_with(turning, peak_at_90);
    CHECK(mode_of(solved_as_found(all), "press", "courses") == "none");
    const std::string constant = press_with("speed = \"60 rpm\", at = [\"0 deg\", \"5 deg\"]");
    CHECK(mode_of(solved_as_found(constant), "press", "courses") == "none");
  }

  TEST_CASE("both signs of a load are among the given crank angles") {
    const std::string both = over(R"(["0 deg", 1], ["120 deg", -0.8], ["240 deg", 0])");
    const std::string one = press_with("speed = \"60 rpm\", at = [\"0 deg\", \"20 deg\"]", both);
    CHECK(mode_of(solved_as_found(one), "press", "courses") == "not-covered");
    const std::string two = press_with("speed = \"60 rpm\", at = [\"0 deg\", \"120 deg\"]", both);
    CHECK(mode_of(solved_as_found(two), "press", "courses") == "pass");
  }

  TEST_CASE("a load over the time is largest within the time of the cycle") {
    const auto over_time = [](const std::string& largest) {
      return press_with(turning, "F_x = \"-1 kN\", F_y = \"0 N\", course = \"c\"") +
             "[press.courses]\nc = { over_time = [[\"0 s\", 0.1], [\"" + largest + "\", 1], [\"2 s\", 0.1]] }\n";
    };
    CHECK(mode_of(solved_as_found(over_time("1.5 s")), "press", "courses") == "not-covered");
    CHECK(mode_of(solved_as_found(over_time("0.5 s")), "press", "courses") == "pass");
  }

  TEST_CASE("a pin turns at least with the relative speed of its links") {
    CHECK(mode_of(solved_as_found(turned_by("1 rpm")), "pin", "wear") == "not-judged");
    CHECK(mode_of(solved_as_found("[values]\nn = \"1 rpm\"\n" + turned_by("=values.n")), "pin", "wear") ==
          "not-judged");
    CHECK(mode_of(solved_as_found(turned_by("=abs(mean(press.links.rod.omega))")), "pin", "wear") == "not-judged");
    CHECK(mode_of(solved_as_found(turned_by("=press.links.slider.omega")), "pin", "wear") == "not-judged");
    CHECK(mode_of(solved_as_found(turned_by("=press.links.rod.omega")), "pin", "wear") == "pass");
    CHECK(mode_of(solved_as_found(turned_by("=press.joints.B.omega")), "pin", "wear") == "pass");
    CHECK(mode_of(solved_as_found(turned_by("20 rpm")), "pin", "wear") == "pass");
    CHECK(mode_of(solved_as_found(turned_by("9 rpm") + "because.n = \"mean speed of the swing\"\n"), "pin", "wear") ==
          "pass");
  }

  TEST_CASE("a pin whose force reverses is loaded alternately") {
    const std::string both = over(R"(["0 deg", 1], ["170 deg", 1], ["190 deg", -1], ["350 deg", -1])");
    const std::string n = "n = \"=press.joints.B.omega\"\n";
    CHECK(first_error_of(press_with(turning, both) + pin_with("loading = \"pulsating\"\n" + n))
              .find("but F reverses: the direction of 'press.joints.B.F'") != std::string::npos);
    CHECK(first_error_of(press_with(turning, both) + pin_with("loading = \"alternating\"\n" + n)).empty());
    CHECK(first_error_of(press_with(turning) + pin_with("loading = \"pulsating\"\n" + n)).empty());
    // The force of the crank pin turns round in the crank, and not in the rod.
    CHECK(first_error_of(press_with(turning) + pin_with("loading = \"pulsating\"\nn = \"=press.joints.A.omega\"\n",
                                                        "load = \"=press.joints.A\""))
              .empty());
  }

  TEST_CASE("the inertia of a link without mass is negligible or included") {
    CHECK(mode_of(solved_as_found(rod_at("9000 rpm")), "rod", "inertia") == "not-covered");
    CHECK(mode_of(solved_as_found(rod_at("300 rpm")), "rod", "inertia") == "pass");
    const std::string given = "[press.links.rod]\nmass = \"0.7 kg\"\n";
    CHECK(mode_of(solved_as_found(rod_at("9000 rpm", given)), "rod", "inertia") == "none");
  }

  TEST_CASE("the force of a guide is not that of a pin") {
    const std::string guide =
        press_with(turning, over(R"(["0 deg", 1], ["170 deg", 1], ["190 deg", 0])")) +
        pin_with("loading = \"pulsating\"\nn = \"=press.joints.B.omega\"\n", "F = \"=peak(press.joints.guide.F)\"");
    CHECK(mode_of(solved_as_found(guide), "pin", "bending") == "not-judged");
    const std::string part =
        press_with(turning) +
        pin_with("loading = \"alternating\"\nn = \"=press.joints.B.omega\"\n", "F = \"=peak(press.joints.B.y)\"");
    CHECK(mode_of(solved_as_found(part), "pin", "bending") == "not-judged");
  }

  TEST_CASE("a pin has the diameter that the mechanism uses for its friction") {
    const std::string rubbing = press_with(turning) + "[press.joints.B]\nmu = 0.1\npin_radius = \"8 mm\"\n";
    const std::string lines = "loading = \"alternating\"\nn = \"=press.joints.B.omega\"\n";
    CHECK(first_error_of(rubbing + pin_with(lines)).find("d = 20 mm contradicts 'press.joints.B.d_pin'") == 0);
    CHECK(first_error_of(press_with(turning) + "[press.joints.B]\nmu = 0.1\npin_radius = \"10 mm\"\n" + pin_with(lines))
              .empty());
  }
}
