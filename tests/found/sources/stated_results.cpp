// Regression tests of [values] that no step uses and that name a result, a limit, a row of a list, or a peak of a load.
#include "tests/found/modes.hpp"

#include <algorithm>
#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// Whether a step passes a mode with this value, as it does without it.
bool is_held(const std::string& value, const std::string& steps, std::string_view step, std::string_view mode) {
  CHECK(mode_of(solved_as_found(steps), step, mode) == "pass");
  const std::string state = mode_of(solved_as_found("[values]\n" + value + "\n\n" + steps), step, mode);
  CHECK((state == "pass" || state == "not-judged"));
  return state == "not-judged";
}

// i = 500/200 = 2.5, n_2 = 1450 0.99/2.5 = 574.2 rpm, v = pi 0.2 m 1450/min = 15.2 m/s.
const std::string belt =
    "[belt]\ncalculator = \"belt.flat\"\nP = \"15 kW\"\nK_A = 1.2\nn_1 = \"1450 rpm\"\nd_1 = \"200 mm\"\nd_2 = \"500 "
    "mm\"\na = \"1200 mm\"\nmu = 0.4\nkind = \"synthetic\"\ndelta = \"2.5 mm\"\nrho = \"1100 kg/m^3\"\nsigma_adm = \"6 "
    "MPa\"\nE_b = \"40 MPa\"\n";

// u = 84/21 = 4, m_n = 3 mm in both steps.
const std::string gears =
    "[pair]\ncalculator = \"gear.pair\"\nz_1 = 21\nz_2 = 84\nm_n = \"3 mm\"\nx_1 = 0.3\nb = \"45 mm\"\nT_1 = \"60 "
    "N*m\"\nn_1 = \"730 rpm\"\nsigma_adm_1 = \"200 MPa\"\nsigma_adm_2 = \"200 MPa\"\nK_f = 1.5\ncutting = "
    "\"hobbed\"\n[rating]\ncalculator = \"gear.rating\"\nmesh = \"=pair.mesh\"\ngrade = 7\nmaterial_1 = "
    "\"case\"\nquality_1 = \"MQ\"\nH_1 = 700\nmaterial_2 = \"case\"\nquality_2 = \"MQ\"\nH_2 = 700\nplace = "
    "\"middle\"\nS_Hmin = 1.1\nS_Fmin = 1.5\n";

const std::string run_up =
    "[run]\ncalculator = \"machine.run_up\"\nparts = [{ name = \"rotor\", J = \"0.2 kg*m^2\" }, { name = \"drum\", J "
    "= \"3 kg*m^2\", u = 0.2 }]\nmotor = [[\"0 rpm\", \"80 N*m\"], [\"1450 rpm\", \"60 N*m\"]]\nload = [[\"0 rpm\", "
    "\"10 N*m\"], [\"1450 rpm\", \"20 N*m\"]]\nn_2 = \"1440 rpm\"\nt_adm = \"5 s\"\n";

const std::string bearing =
    "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6308\"\nF_r = \"2 kN\"\nn = \"1000 rpm\"\nL_h = \"10000 "
    "h\"\ns_0 = 1.5\n";

const std::string lug =
    "[lug]\ncalculator = \"pin.lug\"\nF = \"=values.Q\"\nd = \"40 mm\"\nb = \"110 mm\"\na = \"38 mm\"\nt = \"25 "
    "mm\"\np_adm = \"90 MPa\"\nmaterial = \"S355\"\nS = 2\n";

}  // namespace

