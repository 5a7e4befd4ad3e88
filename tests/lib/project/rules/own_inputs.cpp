// Each condition of the rules for [values] under the names of inputs that have another value.
#include "lib/project/references/stated/own_inputs.hpp"

#include "lib/project/references/stated/rows.hpp"
#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string column() { return example_of("column.buckling"); }

void check(const std::string& steps, std::initializer_list<ValuesRow> rows) {
  check_values(&project::inputs_stated_otherwise, steps, rows);
}

/// A step under another name.
std::string renamed(const std::string& step, const std::string& name) {
  return "[" + name + step.substr(step.find(']'));
}

}  // namespace

TEST_SUITE("project: inputs stated otherwise") {
  TEST_CASE("constants of a material with the digits of another table, and of another substance") {
    const std::string disc =
        example_of("machine.disc", "material =\nrho = \"7850 kg/m^3\"\nE = \"210 GPa\"\nnu = 0.3\nR_e = \"650 MPa\"");
    check(disc, {{"rho = \"7850 kg/m^3\"", ""},
                 {"rho = \"7800 kg/m^3\"", ""},
                 {"rho = \"7700 kg/m^3\"", "rho"},
                 {"rho = \"8900 kg/m^3\"", "rho"},
                 {"rho = \"1600 kg/m^3\"", ""},
                 {"rho = \"16000 kg/m^3\"", ""},
                 {"nu = 0.29", ""},
                 {"nu = 0.34", "nu"}});
    const std::string beam = with_lines(column(), "material =\nE = \"210 GPa\"\nR_e = \"355 MPa\"");
    check(beam, {{"E = \"206 GPa\"", ""}, {"E = \"70 GPa\"", "E"}});
  }

  TEST_CASE("words of choices") {
    const std::string post = with_lines(column(), "ends = \"pinned_pinned\"");
    check(post, {{"ends = \"fixed_free\"", "ends"},
                 {"ends = \"pinned_pinned\"", ""},
                 {"ends = \"on the roof\"", ""},
                 {"l = \"long\"", ""}});
    check(post + "\n" + example_of("bearing.rolling"), {{"ends = \"fixed_free\"", "ends"}});
    check(post + "\n" + renamed(with_lines(column(), "ends = \"fixed_free\""), "other"),
          {{"ends = \"fixed_free\"", ""}});
    const std::string rating = example_of("gear.rating");
    check(rating, {{"finish = \"hobbed\"", "finish"}, {"finish = \"ground\"", ""}, {"place = \"near_end\"", ""}});
    check(with_lines(rating, "finish = \"hobbed\"\nR_z1 = \"10 um\"\nR_z2 = \"10 um\""), {{"finish = \"ground\"", ""}});
    const std::string bearing = example_of("bearing.rolling");
    check(bearing, {{"kind = \"cylindrical_roller\"", ""}});
    check(example_of("gear.worm"), {{"casting = \"sand\"", "casting"}});
    check(example_of("gear.worm", "casting =\nS_Wmin ="), {{"casting = \"sand\"", "casting"}});
  }

  TEST_CASE("the name of a material that no step has") {
    const std::string steel = with_lines(column(), "material = \"S355\"");
    check(steel, {{"material = \"S235\"", "R_e"}, {"material = \"S355\"", ""}});
    check(with_lines(column(), "material =\nE = \"210 GPa\"\nR_e = \"355 MPa\""), {{"material = \"S235\"", "R_e"},
                                                                                   {"steel = \"S235\"", "R_e"},
                                                                                   {"steel = \"S460\"", ""},
                                                                                   {"steel = \"any\"", ""}});
    check(steel + "\n" + renamed(with_lines(column(), "material = \"S235\""), "other"), {{"material = \"S235\"", ""}});
  }

  TEST_CASE("the name of the material of one step that another step has, too") {
    const std::string pin = renamed(example_of("pin.joint", "R_m = \"900 MPa\""), "pin");
    const std::string other = "\n" + with_lines(column(), "material = \"S235\"");
    check(pin + other, {{"steel_pin = \"S235\"", "R_m"}, {"steel_bar = \"S235\"", ""}, {"steel = \"S235\"", ""}});
  }

  TEST_CASE("strengths: those of the step are not above the stated ones") {
    const std::string life = example_of("fatigue.life");  // sigma_D = 190 MPa
    for (const std::string key : {"R_m", "R_e", "sigma_D"})
      check(life, {{key + " = \"100 MPa\"", key}, {key + " = \"900 MPa\"", ""}});
    const std::string gears = example_of("gear.pair");
    for (const std::string key : {"sigma_adm_1", "sigma_adm_2"}) check(gears, {{key + " = \"100 MPa\"", key}});
    const std::string shaft = example_of("shaft.torsion", "material =\nR_e =\nS =\nS_F =\ntau_adm = \"40 MPa\"");
    check(shaft, {{"tau_adm = \"30 MPa\"", "tau_adm"}, {"tau_adm = \"50 MPa\"", ""}});
    check(example_of("vessel.cylinder"), {{"z_l = 0.7", "z_l"}, {"z_l = 1", ""}});
    check(example_of("vessel.cylinder", "z_c = 0.9"), {{"z_c = 0.7", "z_c"}, {"z_c = 1", ""}});
    check(example_of("shaft.press_fit"), {{"R_e_1 = \"100 MPa\"", "R_e_1"}, {"R_e_1 = \"900 MPa\"", ""}});
  }

  TEST_CASE("requirements: those of the step are not below the stated ones") {
    check(example_of("bearing.rolling", "L_h = \"10000 h\""), {{"L_h = \"20000 h\"", "L_h"}, {"L_h = \"5000 h\"", ""}});
    const std::string vessel = example_of("vessel.cylinder", "c = \"1 mm\"\nc_t = \"0.5 mm\"");
    check(vessel, {{"c = \"2 mm\"", "c"}, {"c = \"0.5 mm\"", ""}, {"c_t = \"1 mm\"", "c_t"}, {"c_t = \"0.3 mm\"", ""}});
    check(vessel + "\n" + renamed(vessel, "other"),
          {{"c_t = \"1 mm\"", "c_t"}, {"c = \"2 mm\"", "c"}, {"R = \"700 mm\"", "R"}});
    check(vessel + "\n" + renamed(with_lines(vessel, "c = \"1.5 mm\""), "other"), {{"c = \"2 mm\"", ""}});
    check(example_of("gear.rating"), {{"grade = 9", "grade"}, {"grade = 5", ""}});
    check(example_of("belt.flat", "sigma_f = \"9 MPa\"\nm_f = 6\nL_req = \"4000 h\""),
          {{"L_req = \"5000 h\"", "L_req"}, {"L_req = \"3000 h\"", ""}});
    check(example_of("fatigue.history", "n_req = 10"), {{"n_req = 20", "n_req"}, {"n_req = 5", ""}});
    check(example_of("fatigue.life", "N = 1e5"), {{"N = 1e6", "N"}, {"N = 1e4", ""}});
  }

  TEST_CASE("a key, a spline or a fit that is shorter carries less") {
    check(example_of("shaft.key"), {{"l = \"1000 mm\"", ""}, {"l = \"5 mm\"", "l"}});
    check(example_of("shaft.spline"), {{"l = \"60 mm\"", ""}, {"l = \"40 mm\"", "l"}});
    check(example_of("shaft.press_fit"), {{"l = \"80 mm\"", ""}, {"l = \"40 mm\"", "l"}});
    check(example_of("chain.roller"), {{"S_min = 8", "S_min"}, {"S_min = 7", ""}});
    check(column(), {{"l = \"1 mm\"", "l"}, {"l = \"100 m\"", "l"}});
  }

  TEST_CASE("a value that another step has is meant for that one") {
    const std::string bearing = example_of("bearing.rolling", "L_h = \"10000 h\"");
    const std::string other = renamed(with_lines(bearing, "L_h = \"20000 h\""), "other");
    check(bearing + "\n" + other, {{"L_h = \"20000 h\"", ""}, {"L_h = \"30000 h\"", "L_h"}});
    check(bearing + "\n" + column(), {{"L_h = \"20000 h\"", "L_h"}});
  }

  TEST_CASE("sizes are those of another part where parts have different ones") {
    const std::string gears = example_of("gear.pair", "a_w =");
    check(gears, {{"z_2 = 80", "z_2"}, {"m_n = \"3 mm\"", "m_n"}, {"b = \"50 mm\"", "b"}, {"z_2 = 57", ""}});
    check(gears + "\n" + renamed(gears, "second"), {{"z_1 = 30", "z_1"}, {"z_2 = 80", "z_2"}, {"b = \"50 mm\"", "b"}});
    check(gears + "\n" + renamed(with_lines(gears, "b = \"50 mm\""), "second"), {{"b = \"50 mm\"", ""}});
    check(gears + "\n" + example_of("bearing.rolling"), {{"z_2 = 80", "z_2"}});
    const std::string bevel = example_of("gear.bevel");
    check(bevel + "\n" + renamed(bevel, "second"), {{"J_1 = 0.3", "J_1"}});
  }

  TEST_CASE("a life in cycles, and a helix angle whose axial force no step takes") {
    check(example_of("gear.bevel", "L_h =\nN = 1e7"), {{"L_h = \"30000 h\"", ""}});
    check(example_of("gear.rating"), {{"L_h = \"30000 h\"", ""}});  // rated for endurance
    check(example_of("gear.bevel"), {{"L_h = \"30000 h\"", "L_h"}});
    const std::string spur = example_of("gear.pair", "a_w =\nbeta = \"0 deg\"\nhand =");
    check(spur, {{"beta = \"15 deg\"", ""}});
    check(example_of("gear.pair", "a_w ="), {{"beta = \"15 deg\"", "beta"}});
    const std::string taken =
        "\n[pin]\ncalculator = \"shaft.torsion\"\nT = \"=stage.gear_2.T\"\nd = \"60 mm\"\ntau_adm = \"40 MPa\"\n";
    check(spur + taken, {{"beta = \"15 deg\"", "beta"}});
  }

  TEST_CASE("an input that the step does not have") {
    check(example_of("machine.disc", "material =\nR_e = \"650 MPa\"\nnu ="), {{"nu = 0.29", ""}});
    check(example_of("fatigue.life", "R_e =\nS_F ="), {{"R_e = \"300 MPa\"", ""}});
    check(example_of("shaft.torsion", "d_i ="), {{"d_i = \"10 mm\"", ""}});
    const std::string rod = with_lines(column(), "P = \"100 kN\"");
    check(rod, {{"e_y = \"20 mm\"", "e_y"}, {"e_y = \"0 mm\"", ""}, {"beta_y = 2", "beta_y"}});
    check(example_of("vessel.cylinder"),
          {{"h_l = \"4 m\"", "h_l"}, {"rho = \"1000 kg/m^3\"", ""}, {"h_l = \"0 m\"", ""}});
    check(example_of("shaft.torsion", "tau_adm ="), {{"tau_adm = \"30 MPa\"", "tau_adm"}, {"R_m = \"700 MPa\"", ""}});
    check(example_of("gear.rating"), {{"nu_40 = \"100 mm^2/s\"", "nu_40"}, {"nu_40 = \"220 mm^2/s\"", ""}});
  }

  TEST_CASE("what is not compared") {
    check(column(), {{"P = \"1 MN\"", ""}, {"K_A = 3", ""}});
    check(example_of("bearing.rolling"), {{"n = \"5000 rpm\"", ""}});
    check(example_of("gear.worm"), {{"dT_adm = \"40 K\"", "dT_adm"}, {"dT_adm = \"80 K\"", ""}});
    check(example_of("vessel.cylinder"), {{"R = 3", ""}});
  }

  TEST_CASE("words of a duty, of pivots and of rows") {
    const std::string joint = example_of("pin.joint", "loading = \"steady\"");
    check(joint, {{"duty = \"pulsating, 40 lifts an hour\"", "loading"}, {"duty = \"steady\"", ""}});
    check(example_of("pin.joint", "loading = \"alternating\""), {{"duty = \"pulsating\"", ""}});
    check(example_of("shaft.key"), {{"duty = \"reversing, each lift\"", "torque"}, {"duty = \"non-reversing\"", ""}});
    check(example_of("shaft.set_screw"), {{"load = \"pulsating\"", "load_case"}});
    const std::string fixed = with_lines(column(), "ends = \"fixed_fixed\"");
    check(fixed, {{"base = \"pinned on two anchors\"", "ends"},
                  {"top = \"free\"", "ends"},
                  {"base = \"four anchors\"", ""},
                  {"colour = \"free\"", ""}});
    const std::string half = with_lines(column(), "ends = \"fixed_pinned\"");
    check(half, {{"top = \"hinged\"", ""}, {"support = \"clevis at both ends\"", "ends"}});
    const std::string post =
        "[c]\ncalculator = \"column.buckling\"\nP = \"400 kN\"\nl = \"3.5 m\"\nends = \"pinned_pinned\"\nsection = "
        "\"HEB 160\"\nmaterial = \"S355\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1\n";
    check(post, {{"section = \"HEB 140\"", "P"}, {"section = \"HEB 160\"", ""}, {"chain = \"16B\"", ""}});
    check(
        post,
        {{"steel = \"S185\"", "R_e"}, {"steel = \"S460\"", ""}, {"steel = \"S1100QL\"", ""}, {"steel = \"good\"", ""}});
    check(example_of("gear.worm"), {{"m_x_wheel = \"5 mm\"", "m_x"}, {"m_x_wheel = \"4 mm\"", ""}});
  }
}

