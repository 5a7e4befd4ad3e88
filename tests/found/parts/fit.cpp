// Regression tests of neighbours that do not fit, and of kinds of parts that cannot do their task.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string state_of(const std::string& text, const char* step, const char* id) {
  return mode_of(solved_as_found(text), step, id);
}

const std::string gears =
    "[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = \"2.5 mm\"\nb = \"28 mm\"\nT_1 = \"40 N*m\"\nn_1 = "
    "\"1450 rpm\"\nK_A = 1.25\nK_f = 1.5\ncutting = \"hobbed\"\nsigma_adm_1 = \"260 MPa\"\nsigma_adm_2 = \"260 MPa\"\n";

std::string stub(const std::string& lines) {
  return gears + "[e]\ncalculator = \"shaft.overhung\"\nsigma_adm = \"60 MPa\"\n" + lines + "\n";
}
std::string line_shaft(const std::string& lines) {
  return gears + "[s]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\n" + lines + "\n";
}

std::string sun_key(const std::string& load, const std::string& d) {
  return "[winch]\ncalculator = \"gear.planetary\"\nz_s = 24\nz_p = 30\nz_r = 84\nN_p = 3\nfixed = \"ring\"\nn_s = "
         "\"1450 rpm\"\nT_s = \"50 N*m\"\nh_ar = 0.9\nm_n = \"2.5 mm\"\n[k]\ncalculator = \"shaft.key\"\n" +
         load + "\nd = \"" + d +
         "\"\nl = \"28 mm\"\nl_n = \"30 mm\"\ntorque = \"one_way\"\nR_e_1 = \"370 MPa\"\nS_F = 1.5\nR_e_2 = \"300 "
         "MPa\"\n"
         "R_e_k = \"420 MPa\"\n";
}

/// A gear between two bearings of 35 mm at x and at 140 mm, on a shaft of 180 mm.
std::string shaft(const std::string& x, const std::string& seat, const std::string& left) {
  return gears +
         "[shaft]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\nS_F = 1.5\nS_D = "
         "1.5\nr_T = 0\npieces = [{ l = \"180 mm\", d = \"35 mm\" }]\nsupports = [{ name = \"left\", x = \"" +
         x +
         "\", holds = \"both\" }, { name = \"right\", x = \"140 mm\" }]\nseats = [{ name = \"gear\", x = \"80 mm\", " +
         seat + ", integral = true }, { name = \"end\", x = \"170 mm\", way = \"balances\", integral = true }]\n" +
         "[left]\ncalculator = \"bearing.rolling\"\nload = \"=shaft.bearings.left\"\nC = \"27 kN\"\nC_0 = \"25 kN\"\n" +
         left + "\n";
}
const std::string whole = "load = \"=gears.gear_1\"", ball = "kind = \"deep_groove_ball\"\nf_0 = 14";

std::string flat(const std::string& lines, const char* id) { return mode_with("belt.flat", lines, id); }

}  // namespace

