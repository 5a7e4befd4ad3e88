// Regression tests of the parts of a vessel next to each other.
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string shell_and(const std::string& end) {
  return "[shell]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\nmeasured = \"inner\"\nc = \"1 "
         "mm\"\n"
         "delta = \"8 mm\"\nsigma_adm = \"140 MPa\"\n\n"
         "[head]\ncalculator = \"vessel.end\"\nform = \"korbbogen\"\ndelta = \"8 mm\"\nR_e = \"265 MPa\"\n"
         "R_m = \"410 MPa\"\nl_f = \"40 mm\"\n" +
         end;
}

/// Two shells and a hemisphere, all with one pressure: what the strength of the hemisphere waits for.
std::string doubt_of_hemisphere(const std::string& R) {
  const std::string wall =
      "p = \"1 MPa\"\nmeasured = \"inner\"\nc = \"1 mm\"\ndelta = \"12 mm\"\nsigma_adm = \"140 MPa\"\n";
  const project::Project vessels =
      solved_as_found("[narrow]\ncalculator = \"vessel.cylinder\"\nR = \"600 mm\"\n" + wall +
                      "\n[wide]\ncalculator = \"vessel.cylinder\"\nR = \"900 mm\"\n" + wall +
                      "\n[head]\ncalculator = \"vessel.sphere\"\nR = \"" + R + "\"\n" + wall);
  for (const account::Mode& mode : project::modes(vessels)) {
    if (mode.step == "head" && mode.id == "strength") return mode.note.text();
  }
  return "";
}

}  // namespace

