// Bevel, worm and cycloidal gears with values that their teeth, their speed or their shafts contradict.
#include "calculators/catalogue.hpp"
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string teeth =
    "[bevel]\ncalculator = \"gear.bevel\"\nz_1 = 20\nz_2 = 40\nm_et = \"4 mm\"\nb = \"28 mm\"\n"
    "x_1 = 0.3\nh_fP = 1.188\nP = \"5 kW\"\nn_1 = \"900 rpm\"\nQ_v = 8\ncrowning = \"crowned\"\n"
    "I = 0.083\nJ_1 = 0.244\nJ_2 = 0.2\nH_B1 = 300\nH_B2 = 280\nS_Hmin = 1\nS_Fmin = 1.2\n";

/// The pinion overhung by 50 mm.
std::string shaft_with(const std::string& lines) {
  return "\n[shaft]\ncalculator = \"shaft.design\"\nmaterial = \"42CrMo4\"\ngroup = \"alloy-steel\"\npieces = [{ l = "
         "\"220 mm\", d = \"36 mm\" }]\nsupports = [{ name = \"left\", x = \"80 mm\", holds = \"both\" }, { name = "
         "\"right\", x = \"200 mm\" }]\nseats = [{ name = \"cpl\", x = \"220 mm\", way = \"balances\" }, { name = "
         "\"mesh\", x = \"30 mm\", load = \"=bevel.gear_1\", integral = true }]\nS_F = 1.5\nS_D = 1.5\nr_T = 0\n" +
         lines;
}

std::string pitting(const std::string& before, const std::string& lines, const std::string& behind = "") {
  return mode_of(solved_as_found(before + teeth + lines + behind), "bevel", "pitting_1");
}

const std::string running = "mounting = \"one_straddled\"\nL_h = \"1000 h\"\n";

}  // namespace