TEST_SUITE("found fit") {
  TEST_CASE("a shaft passes through the component whose load it takes") {
    for (const std::string& load :
         {std::string("load = \"=gears.gear_1\""), std::string("T = \"=gears.gear_1.T\"\nF = \"=gears.gear_1.F\"")}) {
      const auto root = [&](const std::string& d) {
        return state_of(stub(load + "\na = \"40 mm\"\nd = " + d), "e", "root");
      };
      CHECK(root("\"60 mm\"") == "not-judged");  // root circle 43.75 mm
      CHECK(root("\"43 mm\"") == "none");
      CHECK(root("\"60 mm\"\naccept.root = \"steps down\"") == "accepted");
    }
    CHECK(state_of(line_shaft("T = \"=gears.gear_1.T\"\nd = \"60 mm\""), "s", "root") == "not-judged");
    CHECK(state_of(line_shaft("T = \"=gears.gear_1.T\"\nd = \"40 mm\""), "s", "root") == "none");
    CHECK(
        state_of(line_shaft("T = \"=gears.gear_1.T\"\nsegments = [{ l = \"90 mm\", d = \"60 mm\" }, { l = \"50 mm\", d "
                            "= \"40 mm\" }]"),
                 "s", "root") == "none");
  }

  TEST_CASE("a component on an overhang is clear of the bearing") {
    const std::string load = "load = \"=gears.gear_1\"\nd = \"40 mm\"\na = ";
    CHECK(state_of(stub(load + "\"5 mm\""), "e", "clearance") == "not-judged");
    CHECK(state_of(stub(load + "\"14 mm\""), "e", "clearance") == "none");
  }

  TEST_CASE("a key of the sun lies within its root circle") {
    for (const std::string& load : {std::string("T = \"=winch.T_s\""), std::string("load = \"=winch.gear_s\"")}) {
      CHECK(first_error_of(sun_key(load + "\nkey = \"18x11\"", "60 mm")).find("root circle") != std::string::npos);
      CHECK(first_error_of(sun_key(load + "\nkey = \"8x7\"", "30 mm")).empty());
    }
  }

  TEST_CASE("bearings lie on the shaft, clear of fillets and rims") {
    CHECK(state_of(shaft("15 mm", whole, ball), "shaft", "assembly") == "none");
    CHECK(state_of(shaft("1 mm", whole, ball), "shaft", "assembly") == "not-judged");
    CHECK(state_of(shaft("60 mm", whole, ball), "shaft", "assembly") == "none");
    // Rim of 28 mm on a hub of 10 mm.
    CHECK(state_of(shaft("67 mm", whole + ", b = \"10 mm\", I_p = \"0.001 kg*m^2\"", ball), "shaft", "assembly") ==
          "not-judged");
  }

  TEST_CASE("a locating bearing locates the shaft axially, and its life is one life") {
    CHECK(state_of(shaft("15 mm", whole, ball), "left", "location") == "none");
    CHECK(state_of(shaft("15 mm", whole, "kind = \"needle_roller\""), "left", "location") == "not-judged");
    CHECK(state_of(shaft("15 mm", whole, "kind = \"cylindrical_roller_NUP\""), "left", "location") == "none");
    CHECK(state_of(shaft("15 mm", whole, ball + "\nL_m = 1.8"), "left", "fatigue") == "not-judged");
    CHECK(state_of(shaft("15 mm", whole, ball + "\nL_m = 90"), "left", "fatigue") == "pass");
  }

  TEST_CASE("the force of a gear given by its components is complete") {
    const auto loads = [](const std::string& forces) {
      return state_of(shaft("15 mm", "T = \"=gears.gear_1.T\", " + forces, ball), "shaft", "other_loads");
    };
    const std::string F_x = "F_x = \"=-gears.gear_1.T/(25 mm)*tan(20 deg)\"",
                      F_y = "F_y = \"=-gears.gear_1.T/(25 mm)\"";
    CHECK(loads(F_x + ", " + F_y) == "open");
    CHECK(loads(F_x) == "not-judged");
    CHECK(loads(F_y) == "not-judged");
    CHECK(loads("F_x = \"=gears.gear_1.T/(25 mm)*tan(20 deg)\", " + F_y) == "not-judged");
    CHECK(loads(F_x + ", F_y = \"=-gears.gear_1.T/(250 mm)\"") == "not-judged");
  }

  TEST_CASE("belts have space between their pulleys, and crossed ones space to twist") {
    CHECK(flat("a = \"352 mm\"\nb = \"140 mm\"\nE_b = ", "room") == "fail");
    CHECK(flat("a = \"356 mm\"\nb = \"140 mm\"\nE_b = ", "room") == "pass");
    const std::string crossed = "arrangement = \"crossed\"\na = ";
    CHECK(flat(crossed + "\"1200 mm\"\nb = \"140 mm\"", "twist") == "not-covered");
    CHECK(flat(crossed + "\"4000 mm\"", "twist") == "pass");
    CHECK(flat("a = \"1200 mm\"", "twist") == "none");
  }

  TEST_CASE("an implausible belt speed or bend is not assessed") {
    CHECK(mode_with("belt.course", "n_1 = \"14500 rpm\"\nq = \"0.01 kg/m\"", "speed") == "not-judged");
    CHECK(mode_with("belt.course", "n_1 = \"2900 rpm\"", "speed") == "open");
    const std::string pulleys =
        "L = \npulleys = [{ x = \"0 mm\", y = \"0 mm\", d = \"160 mm\" }, { x = \"600 mm\", y = "
        "\"0 mm\", d = \"";
    CHECK(mode_with("belt.course", pulleys + "5 mm\", P = \"3 kW\" }]", "bending") == "not-judged");
    CHECK(mode_with("belt.course", pulleys + "80 mm\", P = \"3 kW\" }]", "bending") == "open");
  }

  TEST_CASE("Euler's formula ends below yield") {
    CHECK(mode_with("column.buckling", "sigma_P = \"338 MPa\"", "buckling") == "not-judged");
    CHECK(mode_with("column.buckling", "sigma_P = \"338 MPa\"\nbecause.sigma_P = \"cold drawn, test 3\"", "buckling") ==
          "pass");
    CHECK(mode_with("column.buckling", "sigma_P = \"300 MPa\"", "buckling") == "pass");
  }

  TEST_CASE("a bottom with liquid carries that of the vessel above it") {
    const auto cone = [](const std::string& p) {
      return state_of(
          "[shell]\ncalculator = \"vessel.cylinder\"\np = \"0.1 MPa\"\nR = \"1200 mm\"\nmeasured = \"inner\"\ndelta = "
          "\"6 mm\"\nrho = \"1000 kg/m^3\"\nh_l = \"6 m\"\nsigma_adm = \"140 MPa\"\n[cone]\ncalculator = "
          "\"vessel.cone\"\nR = \"=shell.R\"\nalpha = \"30 deg\"\nmeasured = \"inner\"\ndelta = \"8 mm\"\nsigma_adm = "
          "\"140 MPa\"\n" +
              p + "\n",
          "cone", "strength");
    };
    const std::string liquid = "\nrho = \"=shell.rho\"\nh_l = \"2 m\"";
    CHECK(cone("p = \"=shell.p\"" + liquid) == "not-judged");
    CHECK(cone("p = \"=shell.p + 1000 kg/m^3*9.81 m/s^2*6 m\"" + liquid) == "pass");
    CHECK(cone("p = \"=shell.p\"") == "not-judged");
    CHECK(cone("p = \"=shell.p\"\nbecause.p = \"roof above the liquid\"") == "pass");
  }

  TEST_CASE("a shaft as hard as the set screw, and a boss thicker than its rod") {
    CHECK(mode_with("shaft.set_screw", "R_e_1 = \"1400 MPa\"\nS_F = 1.5", "hardness") == "not-judged");
    CHECK(mode_with("shaft.set_screw", "R_e_1 = \"1400 MPa\"\nS_F = 1.5\nk_H = 0.85", "hardness") == "none");
    CHECK(mode_with("shaft.set_screw", "R_e_1 = \"400 MPa\"\nS_F = 1.5", "hardness") == "none");
  }

  TEST_CASE("of a wide eye only two and a half bores carry") {
    const std::string wide = "d = \"30 mm\"\na = \"30 mm\"\nt = \"30 mm\"\nF = \"18 kN\"\nb = ";
    CHECK(mode_with("pin.lug", wide + "\"80 mm\"", "net") == "pass");
    CHECK(mode_with("pin.lug", wide + "\"80 mm\"\nF = \"110 kN\"", "net") == "fail");
    CHECK(mode_with("pin.lug", wide + "\"800 mm\"\nF = \"110 kN\"", "net") == "fail");
  }

  TEST_CASE("the stress of a rod counted over a revolution assesses its fatigue") {
    const auto rod = [](const std::string& sigma) {
      return state_of(
          "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\nl = \"200 "
          "mm\"\ncrank "
          "= { speed = \"60 rpm\", positions = 180 }\nloads = [{ name = \"F\", link = \"slider\", at = \"B\", F_x = "
          "\"-10 kN\", F_y = \"0 N\" }]\n[rod]\ncalculator = \"link.member\"\nload = \"=press.links.rod\"\nh = \"30 "
          "mm\"\nb = \"15 mm\"\nends = \"pinned_pinned\"\nmaterial = \"S355\"\nmethod = \"johnson\"\nn_st = 3\nS = "
          "2\n[hist]\ncalculator = \"fatigue.history\"\nsigma = \"" +
              sigma +
              "\"\nsigma_D = \"100 MPa\"\nN_D = 1e6\nk = 5\nmean = \"fkm\"\nM = 0.1\nmaterial = \"S355\"\nd_h = \"15 "
              "mm\"\nS_F = 1.5\nS_D = 1.3\nD_adm = 0.3\nn_req = 1e7\n",
          "rod", "fatigue");
    };
    CHECK(rod("=rod.sigma_u") == "pass");
    CHECK(rod("=0.5*rod.sigma_u") == "not-judged");
    CHECK(rod("=rod.sigma_N") == "not-judged");
  }

  TEST_CASE("a round wall of a tenth of its radius is thin for Tresca, not for its membrane stresses alone") {
    const std::string nozzle = "R = \"53 mm\"\nmeasured = \"mean\"\nc = \"0 mm\"\ndelta = \"4 mm\"\np = \"1 MPa\"\n";
    CHECK(mode_with("vessel.cylinder", nozzle, "strength") == "pass");
    CHECK(mode_with("vessel.cylinder", nozzle + "hypothesis = \"membrane\"", "strength") == "not-covered");
    CHECK(mode_with("vessel.sphere", nozzle, "strength") == "pass");
  }
}
