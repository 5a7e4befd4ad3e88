// Regression tests of required safety factors, allowable stresses and strengths beyond common practice: a check that
// passes with them does not pass the part.
#include "tests/found/modes.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// A mode of a calculator's example that a line holds, and another line does not.
struct Practice {
  const char* calculator;
  std::string common;  // further lines
  const char *beyond, *within, *mode;
};

std::vector<Practice> safeties() {
  return {
      {"column.buckling", "", "n_st = 1", "n_st = 1.5", "buckling"},
      {"vessel.cylinder", "sigma_adm = \nmaterial = \"P265GH\"", "S = 1.2", "S = 1.5", "strength"},
      {"shaft.circlip", "", "S = 1", "S = 1.2", "groove"},
      {"fatigue.combined", "", "S_D = 1", "S_D = 1.2", "fatigue"},
      {"fatigue.combined", "", "S_F = 1", "S_F = 1.2", "yield"},
      {"fatigue.multiaxial", "", "S_D = 1", "S_D = 1.2", "fatigue"},
      {"fatigue.fkm", "", "j_D = 1", "j_D = 1.2", "fatigue"},
      {"fatigue.fkm", "j_p = 1.2", "j_m = 1", "j_m = 1.6", "yield"},
      {"shaft.torsion", "tau_adm = \nR_e = \"370 MPa\"", "S = 1", "S = 1.2", "yield"},
      {"shaft.press_fit", "", "S_r = 1", "S_r = 1.2", "slip"},
      {"bearing.rolling", "", "s_0 = 0.45", "s_0 = 0.5", "static"},
      {"bearing.rolling", "", "L_h = \"50 h\"", "L_h = \"500 h\"", "fatigue"},
      {"gear.rating", "", "L_h = \"50 h\"", "L_h = \"5000 h\"", "pitting_1"},
      {"column.buckling", "", "lambda_max = 350", "lambda_max = 200", "slenderness"},
  };
}

std::vector<Practice> strengths() {
  return {
      {"vessel.sphere", "", "sigma_adm = \"900 MPa\"", "sigma_adm = \"300 MPa\"", "strength"},
      {"pin.joint", "", "p_adm_1 = \"900 MPa\"", "p_adm_1 = \"250 MPa\"", "eye"},
      {"pin.lug", "", "p_adm = \"900 MPa\"", "p_adm = \"250 MPa\"", "bearing"},
      {"pin.cross", "", "p_adm_2 = \"900 MPa\"", "p_adm_2 = \"100 MPa\"", "hub_bore"},
      {"pin.en1993", "f_yp = \"640 MPa\"", "f_up = \"1500 MPa\"", "f_up = \"800 MPa\"", "shear"},
      {"shaft.key", "R_e_2 = ", "p_adm_2 = \"1000 MPa\"", "p_adm_2 = \"270 MPa\"", "hub"},
      {"shaft.key", "", "R_e_1 = \"2000 MPa\"", "R_e_1 = \"900 MPa\"", "shaft"},
      {"fatigue.fkm", "", "R_pmax = \"9000 MPa\"", "R_pmax = \"1050 MPa\"", "yield"},
      {"shaft.torsion", "", "tau_adm = \"900 MPa\"", "tau_adm = \"100 MPa\"", "yield"},
  };
}

std::vector<Practice> sizes() {
  return {
      {"shaft.torsion", "", "theta_adm = \"50 deg/m\"", "theta_adm = \"1 deg/m\"", "twist"},
      {"shaft.held", "", "phi_adm = \"1 rad\"", "phi_adm = \"2 deg\"", "rotation"},
      {"pin.en1993", "", "d_0 = \"60 mm\"", "d_0 = \"52 mm\"", "plate_1"},
      {"shaft.press_fit", "", "U_min = \"85 um\"", "U_min = \"60 um\"", "slip"},
      {"shaft.press_fit", "", "U_min = \"85 um\"", "U_min = \"90 um\"", "slip"},  // one interference, as in a book
      {"shaft.press_fit", "", "Rz_1 = \"4 nm\"", "Rz_1 = \"0.4 um\"", "slip"},
      {"shaft.press_fit", "", "Rz_2 = \"4 nm\"", "Rz_2 = \"0 um\"", "slip"},  // U_min is the effective interference
      {"chain.inverted_tooth", "", "q = \"0.025 kg/m\"", "q = \"2.5 kg/m\"", "breaking"},
      {"gear.worm", "", "A_h = \"2.5 m^2\"", "A_h = \"0.8 m^2\"", "heat"},  // a = 100 mm: 43.2 a^1.7 is 0.286 m^2
      {"fatigue.endurance", "R_z = \"6.3 um\"", "R_z = \"6.3 nm\"", "R_z = \"0.1 um\"", "surface"},
  };
}

