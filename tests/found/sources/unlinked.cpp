// Regression tests of steps that describe one machine and do not refer to each other.
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string bearing(const std::string& name, const std::string& carries, const std::string& F_r,
                    const std::string& mate, const std::string& Y = "1.6") {
  return "[" + name + "]\ncalculator = \"bearing.rolling\"\nbearing = \"30208\"\nF_r = \"" + F_r +
         "\"\nF_a = \"2 kN\"\ncarries = \"" + carries +
         "\"\nn = \"900 rpm\"\nL_h = \"10000 h\"\ns_0 = 2\nmate = { F_r = \"" + mate + "\", Y = " + Y + " }\n\n";
}

std::string limit_and_life(const std::string& sigma_D, const std::string& material = "C45E") {
  const std::string of = "\"\nd_h = \"40 mm\"\n";
  return "[limit]\ncalculator = \"fatigue.endurance\"\nmaterial = \"C45E" + of +
         "loading = \"bending\"\nR_z = \"6.3 um\"\nd = \"40 mm\"\n\n"
         "[life]\ncalculator = \"fatigue.cycle\"\nsigma_max = \"100 MPa\"\nsigma_min = \"-100 MPa\"\nS_D = 1.5\n"
         "S_F = 1.5\nmaterial = \"" +
         material + of + "sigma_D = " + sigma_D + "\n";
}

std::string bar_and_life(const std::string& loading) {
  return "[limit]\ncalculator = \"fatigue.endurance\"\nmaterial = \"C45E\"\nd_h = \"20 mm\"\nd = \"20 mm\"\n"
         "finish = \"machined\"\nrule = \"shigley\"\nschool = \"marin\"\nP_s = 0.99\nloading = \"" +
         loading +
         "\"\n\n[rod]\ncalculator = \"link.member\"\nN = \"10 kN\"\nV = \"0 N\"\nM_b = \"0 N*m\"\nends = "
         "\"pinned_pinned\"\nl = \"200 mm\"\nd = \"20 mm\"\n"
         "material = \"C45E\"\nS = 1.5\n\n[life]\ncalculator = \"fatigue.cycle\"\ncycle = \"=rod.cycle\"\nr = -1\n"
         "S_D = 1.5\nS_F = 1.5\nmaterial = \"C45E\"\nd_h = \"20 mm\"\nsigma_D = \"=limit.sigma_D\"\n";
}

std::string post(const std::string& name, const std::string& P, const std::string& gamma_F) {
  return "[" + name + "]\ncalculator = \"column.buckling\"\nP = \"" + P +
         "\"\nl = \"2 m\"\nends = \"pinned_pinned\"\n" +
         "section = \"HEA 140\"\nmaterial = \"S235\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = " + gamma_F + "\n";
}

std::string hoist_and(const std::string& run_up) {
  return "[hoist]\ncalculator = \"dynamics.lift\"\ns = \"1 m\"\nweights = [{ m = \"900 kg\", i = -1 }]\n"
         "wheels = [{ J = \"6 kg*m^2\", r = \"250 mm\", M_d = \"2500 N*m\" }]\n\n[run_up]\n"
         "calculator = \"machine.run_up\"\nparts = [{ J = \"0.012 kg*m^2\" }]\n"
         "motor = [[\"0 rpm\", \"15 N*m\"], [\"1440 rpm\", \"10 N*m\"]]\nn_2 = \"1440 rpm\"\nt_adm = \"5 s\"\n" +
         run_up;
}

}  // namespace

