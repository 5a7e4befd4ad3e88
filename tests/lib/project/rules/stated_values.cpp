// Each condition of the rules for [values] that a step states under its own name or under a customary one.
#include "lib/project/references/agreement/stated_values.hpp"

#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

void check(const std::string& steps, std::initializer_list<ValuesRow> rows) {
  check_values(&project::values_stated_only, steps, rows);
}

const std::string bearing =
    "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6309\"\nF_r = \"6 kN\"\nn = \"1200 rpm\"\nL_h = \"3000 h\"\n";

const std::string shell =
    "[s]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\nmeasured = \"inner\"\nc = \"1 mm\"\n"
    "sigma_adm = \"140 MPa\"\n";

const std::string vacuum =
    "[v]\ncalculator = \"vessel.external\"\np_e = \"0.05 MPa\"\nD_a = \"1200 mm\"\nL = \"2400 mm\"\nc = \"1 mm\"\n"
    "material = \"P265GH\"\n";

const std::string shaft = "[t]\ncalculator = \"shaft.torsion\"\nT = \"300 N*m\"\nd = \"60 mm\"\ntau_adm = \"40 MPa\"\n";

}  // namespace

TEST_SUITE("project: values stated only") {
  TEST_CASE("a peak factor next to that of the step") {
    const std::string key = example_of("shaft.key", "T = \"100 N*m\"\nT_max = \"200 N*m\"");
    for (const std::string name : {"k_start", "f_starting", "max_factor", "k_peak", "jam", "stall", "shock", "impact",
                                   "brake", "braking", "overload", "K_max", "k_max"})
      check(key, {{name + " = 4", "T_max"}, {name + " = 2", ""}, {name + " = 2.001", ""}, {name + " = 11", ""}});
    check(key, {{"k_max = 10", "T_max"}});
    check(key, {{"max = 4", ""}, {"n_start = 4", ""}, {"k_wear = 4", ""}, {"k_start = \"4 mm\"", ""}});
    const std::string din743 = example_of("fatigue.din743", "f_max = 1.5");
    check(din743, {{"f_start = 2", "f_max"}, {"f_start = 1.5", ""}});
    check(example_of("vessel.cylinder"), {{"k_start = 4", ""}});
  }

  TEST_CASE("a shock of a machine none of whose steps has a peak factor") {
    const std::string chain = example_of("chain.roller", "K_A = 1.5");
    check(chain, {{"shock = 3", "K_A"}, {"shock = 1.5", ""}, {"shock = 1.501", ""}, {"wear = 3", ""}});
    for (const std::string& peak : {example_of("shaft.key"), example_of("shaft.design")})
      check(chain + "\n" + peak, {{"shock = 3", ""}});
  }

  TEST_CASE("repetitions above those of a history") {
    const std::string history = example_of("fatigue.history", "n_req = 10");
    for (const std::string name : {"days", "weeks", "months", "years", "shifts", "repetitions"})
      check(history, {{name + " = 11", "n_req"}, {name + " = 10", ""}});
    check(history, {{"n_req = 11", "n_req"}, {"turns = 11", ""}, {"days = \"11 h\"", ""}});
    check(shaft, {{"days = 11", ""}});
  }

  TEST_CASE("a life above the required one") {
    for (const std::string name :
         {"life", "lifetime", "L", "hours", "L_10h", "service_life", "operating_hours", "running_life", "design_life",
          "required_life", "L_req", "target_life", "total_hours"})
      check(bearing, {{name + " = \"4000 h\"", "L_h"}, {name + " = \"3000 h\"", ""}, {name + " = \"3001 h\"", ""}});
    check(bearing, {{"grease_life = \"4000 h\"", ""}, {"life = 4000", ""}, {"req = \"4000 h\"", ""}});
    check(bearing, {{"L_h = \"4000 h\"", "L_h"}});
    check(shaft, {{"life = \"4000 h\"", ""}});
    const std::string flat = example_of("belt.flat", "sigma_f = \"9 MPa\"\nm_f = 6\nL_req = \"4000 h\"");
    check(flat, {{"life = \"5000 h\"", "L_req"}, {"life = \"4000 h\"", ""}, {"L_req = \"5000 h\"", "L_req"}});
    // 1e7 load cycles at 900 rpm: 185 h
    const std::string bevel = example_of("gear.bevel", "L_h =\nN = 1e7");
    check(bevel, {{"life = \"190 h\"", "N"}, {"life = \"180 h\"", ""}});
    const auto said = [](const std::string& step) {
      return messages_of(&project::values_stated_only, "[values]\nlife = \"12000 h\"\n\n" + step);
    };
    CHECK_MESSAGE(said(bevel).find("N is 1e7, 185.19 h") != std::string::npos, said(bevel));
    CHECK(said(bearing).find("L_h is 3000 h") != std::string::npos);
    check(example_of("gear.bevel"), {{"life = \"12000 h\"", "L_h"}, {"life = \"10000 h\"", ""}});
    check(example_of("fatigue.life", "N = 1e5"), {{"life = \"12000 h\"", ""}});
  }

  TEST_CASE("years of working days above the required life") {
    for (const std::string name : {"hours_per_day", "daily"})
      check(bearing, {{"years = 2\n" + name + " = \"8 h\"", "L_h"}, {"years = 1\n" + name + " = \"8 h\"", ""}});
    check(bearing, {{"years = 2\nshift = \"8 h\"", ""},
                    {"ages = 2\ndaily = \"8 h\"", ""},
                    {"years = 2\ndaily = 8", ""},
                    {"years = \"2 h\"\ndaily = \"8 h\"", ""},
                    {"years = 1.5\ndaily = \"8 h\"", ""},
                    {"years = 1.501\ndaily = \"8 h\"", ""}});
    check(example_of("gear.bevel", "L_h =\nN = 1e7"), {{"years = 1\ndaily = \"1 h\"", "N"}});
  }

  TEST_CASE("a load next to teeth that take none") {
    const std::string cycloid = example_of("gear.cycloidal");
    check(cycloid, {{"T = \"5 N*m\"", "m"},
                    {"F = \"5 N\"", "m"},
                    {"P = \"5 W\"", "m"},
                    {"P = \"0 W\"", ""},
                    {"T = 5", ""},
                    {"d = \"5 mm\"", ""}});
    check(shaft, {{"F = \"5 N\"", ""}});
  }

  TEST_CASE("a value under the name of an input") {
    check(bearing, {{"R = 0.99", "R"}, {"R = 0.8", ""}, {"R = 1", ""}, {"R = 0.9", ""}, {"R = \"0.99 m\"", ""}});
    check(bearing + "R = 0.95\n", {{"R = 0.92", ""}, {"R = 0.99", "R"}});
    check(example_of("fatigue.life"), {{"R = 0.99", ""}});
    check(shell, {{"sigma_adm = \"200 MPa\"", ""}, {"sigma_adm = \"100 MPa\"", "sigma_adm"}});
    check(shell, {{"c = \"2 mm\"", "c"}, {"c = \"1 mm\"", ""}, {"c = 2", ""}, {"p = \"2 MPa\"", ""}});
    check(bearing, {{"n_max = \"90000 rpm\"", "n_max"}, {"n_max = \"3000 rpm\"", ""}});
    const std::string torsion = example_of("shaft.torsion", "material =\ntau_adm =\nR_e = \"355 MPa\"\nS = 2");
    check(torsion, {{"R_e = \"235 MPa\"", "R_e"}, {"R_e = \"355 MPa\"", ""}, {"R_e = \"400 MPa\"", ""}});
    check(shaft, {{"tau_adm = \"30 MPa\"", "tau_adm"}, {"tau_adm = \"40 MPa\"", ""}, {"R_m = \"30 MPa\"", ""}});
    const std::string life = example_of("fatigue.life");
    check(life, {{"R_m = \"600 MPa\"", "R_m"}, {"sigma_D = \"100 MPa\"", "sigma_D"}, {"sigma_D = \"200 MPa\"", ""}});
  }

  TEST_CASE("a vacuum that no step takes") {
    for (const std::string name : {"vacuum", "vac", "p_vac", "p_ext", "p_external", "p_outside"})
      check(shell, {{name + " = \"0.1 MPa\"", "p"}, {name + " = \"-0.1 MPa\"", "p"}, {name + " = 0.1", ""}});
    for (const std::string name : {"p", "p_min", "pressure", "suction"})
      check(shell, {{name + " = \"-0.08 MPa\"", "p"}});
    check(shell, {{"p_min = \"-0.11 MPa\"", "p"},
                  {"p_min = \"-0.12 MPa\"", ""},
                  {"p_min = \"0.08 MPa\"", ""},
                  {"drop = \"-0.08 MPa\"", ""},
                  {"ext = \"0.1 MPa\"", ""},
                  {"vacuum = \"full\"", "p"},
                  {"vacuum = \"none\"", ""},
                  {"state = \"full\"", ""}});
    check(shell + "accept.vacuum = \"a valve breaks it\"\n", {{"p_vac = \"0.1 MPa\"", ""}});
    check(vacuum, {{"p_vac = \"0.1 MPa\"", "p_e"}, {"p_vac = \"0.05 MPa\"", ""}, {"p_vac = \"0.04 MPa\"", ""}});
    check(shell + "\n" + vacuum, {{"p_vac = \"0.1 MPa\"", ""}});
    check(shaft, {{"p_vac = \"0.1 MPa\"", ""}});
  }
}