TEST_SUITE("found gear bounds") {
  TEST_CASE("geometry factors above the chart, stress numbers above the hardness, fast straight teeth") {
    CHECK(mode_with("gear.bevel", "", "pitting_1") == "pass");
    CHECK(mode_with("gear.bevel", "I = 0.12", "pitting_1") == "not-judged");
    CHECK(mode_with("gear.bevel", "J_1 = 0.35", "root_1") == "not-judged");
    CHECK(mode_with("gear.bevel", "J_2 = 0.3", "root_2") == "not-judged");
    CHECK(mode_with("gear.bevel", "H_B1 = 180\ns_ac1 = \"900 MPa\"", "pitting_1") == "not-judged");
    CHECK(mode_with("gear.bevel", "H_B1 = 300\ns_ac1 = \"800 MPa\"", "pitting_1") == "pass");  // 868 MPa by 300 HB
    CHECK(mode_with("gear.bevel", "H_B2 = 180\ns_at2 = \"105 MPa\"", "root_2") == "not-judged");
    CHECK(mode_with("gear.bevel", "n_1 = \"2300 rpm\"", "pitting_1") == "pass");  // 9.6 m/s
    CHECK(mode_with("gear.bevel", "n_1 = \"2500 rpm\"", "pitting_1") == "not-judged");
    CHECK(mode_with("gear.bevel", "b = \"5 mm\"", "width") == "fail");
  }

  TEST_CASE("an overhung pinion entered as between bearings, and a shaft with a higher application factor") {
    CHECK(pitting("", running, shaft_with("")) == "pass");
    CHECK(pitting("", "mounting = \"both_straddled\"\nL_h = \"1000 h\"\n", shaft_with("")) == "not-judged");
    CHECK(pitting("", running, shaft_with("K_A = 1.75\n")) == "not-judged");
  }

  TEST_CASE("a bearing whose place is not known yet does not make a pinion overhung") {
    const std::string both = "mounting = \"both_straddled\"\nL_h = \"1000 h\"\n";
    const std::string spacer =
        "[spacer]\ncalculator = \"shaft.torsion\"\nT = \"20 N*m\"\nd = \"20 mm\"\ntau_adm = \"40 MPa\"\n";
    const auto state = [&](const std::string& left, const std::string& right) {
      std::string shaft = shaft_with("");
      shaft.replace(shaft.find("30 mm"), 5, "140 mm").replace(shaft.find("200 mm"), 6, right);
      return pitting("", both, shaft.replace(shaft.find("80 mm"), 5, left) + spacer);
    };
    CHECK(state("200 mm", "80 mm") == "pass");
    CHECK(state("=10*spacer.d_max", "80 mm") == "pass");
    CHECK(state("200 mm", "=4*spacer.d_max") == "pass");
    CHECK(state("200 mm", "160 mm") == "not-judged");
  }

  TEST_CASE("load cycles and the temperature of gears next to [values]") {
    const std::string cycles = "mounting = \"one_straddled\"\nN = 5.4e6\n";  // 100 h
    CHECK(pitting("[values]\nL_h = \"50 h\"\n\n", cycles) == "pass");
    CHECK(pitting("[values]\nL_h = \"10000 h\"\n\n", cycles) == "not-judged");
    CHECK(pitting("[values]\nt_service = \"180 degC\"\n\n", running) == "not-judged");
    CHECK(pitting("[values]\nT_oil = \"130 degC\"\n\n", running) == "not-judged");
    CHECK(pitting("[values]\nT_oil = \"90 degC\"\n\n", running) == "pass");
  }

  TEST_CASE("the oil of a worm gear in [values]") {
    const auto wear = [](const std::string& T_oil) {
      const std::string values = "[values]\nT_oil = \"" + T_oil + "\"\n\n";
      return mode_of(solved_as_found(values + std::string(find_calculator(calculators(), "gear.worm")->example)),
                     "worm", "wear");
    };
    CHECK(wear("90 degC") == "pass");
    CHECK(wear("130 degC") == "not-judged");
  }

  TEST_CASE("a lantern of many pins driven by a few teeth, and thin pins") {
    const auto contact = [](const std::string& lines) {
      return mode_of(solved_as_found("[l]\ncalculator = \"gear.cycloidal\"\npinion = \"pins\"\nm = \"2 mm\"\n" + lines),
                     "l", "contact");
    };
    CHECK(contact("z_1 = 10\nz_2 = 60\nd_p = \"3 mm\"\n") == "pass");
    CHECK(contact("z_1 = 200\nz_2 = 6\nd_p = \"3 mm\"\n") == "not-judged");
    CHECK(contact("z_1 = 10\nz_2 = 60\nd_p = \"0.2 mm\"\n") == "not-judged");
  }

  TEST_CASE("friction, form factor and diameter of a worm") {
    CHECK(mode_with("gear.worm", "mu = 0.025", "heat") == "pass");  // 0.027 at 3 m/s
    CHECK(mode_with("gear.worm", "mu = 0.015", "heat") == "not-judged");
    CHECK(mode_with("gear.worm", "z_1 = 1\nmu = 0.12\nlocking = \"required\"", "locking") == "not-judged");
    CHECK(mode_with("gear.worm", "y = 0.12", "root_2") == "pass");
    CHECK(mode_with("gear.worm", "y = 0.18", "root_2") == "not-judged");
    CHECK(mode_with("gear.worm", "d_1 = \"22 mm\"", "core") == "not-judged");
    CHECK(mode_with("gear.worm", "d_1 = \"12 mm\"\nb_2 = \"20 mm\"", "core") == "fail");  // 2 mm at the root
    CHECK(mode_with("gear.worm", "b_2 = \"10 mm\"", "width") == "fail");
    CHECK(mode_with("gear.worm", "n_1 = \"4000 rpm\"", "wear") != "pass");
  }

  TEST_CASE("thick oil, and the roots of a protuberance tool") {
    const std::string iso = "standard = \"iso6336\"\nnu_40 = ";
    CHECK(mode_with("gear.rating", iso + "\"460 mm^2/s\"", "pitting_1") == "pass");
    CHECK(mode_with("gear.rating", iso + "\"2000 mm^2/s\"", "pitting_1") == "not-judged");
    const std::string tool = "rho_fP = 0.39\nh_fP = 1.4\ns_pr = 0.02";
    CHECK(mode_with("gear.rating", tool, "interference") == "none");
    CHECK(mode_with("gear.rating", tool, "protuberance") == "not-judged");
    CHECK(mode_with("gear.rating", "", "protuberance") == "none");
  }

  TEST_CASE("few leaves must drive, and a torque needs the strength of the teeth") {
    const auto leaves = [](const std::string& z_1) {
      return mode_with("gear.cycloidal", "pinion = \"leaves\"\nd_p = \nz_2 = 60\nz_1 = " + z_1, "lead");
    };
    CHECK(leaves("6") == "not-judged");
    CHECK(leaves("8") == "open");
    CHECK(leaves("12") == "none");
    const auto breakage = [](const std::string& values) {
      return mode_of(solved_as_found("[values]\n" + values +
                                     "\n\n[clock]\ncalculator = \"gear.cycloidal\"\nm = \"1 "
                                     "mm\"\nz_1 = 8\nz_2 = 60\n"),
                     "clock", "breakage");
    };
    CHECK(breakage("T_2 = \"500 N*m\"") == "not-judged");
    CHECK(breakage("l = \"500 mm\"") == "open");
  }
}
