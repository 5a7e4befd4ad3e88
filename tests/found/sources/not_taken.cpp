// Regression tests of inputs and conditions of service that [values] state and no step takes.
#include "tests/found/modes.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string with(const std::string& values, const std::string& steps) { return "[values]\n" + values + "\n\n" + steps; }

std::string state(const std::string& values, const std::string& steps, std::string_view step, std::string_view mode) {
  return mode_of(solved_as_found(with(values, steps)), step, mode);
}

const std::string column =
    "[c]\ncalculator = \"column.buckling\"\nP = \"400 kN\"\nl = \"3.5 m\"\nends = \"pinned_pinned\"\nsection = \"HEB "
    "160\"\nmaterial = \"S355\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1.35\n";

const std::string shell =
    "[s]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\nmeasured = \"inner\"\nc = \"1 mm\"\nz_l = "
    "1\nsigma_adm = \"140 MPa\"\ndelta = \"12 mm\"\n";

const std::string disc =
    "[d]\ncalculator = \"machine.disc\"\nn = \"3000 rpm\"\nD = \"500 mm\"\nd_i = \"80 mm\"\nb = \"30 mm\"\nmaterial = "
    "\"42CrMo4\"\nS = 2\n";

const std::string lug =
    "[e]\ncalculator = \"pin.lug\"\nF = \"50 kN\"\nd = \"40 mm\"\nb = \"110 mm\"\na = \"38 mm\"\nt = \"25 mm\"\np_adm "
    "= "
    "\"90 MPa\"\nmaterial = \"S355\"\nS = 2\n";

const std::string bearing =
    "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6309\"\nF_r = \"6 kN\"\nn = \"1200 rpm\"\nL_h = \"3000 "
    "h\"\ns_0 "
    "= 1.5\n";

const std::string chain =
    "[c]\ncalculator = \"chain.roller\"\nchain = \"20B\"\nz_1 = 19\nz_2 = 38\na = \"1000 mm\"\nn_1 = \"60 rpm\"\nP = "
    "\"2 kW\"\nK_A = 1.4\np_adm = \"30 MPa\"\nS_min = 8\nP_R = \"6 kW\"\n";

}  // namespace

TEST_SUITE("found values not taken") {
  TEST_CASE("a value of [values] under the name of an input that has another value") {
    CHECK(state("note = 1", column, "c", "buckling") == "pass");
    CHECK(state("beta_z = 2", column, "c", "buckling") == "not-judged");
    CHECK(state("ends = \"fixed_free\"", column, "c", "buckling") == "not-judged");
    CHECK(state("ends = \"pinned_pinned\"", column, "c", "buckling") == "pass");
    CHECK(state("l = \"7 m\"", column, "c", "buckling") == "not-judged");
    CHECK(state("l = \"3.5 m\"", column, "c", "buckling") == "pass");
    CHECK(state("l = \"7 m\"", column + "because.l = \"a brace at mid-length\"\n", "c", "buckling") == "pass");
    CHECK(state("material = \"S235\"", column, "c", "buckling") == "not-judged");
    CHECK(state("material = \"S355\"", column, "c", "buckling") == "pass");
  }

  TEST_CASE("an eccentricity or a bending load of [values] next to a bar in compression") {
    for (const char* const values : {"e_y = \"60 mm\"", "M_y = \"30 kN*m\"", "q_z = \"20 N/mm\"", "F_z = \"20 kN\""})
      CHECK(state(values, column, "c", "buckling") == "not-judged");
    CHECK(state("gamma_Q = 1.5", column, "c", "buckling") == "not-judged");
    CHECK(state("gamma_Q = 1.35", column, "c", "buckling") == "pass");
  }

  TEST_CASE("requirements on the wall of a vessel") {
    CHECK(state("note = 1", shell, "s", "strength") == "pass");
    for (const char* const values :
         {"z_l = 0.7", "weld_factor = 0.85", "c_t = \"1.5 mm\"", "h_l = \"20 m\"", "p_design = \"1.6 MPa\"",
          "d_nozzle = \"400 mm\"", "N_cycles = 1e6", "T_min = \"-60 degC\""})
      CHECK_MESSAGE(state(values, shell, "s", "strength") == "not-judged", values);
    for (const char* const values : {"z_l = 1", "c = \"0.5 mm\"", "p_valve = \"1.1 MPa\"", "N_cycles = 100"})
      CHECK_MESSAGE(state(values, shell, "s", "strength") == "pass", values);
    CHECK(state("d_nozzle = \"400 mm\"", shell + "accept.nozzles = \"sheet 3\"\n", "s", "strength") == "pass");
  }

  TEST_CASE("an overspeed, a dynamic factor, a reliability") {
    CHECK(state("n_over = \"3450 rpm\"", disc, "d", "strength") == "not-judged");
    CHECK(state("n_over = \"30000 rpm\"", disc, "d", "strength") == "pass");
    CHECK(state("phi = 1.15", lug, "e", "bearing") != state("note = 1.15", lug, "e", "bearing"));
    CHECK(state("reliability = 0.99", bearing, "b", "fatigue") == "not-judged");
    CHECK(state("reliability = 0.9", bearing, "b", "fatigue") == "pass");
  }

  TEST_CASE("constants of a material with the digits of another table, and of another substance") {
    for (const char* const values : {"rho = \"7850 kg/m^3\"", "rho = \"1600 kg/m^3\"", "E = \"206 GPa\"", "nu = 0.29"})
      CHECK_MESSAGE(state(values, disc, "d", "strength") == "pass", values);
    for (const char* const values : {"rho = \"8900 kg/m^3\"", "E = \"110 GPa\""})
      CHECK_MESSAGE(state(values, disc, "d", "strength") == "not-judged", values);
    CHECK(state("E = \"206 GPa\"", column, "c", "buckling") == "pass");
    CHECK(state("E = \"70 GPa\"", column, "c", "buckling") == "not-judged");
  }

  TEST_CASE("the kind of a bearing that its row has") {
    CHECK(state("kind = \"deep_groove_ball\"", bearing, "b", "fatigue") == "pass");
  }

  TEST_CASE("the speed of a geared motor whose ratio the file states") {
    CHECK(state("note = 1", chain, "c", "joints") == "pass");
    CHECK(state("n_motor = \"1420 rpm\"", chain, "c", "joints") == "not-judged");
    CHECK(state("n_motor = \"1420 rpm\"\ni_gear = 23.67", chain, "c", "joints") == "pass");
    CHECK(state("n_motor = \"1420 rpm\"\ni_gear = 10", chain, "c", "joints") == "not-judged");
  }
}