TEST_SUITE("found unlinked steps") {
  TEST_CASE("of two opposed bearings one carries the axial force in each direction") {
    const auto state = [](const std::string& other) {
      return mode_of(solved_as_found(bearing("l", "right", "4 kN", "3 kN") + bearing("r", other, "3 kN", "4 kN")), "l",
                     "fatigue");
    };
    CHECK(state("left") == "pass");
    CHECK(state("right") == "not-judged");
  }

  TEST_CASE("two opposed bearings with an arrangement have the same one") {
    const auto arranged = [](const std::string& name, const std::string& way, const std::string& loads) {
      return "[" + name + "]\ncalculator = \"bearing.rolling\"\nbearing = \"30208\"\nF_a = \"2 kN\"\narrangement = \"" +
             way + "\"\nn = \"900 rpm\"\nL_h = \"10000 h\"\ns_0 = 2\n" + loads;
    };
    const std::string of_left = "F_r = \"4 kN\"\nx = \"50 mm\"\nmate = { F_r = \"3 kN\", Y = 1.6, x = \"250 mm\" }\n\n";
    const std::string of_right =
        "F_r = \"3 kN\"\nx = \"250 mm\"\nmate = { F_r = \"4 kN\", Y = 1.6, x = \"50 mm\" }\n\n";
    const auto state = [&](const std::string& other) {
      return mode_of(solved_as_found(arranged("l", "back_to_back", of_left) + arranged("r", other, of_right)), "l",
                     "fatigue");
    };
    CHECK(state("back_to_back") == "pass");
    CHECK(state("face_to_face") == "not-judged");
  }

  TEST_CASE("the load of the opposed bearing is that of its own step") {
    const auto state = [](const std::string& of_mate) {
      return mode_of(solved_as_found(bearing("l", "right", "4 kN", "3 kN") + bearing("r", "left", "3 kN", of_mate)),
                     "r", "fatigue");
    };
    CHECK(state("4 kN") == "pass");
    CHECK(state("1 kN") == "not-judged");
  }

  TEST_CASE("the factor of the opposed bearing is that of its row") {  // Y = 1.6 of a 30208
    const auto state = [](const std::string& Y) {
      return mode_of(solved_as_found(bearing("l", "right", "4 kN", "3 kN", Y) + bearing("r", "left", "3 kN", "4 kN")),
                     "l", "fatigue");
    };
    CHECK(state("1.6") == "pass");
    CHECK(state("1.4") == "pass");
    CHECK(state("6") == "not-judged");
  }

  TEST_CASE("a factor of one load is the same in all steps that share it") {
    const auto state = [](const std::string& P, const std::string& gamma_F) {
      const std::string text = "[values]\nP = \"100 kN\"\n" + post("a", P, gamma_F) + post("b", "=values.P", "1.5");
      return mode_of(solved_as_found(text), "a", "buckling");
    };
    CHECK(state("=values.P", "1") == "not-judged");
    CHECK(state("=1*values.P", "1") == "not-judged");
    CHECK(state("=values.P", "1.5") == "pass");
  }

  TEST_CASE("a density belongs to the modulus of the same metal") {
    const auto state = [](const std::string& rho) {
      return mode_with("machine.disc", "E = \"210 GPa\"\nrho = \"" + rho + "\"", "strength");
    };
    CHECK(state("785 kg/m^3") == "not-judged");
    CHECK(state("7850 kg/m^3") == "pass");
  }

  TEST_CASE("a fatigue limit is not typed next to the step that calculates it") {
    CHECK(mode_of(solved_as_found(limit_and_life("\"400 MPa\"")), "life", "fatigue") == "not-judged");
    CHECK(mode_of(solved_as_found(limit_and_life("\"200 MPa\"", "42CrMo4")), "life", "fatigue") == "pass");
    CHECK(mode_of(solved_as_found(limit_and_life("\"=limit.sigma_D\"")), "life", "fatigue") == "pass");
  }

  TEST_CASE("a bar in tension has the fatigue limit in tension, not that in bending") {
    CHECK(mode_of(solved_as_found(bar_and_life("bending")), "life", "fatigue") == "not-judged");
    CHECK(mode_of(solved_as_found(bar_and_life("tension")), "life", "fatigue") == "pass");
  }

  TEST_CASE("a motor in a file with a hoist lifts its weights, or a reason is given") {
    const auto state = [](const std::string& more) {
      return mode_of(solved_as_found(hoist_and(more)), "run_up", "time");
    };
    CHECK(state("") == "not-judged");
    CHECK(state("load = [[\"0 rpm\", \"2 N*m\"], [\"1440 rpm\", \"2 N*m\"]]\n") == "pass");
    CHECK(state("because.motor = \"without the cage\"\n") == "pass");
  }

  TEST_CASE("an allowable stress by the strength of a thinner part needs a reason") {
    const auto with = [](const std::string& d) {
      return "[probe]\ncalculator = \"shaft.torsion\"\nT = \"50 N*m\"\nd = \"16 mm\"\nmaterial = \"C45E\"\nS = 1.5\n\n"
             "[s]\ncalculator = \"shaft.torsion\"\nT = \"50 N*m\"\nd = \"" +
             d + "\"\ntau_adm = \"=0.3*probe.R_e\"\n";
    };
    CHECK(mode_of(solved_as_found(with("90 mm")), "s", "yield") == "not-judged");
    CHECK(mode_of(solved_as_found(with("16 mm")), "s", "yield") == "pass");
  }
}