TEST_SUITE("found vessels") {
  TEST_CASE("an end whose pressure is typed next to a shell refers to it, or is of another vessel") {
    const std::string typed = "p = \"1 MPa\"\nD_i = \"1000 mm\"\nc = \"1 mm\"\n";
    CHECK(mode_of(solved_as_found(shell_and(typed)), "head", "strength") == "not-judged");
    CHECK(mode_of(solved_as_found(shell_and("shell = \"=shell.shell\"\n")), "head", "strength") == "pass");
    CHECK(mode_of(solved_as_found(shell_and(typed + "because.p = \"of the heater\"\n")), "head", "strength") == "pass");
  }

  TEST_CASE("a shell has no higher allowable stress than the material of its end allows") {
    const auto with = [](const std::string& sigma_adm) {
      return "[shell]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\nmeasured = \"inner\"\n"
             "delta = \"8 mm\"\nsigma_adm = \"" +
             sigma_adm +
             "\"\n\n[head]\ncalculator = \"vessel.end\"\nshell = \"=shell.shell\"\nform = \"korbbogen\"\n"
             "material = \"P265GH\"\nl_f = \"40 mm\"\n";
    };
    CHECK(mode_of(solved_as_found(with("300 MPa")), "shell", "strength") == "not-judged");
    CHECK(mode_of(solved_as_found(with("140 MPa")), "shell", "strength") == "pass");
  }

  TEST_CASE("walls of one pressure have no higher allowable stress than the material of one of them allows") {
    const auto with = [](const std::string& sigma_adm, const std::string& p) {
      return "[values]\np = \"0.8 MPa\"\n\n[shell]\ncalculator = \"vessel.cylinder\"\np = \"=values.p\"\nR = \"500 "
             "mm\"\nmeasured = \"inner\"\nc = \"1 mm\"\nz_l = 0.85\nmaterial = \"P265GH\"\nS = 1.5\n\n"
             "[ring]\ncalculator = \"vessel.torus\"\nR_0 = \"1 m\"\nr = \"100 mm\"\np = \"" +
             p + "\"\nsigma_adm = \"" + sigma_adm + "\"\n";
    };
    const auto state = [&](const std::string& sigma_adm, const std::string& p) {
      return mode_of(solved_as_found(with(sigma_adm, p)), "ring", "strength");
    };
    CHECK(state("140 MPa", "=values.p") == "pass");
    CHECK(state("260 MPa", "=values.p") == "not-judged");  // R_e = 265 MPa
    CHECK(state("260 MPa", "0.2 MPa") == "pass");          // another vessel
  }

  TEST_CASE("an end with a radius that no shell has is compared with the shell of the nearest radius") {
    CHECK(doubt_of_hemisphere("300 mm").find("'narrow'") != std::string::npos);
    CHECK(doubt_of_hemisphere("1500 mm").find("'wide'") != std::string::npos);
    CHECK(doubt_of_hemisphere("600 mm").empty());
    CHECK(doubt_of_hemisphere("900 mm").empty());
  }

  TEST_CASE("a wall with the pressure of a shell that holds a liquid holds it too, or is above it") {
    const std::string wall =
        "p = \"=values.p\"\nmeasured = \"inner\"\nc = \"1 mm\"\ndelta = \"16 mm\"\nsigma_adm = \"140 MPa\"\n";
    const auto state = [&](const std::string& liquid, const std::string& end, const char* step = "end") {
      return mode_of(
          solved_as_found("[values]\np = \"0.2 MPa\"\n\n[shell]\ncalculator = \"vessel.cylinder\"\nR = \"3 m\"\n" +
                          wall + liquid + "\n[end]\n" + wall + end),
          step, "strength");
    };
    const std::string water = "rho = \"1000 kg/m^3\"\nh_l = \"10 m\"\n";  // 0.098 MPa more at the bottom
    const std::string head = "calculator = \"vessel.ellipsoid\"\na = \"3 m\"\nb = \"1.5 m\"\n";
    CHECK(state("", head) == "pass");
    CHECK(state(water, head) == "not-judged");
    CHECK(state(water, head, "shell") == "pass");
    CHECK(state(water, head + "because.p = \"above the liquid\"\n") == "pass");
    const std::string second = "calculator = \"vessel.cylinder\"\nR = \"3 m\"\n";
    CHECK(state(water, second + water) == "pass");
    CHECK(state(water, second + "rho = \"1000 kg/m^3\"\nh_l = \"4 m\"\n") == "not-judged");
    CHECK(state(water, second + "rho = \"1000 kg/m^3\"\nh_l = \"4 m\"\n", "shell") == "pass");
  }

  TEST_CASE("an end is tested with the pressure of its shell") {
    const auto state = [](const std::string& p_t) {
      return mode_of(
          solved_as_found("[shell]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\n"
                          "measured = \"inner\"\nc = \"1 mm\"\ndelta = \"9 mm\"\nmaterial = \"P265GH\"\n"
                          "S = 1.5\np_t = \"1.9 MPa\"\nh_t = \"0 mm\"\n\n[head]\ncalculator = \"vessel.end\"\n"
                          "shell = \"=shell.shell\"\nform = \"korbbogen\"\nmaterial = \"P265GH\"\n"
                          "l_f = \"40 mm\"\ndelta = \"9 mm\"\nh_t = \"0 mm\"\np_t = \"" +
                          p_t + "\"\n"),
          "head", "strength");
    };
    CHECK(state("1.9 MPa") == "pass");
    CHECK(state("1.43 MPa") == "not-judged");
  }

  TEST_CASE("a wall under vacuum is that of the vessel in the file, or of another one") {
    const auto state = [](const std::string& wall) {
      return mode_of(
          solved_as_found("[shell]\ncalculator = \"vessel.cylinder\"\np = \"0.5 MPa\"\nR = \"600 mm\"\n"
                          "measured = \"outer\"\nc = \"1 mm\"\ndelta = \"12 mm\"\nsigma_adm = \"140 MPa\"\n\n"
                          "[vacuum]\ncalculator = \"vessel.external\"\np_e = \"0.1 MPa\"\nL = \"1 m\"\n"
                          "material = \"P265GH\"\n" +
                          wall),
          "vacuum", "buckling");
    };
    const std::string typed = "D_a = \"1200 mm\"\ndelta = \"12 mm\"\n";
    CHECK(state("wall = \"=shell.wall\"\n") == "pass");
    CHECK(state(typed) == "not-judged");
    CHECK(state("D_a = \"=2*shell.R\"\ndelta = \"12 mm\"\n") == "not-judged");
    CHECK(state(typed + "because.delta = \"the jacket\"\n") == "pass");
  }
}
