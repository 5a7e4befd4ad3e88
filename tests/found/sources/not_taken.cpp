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
    CHECK(state("impact_factor = 1.4", column, "c", "buckling") == "not-judged");  // gamma_F includes no impact
    CHECK(state("load_factor = 1.35", column, "c", "buckling") == "pass");
    CHECK(state("load_factor = 1.5", column, "c", "buckling") == "not-judged");
  }

  TEST_CASE("requirements on the wall of a vessel") {
    CHECK(state("note = 1", shell, "s", "strength") == "pass");
    for (const char* const values :
         {"z_l = 0.7", "weld_factor = 0.85", "c_t = \"1.5 mm\"", "h_l = \"20 m\"", "p_design = \"1.6 MPa\"",
          "d_nozzle = \"400 mm\"", "N_cycles = 1e6", "T_min = \"-60 degC\""})
      CHECK_MESSAGE(state(values, shell, "s", "strength") == "not-judged", values);
    for (const char* const values :
         {"z_l = 1", "weld_factor = 1", "c = \"0.5 mm\"", "p_valve = \"1.1 MPa\"", "N_cycles = 100", "fill = 0.85"})
      CHECK_MESSAGE(state(values, shell, "s", "strength") == "pass", values);
    CHECK(state("d_nozzle = \"400 mm\"", shell + "accept.nozzles = \"sheet 3\"\n", "s", "strength") == "pass");
  }

  TEST_CASE("a length of [values] next to a key: a shorter key carries less") {
    const std::string key =
        "[k]\ncalculator = \"shaft.key\"\ntorque = \"one_way\"\nT = \"100 N*m\"\nK_A = 1.5\nd = \"50 mm\"\nkey = "
        "\"14x9\"\nl = \"45 mm\"\nl_n = \"50 mm\"\nR_e_1 = \"370 MPa\"\nR_e_2 = \"200 MPa\"\nR_e_k = \"420 MPa\"\n";
    CHECK(state("l = \"60 mm\"", key, "k", "shear") == "pass");
    CHECK(state("l = \"30 mm\"", key, "k", "shear") == "not-judged");
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

  TEST_CASE("the bearing type is that of its row") {
    CHECK(state("kind = \"deep_groove_ball\"", bearing, "b", "fatigue") == "pass");
  }

  TEST_CASE("the speed of a geared motor whose ratio the file states") {
    CHECK(state("note = 1", chain, "c", "joints") == "pass");
    CHECK(state("n_motor = \"1420 rpm\"", chain, "c", "joints") == "not-judged");
    CHECK(state("n_motor = \"1420 rpm\"\ni_gear = 23.67", chain, "c", "joints") == "pass");
    CHECK(state("n_motor = \"1420 rpm\"\ni_gear = 10", chain, "c", "joints") == "not-judged");
  }

  TEST_CASE("a relief, set or test pressure above that of a wall") {
    const auto thick = [](const std::string& values) {
      return state(
          values,
          "[t]\ncalculator = \"vessel.thick\"\np = \"40 MPa\"\nR = \"80 mm\"\nmeasured = \"inner\"\ndelta = \"40 "
          "mm\"\nR_e = \"355 MPa\"\nS = 1.5\n",
          "t", "strength");
    };
    CHECK(thick("note = 1") == "pass");
    for (const char* const values :
         {"p_relief = \"45 MPa\"", "relief_pressure = \"450 bar\"", "pset = \"44 MPa\"", "set_pressure = \"45 MPa\"",
          "p_test = \"60 MPa\"", "test_pressure = \"60 MPa\"", "P_hydrotest = \"60 MPa\"", "p_valve = \"50 MPa\""})
      CHECK_MESSAGE(thick(values) == "not-judged", values);
    for (const char* const values : {"p_relief = \"40 MPa\"", "p_valve = \"42 MPa\"", "sigma_test = \"60 MPa\""})
      CHECK_MESSAGE(thick(values) == "pass", values);
    CHECK(state("S = 1.5", shell, "s", "strength") == "pass");  // the allowable stress includes it
    CHECK(state("S = 3", shell, "s", "strength") == "not-judged");
    CHECK(state("d_nozzle = \"0 mm\"", shell, "s", "strength") == "pass");
  }

  TEST_CASE("conditions of the whole machine that no step uses") {
    for (const char* const values : {"wind = \"1 kN/m^2\"", "tilt_angle = \"5 deg\"", "restraints = \"none\""})
      CHECK_MESSAGE(state(values, column, "c", "buckling") == "not-judged", values);
    for (const char* const values : {"q_snow_roof = 1", "F_wind = \"4 kN\"", "tilt = \"0 deg\"", "restraints = \"3\""})
      CHECK_MESSAGE(state(values, column, "c", "buckling") == "pass", values);
    CHECK(state("wind = \"1 kN/m^2\"", column + "because.P = \"carried by the bracing\"\n", "c", "buckling") == "pass");
  }

  TEST_CASE("a load that is a fraction of a value by a bare number") {
    const auto shaft = [](const std::string& T, const std::string& more = "") {
      return state(
          "T = \"300 N*m\"\nshare = 0.5",
          "[s]\ncalculator = \"shaft.torsion\"\nd = \"60 mm\"\nmaterial = \"C45E\"\nS = 2\nT = \"" + T + "\"\n" + more,
          "s", "yield");
    };
    CHECK(shaft("=values.T") == "pass");
    CHECK(shaft("=0.9*values.T") == "pass");  // the losses of a drive
    CHECK(shaft("=0.5*values.T") == "not-judged");
    CHECK(shaft("=values.T/4") == "not-judged");
    CHECK(shaft("=values.share*values.T") == "pass");
    CHECK(shaft("=0.5*values.T", "because.T = \"two equal outputs\"\n") == "pass");
    const auto bar = [](const std::string& P) {
      std::string text = column;
      text.replace(text.find("400 kN"), 6, P);
      return state("F = \"400 kN\"\nn = 4", text, "c", "buckling");
    };
    CHECK(bar("=values.F/2") == "not-judged");
    CHECK(bar("=values.F/values.n") == "pass");
    CHECK(bar("=values.F/4") == "not-judged");
    CHECK(bar("=0.3*values.F") == "not-judged");
  }

  TEST_CASE("masses, friction and springs of a mechanism that are only in the values") {
    const auto crank = [](const std::string& values, const std::string& lines = "") {
      return state(values,
                   "[comp]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"40 mm\"\nl = \"180 "
                   "mm\"\ncrank = { speed = \"720 rpm\", positions = 36 }\nlinks.rod.mass = \"1.4 kg\"\n" +
                       lines +
                       "[rod]\ncalculator = \"link.member\"\nload = \"=comp.links.rod\"\nends_y = "
                       "\"pinned_pinned\"\nends_z = \"fixed_fixed\"\nbeta_basis = \"recommended\"\nh = \"28 mm\"\nb = "
                       "\"20 mm\"\nmethod = \"johnson\"\nn_st = 3\nS = 2\nmaterial = \"C45E\"\n",
                   "rod", "yield");
    };
    const std::string sound = crank("note = 1");
    CHECK(sound != "not-judged");
    for (const char* const values :
         {"m_rod = \"3 kg\"", "rod_mass = \"3 kg\"", "m_slider = \"5 kg\"", "m_piston = \"5 kg\"",
          "conrod_mass = \"3 kg\"", "mu = 0.15", "mu_B = 0.2", "k_spring = \"5 N/mm\""})
      CHECK_MESSAGE(crank(values) == "not-judged", values);
    CHECK(crank("m_crank = \"5 kg\"", "links.crank.mass = \"=0.1*values.m_crank\"\n") == "not-judged");
    CHECK(crank("m_crank = \"5 kg\"", "links.crank.mass = \"=values.m_crank/2\"\n") == sound);
    CHECK(crank("m_rod = \"3 kg\"", "because.links = \"of the forged rod\"\n") == sound);
    CHECK(crank("mu = 0.15", "because.joints = \"at standstill\"\n") == sound);
    CHECK(crank("m_crank = \"5 kg\"",
                "links.crank.mass = \"=0.1*values.m_crank\"\nbecause.\"links.crank.mass\" = \"hollow\"\n") == sound);
    for (const char* const values : {"m_rod = \"1.4 kg\"", "m_frame = \"240 kg\"", "mu_belt = 0.3"})
      CHECK_MESSAGE(crank(values) == sound, values);
  }
}
