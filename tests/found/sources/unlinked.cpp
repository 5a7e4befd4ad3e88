// Regression tests of steps that describe one machine and do not refer to each other.
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

std::string bearing(const std::string& name, const std::string& carries, const std::string& F_r,
                    const std::string& mate) {
  return "[" + name + "]\ncalculator = \"bearing.rolling\"\nbearing = \"30208\"\nF_r = \"" + F_r +
         "\"\nF_a = \"2 kN\"\ncarries = \"" + carries +
         "\"\nn = \"900 rpm\"\nL_h = \"10000 h\"\ns_0 = 2\nmate = { F_r = \"" + mate + "\", Y = 1.6 }\n\n";
}

std::string limit_and_life(const std::string& sigma_D, const std::string& material = "C45E") {
  const std::string of = "\"\nd_h = \"40 mm\"\n";
  return "[limit]\ncalculator = \"fatigue.endurance\"\nmaterial = \"C45E" + of +
         "loading = \"bending\"\nR_z = \"6.3 um\"\nd = \"40 mm\"\n\n"
         "[life]\ncalculator = \"fatigue.cycle\"\nsigma_max = \"100 MPa\"\nsigma_min = \"-100 MPa\"\nS_D = 1.5\n"
         "S_F = 1.5\nmaterial = \"" +
         material + of + "sigma_D = " + sigma_D + "\n";
}

}  // namespace

TEST_SUITE("found unlinked steps") {
  TEST_CASE("an end whose pressure is typed beside a shell refers to it, or is of another vessel") {
    const std::string typed = "p = \"1 MPa\"\nD_i = \"1000 mm\"\nc = \"1 mm\"\n";
    CHECK(mode_of(solved_as_found(shell_and(typed)), "head", "strength") == "not-judged");
    CHECK(mode_of(solved_as_found(shell_and("shell = \"=shell.shell\"\n")), "head", "strength") == "pass");
    CHECK(mode_of(solved_as_found(shell_and(typed + "because.p = \"of the heater\"\n")), "head", "strength") == "pass");
  }

  TEST_CASE("of two mates one carries the axial force in each direction") {
    const auto state = [](const std::string& other) {
      return mode_of(solved_as_found(bearing("l", "right", "4 kN", "3 kN") + bearing("r", other, "3 kN", "4 kN")), "l",
                     "fatigue");
    };
    CHECK(state("left") == "pass");
    CHECK(state("right") == "not-judged");
  }

  TEST_CASE("a fatigue limit is not typed beside the step that finds it") {
    CHECK(mode_of(solved_as_found(limit_and_life("\"200 MPa\"")), "life", "fatigue") == "not-judged");
    CHECK(mode_of(solved_as_found(limit_and_life("\"200 MPa\"", "42CrMo4")), "life", "fatigue") == "pass");
    CHECK(mode_of(solved_as_found(limit_and_life("\"=limit.sigma_D\"")), "life", "fatigue") == "pass");
  }
}