TEST_SUITE("project: rows stated otherwise") {
  TEST_CASE("a force of a component next to the resultant of its components") {  // 600, 1429, 300 N: 1579 N
    check_values(&project::rows_stated_otherwise, example_of("shaft.design"),
                 {{"F_gear = \"1700 N\"", "seats.gear.F_z"},
                  {"F_gear = \"-1700 N\"", "seats.gear.F_z"},
                  {"F_gear = \"1600 N\"", ""},
                  {"F_gear = \"1000 N\"", ""},
                  {"F_gear = \"1700 N*m\"", ""},
                  {"F_pulley = \"1700 N\"", ""},
                  {"F_coupling = \"1700 N\"", "seats.coupling.F_x"}});
  }

  TEST_CASE("masses and inertias of a component") {
    check_values(&project::rows_stated_otherwise, example_of("shaft.design"),
                 {{"m_gear = \"2 kg\"", "seats.gear.mass"},
                  {"m_gear = \"1 kg\"", ""},
                  {"m_gear = \"0.5 kg\"", ""},
                  {"mass_gear = \"2 kg\"", ""},
                  {"J_gear = \"0.002 kg*m^2\"", "seats.gear.J"},
                  {"J_gear = \"0.0005 kg*m^2\"", ""},
                  {"b_gear = \"40 mm\"", "seats.gear.b"},
                  {"b_gear = \"20 mm\"", "seats.gear.b"},
                  {"b_gear = \"30 mm\"", ""},
                  {"T_gear = \"60 N*m\"", "seats.gear.T"},
                  {"T_gear = \"40 N*m\"", ""}});
  }
}
