// Regression tests of data that no metal, belt, bearing or drive has.
#include "tests/found/modes.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// A mode of a calculator's example that a line holds, and another line does not.
struct Data {
  const char* calculator;
  std::string common;  // further lines
  const char *impossible, *usual, *mode;
};

std::vector<Data> properties() {
  return {
      {"column.buckling", "", "E = \"300 GPa\"", "E = \"210 GPa\"", "buckling"},
      {"shaft.torsion", "theta_adm = \"0.003 rad/m\"", "G = \"300 GPa\"", "", "twist"},
      {"shaft.press_fit", "material = \nU_c = \ndT_adm = \nnu_1 = 0.3\nnu_2 = 0.3\nE_1 = \"210 GPa\"",
       "E_2 = \"300 GPa\"", "E_2 = \"210 GPa\"", "slip"},
      {"shaft.press_fit", "T = \"500 N*m\"", "mu = 0.3", "mu = 0.18", "slip"},
      {"fatigue.combined", "", "sigma_D = \"440 MPa\"", "sigma_D = \"300 MPa\"", "fatigue"},
      {"fatigue.combined", "sigma_D = \"400 MPa\"", "tau_D = \"270 MPa\"", "tau_D = \"220 MPa\"", "fatigue"},
      {"fatigue.multiaxial", "tau_D = \"240 MPa\"", "sigma_D = \"480 MPa\"", "sigma_D = \"400 MPa\"", "fatigue"},
      {"fatigue.multiaxial", "sigma_D = \"440 MPa\"", "tau_D = \"270 MPa\"", "tau_D = \"240 MPa\"", "fatigue"},
      {"fatigue.din743", "", "sigma_bW = \"760 MPa\"", "sigma_bW = \"550 MPa\"", "fatigue"},
      {"fatigue.fkm", "", "sigma_W = \"760 MPa\"", "sigma_W = \"500 MPa\"", "fatigue"},
      {"fatigue.din743", "notch = \"alpha\"\nD = \nalpha_t = 1.4", "alpha_b = 1", "alpha_b = 1.8", "fatigue"},
      {"bearing.rolling", "", "n_max = \"200000 rpm\"", "n_max = \"17000 rpm\"", "speed"},
      {"bearing.rolling", "", "P_min = \"0.001 kN\"", "P_min = \"0.3 kN\"", "skidding"},
      {"belt.course", "", "q = \"0.01 kg/m\"", "q = \"0.1 kg/m\"", "strength"},
      {"gear.pair", "K_f = 1.5\nT_1 = \"30 N*m\"", "Y_1 = 0.95", "Y_1 = 0.4", "root_1"},
      {"vessel.cylinder", "p = \"0.1 MPa\"\nh_l = \"6 m\"", "rho = \"1 kg/m^3\"", "rho = \"1000 kg/m^3\"", "strength"},
  };
}

std::string rod_of(const std::string& row) {
  return "[rod]\ncalculator = \"column.buckling\"\nP = \"30 kN\"\nl = \"900 mm\"\nd = \"45 mm\"\nends = "
         "\"fixed_free\"\nmaterial = \"own\"\nsigma_P = \"270 MPa\"\nmethod = \"euler\"\nn_st = 3\n"
         "[tables.materials.own]\nsource = \"store\"\nkind = \"steel\"\nR_e = \"340 MPa\"\nR_m = \"500 MPa\"\n" +
         row;
}

std::string train_of(const char* stage) {
  return std::string(
             "[t]\ncalculator = \"drive.train\"\nP = \"5 kW\"\nn_1 = \"1450 rpm\"\nstages = [{ name = \"a\", ") +
         stage + " }]\n";
}

std::string fit_with(const char* alpha_2) {
  return std::string(
             "material = \nE_1 = \"210 GPa\"\nnu_1 = 0.3\nrho_1 = \"7850 kg/m^3\"\nalpha_1 = \"12e-6 1/K\"\n"
             "E_2 = \"70 GPa\"\nnu_2 = 0.33\nrho_2 = \"2700 kg/m^3\"\nT = \"300 N*m\"\nalpha_2 = \"") +
         alpha_2 + "\"";
}

}  // namespace