TEST_SUITE("found names of results") {
  TEST_CASE("a ratio, a speed or a size under the name of a result") {
    for (const char* const value : {"i = 4", "n_2 = \"900 rpm\"", "v = \"10 m/s\""})
      CHECK_MESSAGE(is_held(value, belt, "belt", "strength"), value);
    for (const char* const value : {"i = 2.5", "n_2 = \"570 rpm\"", "n_2 = \"-574 rpm\"", "v = \"15 m/s\"", "e = 4"})
      CHECK_MESSAGE(!is_held(value, belt, "belt", "strength"), value);
  }

  TEST_CASE("the ratio of a gear pair, and a module that pair and rating have") {
    for (const char* const value : {"i = 6", "m_n = \"4 mm\""})
      CHECK_MESSAGE(is_held(value, gears, "pair", "root_1"), value);
    for (const char* const value : {"i = 4", "m_n = \"3 mm\""})
      CHECK_MESSAGE(!is_held(value, gears, "pair", "root_1"), value);
  }

  TEST_CASE("a limit that a size, a speed or a time does not keep") {
    for (const char* const value :
         {"v_max = \"14 m/s\"", "b_max = \"20 mm\"", "a_max = \"1 m\"", "d_1_min = \"224 mm\""})
      CHECK_MESSAGE(is_held(value, belt, "belt", "strength"), value);
    for (const char* const value :
         {"v_max = \"30 m/s\"", "b_max = \"2 m\"", "a_max = \"1.2 m\"", "d_1_min = \"180 mm\""})
      CHECK_MESSAGE(!is_held(value, belt, "belt", "strength"), value);
    CHECK(is_held("t_max = \"0.5 s\"", run_up, "run", "time"));
    CHECK_FALSE(is_held("t_max = \"5 s\"", run_up, "run", "time"));
  }

  TEST_CASE("the value of a row by its name") {
    for (const char* const value : {"J_rotor = \"2 kg*m^2\"", "u_drum = 0.4", "J_fan = \"9 kg*m^2\""})
      CHECK_MESSAGE(is_held(value, run_up, "run", "time"), value);
    for (const char* const value :
         {"J_rotor = \"0.2 kg*m^2\"", "J_rotor = \"0.1 kg*m^2\"", "u_drum = 0.2", "m_drum = \"80 kg\""})
      CHECK_MESSAGE(!is_held(value, run_up, "run", "time"), value);
  }

  TEST_CASE("a test load of the value that a load is computed from") {
    const auto state = [](const std::string& test) {
      return mode_of(solved_as_found("[values]\nQ = \"40 kN\"\n" + test + lug), "lug", "bearing");
    };
    CHECK(state("") == "pass");
    CHECK(state("Q_test = \"50 kN\"\n") == "not-judged");
    CHECK(state("Q_test = \"40 kN\"\n") == "pass");
    CHECK(state("Q_hook = \"50 kN\"\n") == "pass");
  }

  TEST_CASE("a load below which the largest one that is found lies") {
    const std::string shell =
        "[shell]\ncalculator = \"vessel.cylinder\"\np = \"?\"\nR = \"400 mm\"\ndelta = \"8 mm\"\n"
        "c = \"1 mm\"\nz_l = 0.85\nmaterial = \"P265GH\"\nS = 1.5\n";
    CHECK(is_held("p = \"9 MPa\"", shell, "shell", "strength"));
    CHECK_FALSE(is_held("p = \"1 MPa\"", shell, "shell", "strength"));
  }

  TEST_CASE("a speed above the maximum speed of a disc") {
    const std::string disc =
        "[disc]\ncalculator = \"machine.disc\"\nn = \"3000 rpm\"\nD = \"400 mm\"\nd_i = \"60 mm\"\n"
        "b = \"40 mm\"\nmaterial = \"C45E\"\nS = 2\n";
    CHECK(is_held("n_max = \"4000 rpm\"", disc, "disc", "strength"));
    CHECK_FALSE(is_held("n_max = \"3000 rpm\"", disc, "disc", "strength"));
  }

  TEST_CASE("a limit of a size that a row has") {
    const std::string post =
        "[post]\ncalculator = \"column.buckling\"\nP = \"100 kN\"\nl = \"3 m\"\nends = \"pinned_pinned\"\nsection = "
        "\"HEB 160\"\nmaterial = \"S235JR\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1.4\n";
    CHECK(is_held("h_max = \"120 mm\"", post, "post", "buckling"));
    CHECK_FALSE(is_held("h_max = \"160 mm\"", post, "post", "buckling"));
  }

  TEST_CASE("the speed of a machine that no crank has") {
    const std::string mechanism =
        "[pump]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"30 mm\"\nl = \"180 mm\"\n"
        "crank = { speed = \"60 rpm\", positions = 72 }\nlinks.slider.mass = \"5 kg\"\n"
        "loads = [{ name = \"oil\", link = \"slider\", at = \"B\", F_x = \"-5 kN\", F_y = \"0 N\" }]\n";
    const auto is_doubted = [&](const std::string& value) {
      const auto modes = project::modes(solved_as_found("[values]\n" + value + "\n" + mechanism));
      return std::ranges::any_of(modes, [](const account::Mode& mode) {
        return mode.note.text().find("crank.speed is 60 rpm here") != std::string::npos;
      });
    };
    CHECK(is_doubted("n = \"180 rpm\""));
    CHECK_FALSE(is_doubted("n = \"60 rpm\""));
    CHECK_FALSE(is_doubted("n_fan = \"180 rpm\""));
  }

  TEST_CASE("the life of a part by its name") {
    CHECK(is_held("L_h_gears = \"40000 h\"", bearing, "b", "fatigue"));
    CHECK_FALSE(is_held("L_h_gears = \"8000 h\"", bearing, "b", "fatigue"));
  }
}