TEST_SUITE("project: temperatures stated only") {
  TEST_CASE("a temperature of the part, by its words") {
    for (const std::string name :
         {"t_service", "T_operating", "theta_operation", "T_work",  "t_working",   "T_design", "T_max", "T_wall",
          "T_metal",   "T_part",      "T_medium",        "T_steam", "T_fire",      "T_oven",   "T_air", "t_gas",
          "t_d",       "T_process",   "T_product",       "ambient", "temperature", "t",        "theta", "T_theta"})
      check(shell, {{name + " = \"150 degC\"", "sigma_adm"}, {name + " = \"99 degC\"", ""}, {name + " = 500", ""}});
    for (const std::string name :
         {"service", "oven", "T_join", "T_joining_max", "T_temper_max", "T_tempering_max", "T_store", "T_oil"})
      check(shell, {{name + " = \"150 degC\"", ""}});
    check(shaft, {{"T_service = \"150 degC\"", "tau_adm"}});
    check(example_of("fatigue.life"), {{"T_service = \"150 degC\"", "R_e"}});
    check(example_of("fatigue.life", "R_e =\nS_F ="), {{"T_service = \"150 degC\"", "R_m"}});
  }

  TEST_CASE("the limits of bearings, belts and gears") {
    check(bearing, {{"T_oil = \"130 degC\"", "C"}, {"T_sump = \"130 degC\"", "C"}, {"T_max = \"119 degC\"", ""}});
    check(example_of("belt.synchronous"),
          {{"T_max = \"90 degC\"", "F_a"}, {"T_max = \"84 degC\"", ""}, {"T_oil = \"90 degC\"", ""}});
    check(example_of("gear.worm", "sigma_adm ="), {{"T_oil = \"110 degC\"", "m_x"}, {"T_max = \"99 degC\"", ""}});
    check(example_of("gear.bevel"), {{"T_oil = \"125 degC\"", "T_G"}, {"T_oil = \"120 degC\"", ""}});
    check(example_of("gear.bevel", "T_G = \"130 degC\""),
          {{"T_oil = \"125 degC\"", ""}, {"T_oil = \"140 degC\"", "T_G"}});
    check(example_of("chain.roller"), {{"T_max = \"300 degC\"", ""}});
    const auto said = [](const std::string& T, const std::string& step) {
      return messages_of(&project::values_stated_only, "[values]\n" + T + "\n\n" + step);
    };
    CHECK(said("T_oil = \"125 degC\"", example_of("gear.bevel")).find("give T_G") != std::string::npos);
    CHECK(said("T_max = \"90 degC\"", example_of("belt.synchronous")).find("usual belts apply up to 85") !=
          std::string::npos);
    CHECK(said("T_max = \"150 degC\"", shell).find("strengths at room temperature apply up to 100") !=
          std::string::npos);
  }
}