TEST_SUITE("found properties") {
  TEST_CASE("properties beyond those of any material or part need a reason") {
    for (const Data& d : properties()) {
      const std::string lines = d.common.empty() ? "" : d.common + "\n", of = d.calculator;
      INFO(of);
      CHECK_MESSAGE(mode_with(of, lines + d.impossible, d.mode) == "not-judged", std::string(d.impossible));
      CHECK_MESSAGE(mode_with(of, lines + d.usual, d.mode) == "pass", std::string(d.usual));
    }
  }

  TEST_CASE("moduli of a row are those of its metal") {
    CHECK(first_error_of(rod_of("E = \"300 GPa\"\n")).find("E = 300 GPa of 'own' is not that of steel") !=
          std::string::npos);
    CHECK(first_error_of(rod_of("E = \"210 GPa\"\nG = \"150 GPa\"\n")).find("G = 150 GPa") != std::string::npos);
    CHECK(first_error_of(rod_of("E = \"210 GPa\"\nG = \"81 GPa\"\n")).empty());
    CHECK(first_error_of(rod_of("E = \"232 GPa\"\nbecause.E = \"measured\"\n")).empty());
    CHECK(first_error_of(rod_of("E = \"210 GPa\"\nrho = \"785 kg/m^3\"\n")).find("rho = 785 kg/m") !=
          std::string::npos);
    CHECK(first_error_of(rod_of("E = \"210 GPa\"\nrho = \"7700 kg/m^3\"\n")).empty());
    CHECK(first_error_of(rod_of("E = \"210 GPa\"\nG = \"81 GPa\"\nnu = 0.05\n")).find("nu = 0.05") !=
          std::string::npos);
    CHECK(first_error_of(rod_of("E = \"210 GPa\"\nG = \"81 GPa\"\nnu = 0.3\n")).empty());
  }

  TEST_CASE("another treatment of a built-in steel is not three times as strong") {
    const auto row = [](const char* R_e) {
      return std::string(
                 "[s]\ncalculator = \"shaft.torsion\"\nT = \"900 N*m\"\nd = \"63 mm\"\nmaterial = \"C45E "
                 "forged\"\nS = 3\n[tables.materials.\"C45E forged\"]\nsource = \"store\"\nR_m = \"1250 MPa\"\n"
                 "because.R_m = \"data sheet\"\nR_e = \"") +
             R_e + "\"\n";
    };
    CHECK(first_error_of(row("1150 MPa")).find("above the 490 MPa of the built-in row 'C45E'") != std::string::npos);
    CHECK(first_error_of(row("520 MPa")).empty());
  }

  TEST_CASE("torques after a stage of poor efficiency need a reason") {
    const auto state = [](const char* stage) { return mode_of(solved_as_found(train_of(stage)), "t", "typed_values"); };
    CHECK(state("kind = \"belt\", i = 2, eta = 0.3") == "not-judged");
    CHECK(state("kind = \"gear\", i = 2, eta = 0.1") == "not-judged");
    CHECK(state("kind = \"gear\", i = 2, eta = 0.92") == "none");
    CHECK(state("kind = \"worm\", i = 40, eta = 0.45") == "none");
    CHECK(state("kind = \"other\", i = 2, eta = 0.4") == "none");
  }

  TEST_CASE("a hub of aluminium expands as aluminium does") {
    CHECK(ExampleStep("shaft.press_fit", fit_with("12e-6 1/K")).fault().find("thermal expansion") != std::string::npos);
    CHECK(ExampleStep("shaft.press_fit", fit_with("23e-6 1/K")).fault().empty());
  }

  TEST_CASE("one of the blocks has the loads of the bearing") {
    CHECK(ExampleStep("bearing.rolling", "blocks = [{ q = 1, k = 0.2 }]").fault().find("no block has the loads") !=
          std::string::npos);
    CHECK(ExampleStep("bearing.rolling", "blocks = [{ q = 0.1, k = 1 }, { q = 0.9, k = 0.2 }]").fault().empty());
  }
}