void check(const Practice& p) {
  const std::string lines = p.common.empty() ? "" : p.common + "\n", of = p.calculator;
  INFO(of);
  CHECK_MESSAGE(mode_with(of, lines + p.beyond, p.mode) == "not-judged", std::string(p.beyond));
  CHECK_MESSAGE(mode_with(of, lines + p.within, p.mode) == "pass", std::string(p.within));
}

}  // namespace

TEST_SUITE("found common practice") {
  TEST_CASE("a strength that most parts do not reach needs a reason") {
    const auto life = [](const std::string& P) {
      return mode_of(solved_as_found("[limit]\ncalculator = \"fatigue.survival\"\nsigma_0 = \"200 MPa\"\nT_S = 1.25\n"
                                     "k = 5\nP_0 = 0.9\nP = " +
                                     P +
                                     "\n[life]\ncalculator = \"fatigue.life\"\nsigma_max = \"100 MPa\"\n"
                                     "sigma_min = \"-100 MPa\"\nsigma_D = \"=limit.sigma_P\"\n"
                                     "group = \"carbon-steel\"\nR_m = \"900 MPa\"\nR_e = \"700 MPa\"\nS_D = 1.3\n"
                                     "S_F = 1.3\n"),
                     "limit", "tail");
    };
    CHECK(life("0.05") == "not-judged");
    CHECK(life("0.95") != "not-judged");
  }

  TEST_CASE("a required safety factor below common practice needs a reason") {
    for (const Practice& p : safeties()) check(p);
  }

  TEST_CASE("deformations, holes and fits beyond common practice want a reason") {
    for (const Practice& p : sizes()) check(p);
  }

  TEST_CASE("an allowable stress or a strength above common practice needs a reason") {
    for (const Practice& p : strengths()) check(p);
  }

  TEST_CASE("a reason is enough, and one that is not needed is an error") {
    CHECK(mode_with("column.buckling", "n_st = 1\nbecause.n_st = \"load is P_cr/3\"", "buckling") == "pass");
    const std::string rod =
        "[rod]\ncalculator = \"column.buckling\"\nP = \"30 kN\"\nl = \"900 mm\"\nd = \"45 mm\"\nends = "
        "\"fixed_free\"\nE = \"210 GPa\"\nR_e = \"340 MPa\"\nsigma_P = \"270 MPa\"\nmethod = \"euler\"\nn_st = 2\n";
    CHECK(first_error_of(rod).empty());
    CHECK(first_error_of(rod + "because.n_st = \"tests\"\n").find("is not needed") != std::string::npos);
  }

  TEST_CASE("a failing part fails with reasons, too") {
    CHECK(mode_with("column.buckling", "n_st = 1\nP = \"300 kN\"", "buckling") == "fail");
  }

  TEST_CASE("an allowable stress next to the yield strength needs a reason") {
    const auto state = [](const char* sigma_adm) {
      return mode_with("vessel.cylinder", std::string("material = \"P265GH\"\nsigma_adm = \"") + sigma_adm + "\"",
                       "strength");
    };
    for (const char* const sigma_adm : {"300 MPa", "265 MPa", "250 MPa"})  // R_e = 265 MPa
      CHECK_MESSAGE(state(sigma_adm) == "not-judged", std::string(sigma_adm));
    CHECK(state("170 MPa") == "pass");
  }

  TEST_CASE("an irregular flywheel is found, and does not pass without a reason") {
    const auto state = [](const char* delta) {
      return mode_with("machine.flywheel", std::string("delta = ") + delta, "unevenness");
    };
    CHECK(state("1.5") == "not-judged");
    CHECK(state("0.2") == "pass");
    CHECK(mode_with("machine.flywheel", "D = \"6 m\"\nv_adm = \"400 m/s\"", "bursting") == "not-judged");
    CHECK(mode_with("machine.flywheel", "D = \"2 m\"\nv_adm = \"30 m/s\"", "bursting") == "pass");
  }
}
