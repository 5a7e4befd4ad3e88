// Each condition of the rules for [values] that begin with the symbol of an input, and for loads that are combined of
// [values].
#include "lib/project/references/stated/qualified.hpp"

#include "lib/project/references/machine/left_out.hpp"
#include "lib/project/references/machine/ratings.hpp"
#include "lib/project/references/stated/combinations.hpp"
#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

void check_symbols(const std::string& steps, std::initializer_list<ValuesRow> rows) {
  check_values(&project::symbols_stated_otherwise, steps, rows);
}

void check_combined(const std::string& steps, std::initializer_list<ValuesRow> rows) {
  check_values(&project::values_left_out_of_loads, steps, rows);
}

void check_loads(const std::string& steps, std::initializer_list<ValuesRow> rows) {
  check_values(&project::loads_left_out, steps, rows);
}

const std::string actions = "G = \"120 kN\"\nQ = \"90 kN\"\n";

std::string column(const std::string& P) {
  return "[c]\ncalculator = \"column.buckling\"\nP = \"" + P +
         "\"\nl = \"4 m\"\nends = \"pinned_pinned\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1\nmaterial = "
         "\"S235JR\"\nsection = \"HEA 160\"\n";
}

std::string rod(const std::string& low) {
  return "[r]\ncalculator = \"fatigue.life\"\nsigma_max = \"=4*values.F_max/(pi*(30 mm)^2)\"\nsigma_min = \"" + low +
         "\"\nsigma_D = \"110 MPa\"\ngroup = \"carbon-steel\"\nmaterial = \"C45E\"\nd_h = \"30 mm\"\nS_D = 1.5\nS_F = "
         "1.5\n";
}

}  // namespace

TEST_SUITE("project: symbols of [values]") {
  TEST_CASE("strengths and ratings below those of the step") {
    const std::string key = example_of("shaft.key");  // R_e_1, R_e_2, R_e_k = 370, 300, 420 MPa
    check_symbols(key, {{"R_e_hub = \"180 MPa\"", "R_e_2"},
                        {"R_e_hub = \"300 MPa\"", ""},
                        {"R_e_bush_max = \"180 MPa\"", ""},
                        {"R_m_hub = \"180 MPa\"", ""}});
    const std::string rating = example_of("gear.rating");  // H_1, H_2 = 720
    check_symbols(rating, {{"H_wheel = 300", "H_1"}, {"H_wheel = 720", ""}, {"H_core = 300", ""}, {"H_h = 300", ""}});
    check_symbols(example_of("gear.bevel"),
                  {{"H_B_wheel = 180", "H_B2"}, {"Q_v_made = 6", "Q_v"}, {"Q_v_made = 9", ""}});
    check_symbols(example_of("link.member"), {{"E_aluminium = \"70 GPa\"", "E"}, {"E_steel = \"210 GPa\"", ""}});
    check_symbols(example_of("bearing.rolling"), {{"C_catalogue = \"20 kN\"", "C"}, {"C_req = \"20 kN\"", ""}});
    check_symbols(example_of("fatigue.fkm"), {{"R_m_tested = \"850 MPa\"", "R_mN"}, {"R_m_tested = \"1200 MPa\"", ""}});
  }

  TEST_CASE("factors and requirements above those of the step") {
    const std::string rating = example_of("gear.rating");  // K_A = 1.25, grade 6, S_Fmin = 1.4
    check_symbols(rating, {{"K_A_crusher = 1.75", "K_A"},
                           {"K_A_fan = 1.1", ""},
                           {"grade_made = 9", "grade"},
                           {"grade_made = 5", ""},
                           {"S_F_req = 2", "S_Fmin"},
                           {"S_F_min = 2", "S_Fmin"},
                           {"S_F_req = 1.2", ""},
                           {"S_F_limit = 2", ""}});
    check_symbols(example_of("vessel.cylinder"), {{"c_sheet = \"3 mm\"", "c"}, {"c_sheet = \"0.5 mm\"", ""}});
    check_symbols(example_of("fatigue.combined"), {{"tau_a_max = \"60 MPa\"", "tau_a"}, {"tau_a_max = \"9 MPa\"", ""}});
  }

  TEST_CASE("loads under any word but those of limits and other states") {
    const std::string bearing = example_of("bearing.rolling");  // F_r = 2.5 kN, F_a = 1 kN
    check_loads(bearing, {{"F_top = \"6 kN\"", "F_r"},
                          {"F_top = \"2 kN\"", ""},
                          {"F_idle = \"6 kN\"", ""},
                          {"F_adm = \"6 kN\"", ""},
                          {"F_top = \"600 kN\"", ""}});
    check_loads(
        "[t]\ncalculator = \"shaft.torsion\"\nP = \"7.5 kW\"\nn = \"180 rpm\"\nd = \"63 mm\"\nmaterial = "
        "\"C45E\"\nS = 2\n",
        {{"T_start = \"1100 N*m\"", "T"}, {"T_start = \"390 N*m\"", ""}, {"M_bend = \"600 N*m\"", "T"}});
    check_loads(example_of("column.buckling"), {{"F_side = \"2 kN\"", "P"}, {"F_far = \"2 kN\"", ""}});
    check_loads(example_of("shaft.press_fit"), {{"F_axial = \"20 kN\"", "F_z"}, {"F_axial_adm = \"20 kN\"", ""}});
    check_loads(example_of("column.beam_column"), {{"q_wind = \"3 kN/m\"", "q_z"}});
    check_loads(example_of("column.beam_column", "q_z = \"3 kN/m\""), {{"q_wind = \"3 kN/m\"", ""}});
  }

  TEST_CASE("a face width of many pitch diameters") {
    const auto found = [](const std::string& b) {
      return inputs_found(&project::values_of_ratings, example_of("gear.rating", "b = \"" + b + "\""));
    };
    CHECK(found("140 mm").empty());  // m_n z_1 = 76 mm
    CHECK(found("480 mm") == "b");
  }

  TEST_CASE("a rougher surface, a smaller housing, a hardness by its word") {
    check_symbols(example_of("fatigue.din743"), {{"R_z_turned = \"25 um\"", "R_z"}, {"R_z_ground = \"4 um\"", ""}});
    check_symbols(example_of("gear.worm"),
                  {{"A_h_measured = \"0.15 m^2\"", "A_h"}, {"A_h_measured = \"0.3 m^2\"", ""}});
    check_symbols(example_of("gear.rating"),
                  {{"wheel_hardness = 280", "H_1"}, {"wheel_hardness = 720", ""}, {"core_hardness = 280", ""}});
  }

  TEST_CASE("a vertical action in the moment only") {
    check_combined(column("=values.G + values.Q"), {{actions, ""}});
    const auto beam = [](const std::string& P) {
      return example_of("column.beam_column", "P = \"" + P + "\"\nM_y_1 = \"=(1.35*values.G + 1.5*values.Q)*(40 mm)\"");
    };
    check_combined(beam("=1.35*values.G"), {{actions, "P"}});
    check_combined(beam("=1.35*values.G + 1.5*values.Q"), {{actions, ""}});
    check_combined(beam("=1.35*values.G + 1.5*values.Q"),
                   {{actions + "H_braking = \"8 kN\"", "P"}, {actions + "H = \"8 kN\"", ""}});
  }

  TEST_CASE("loads next to a cycle: a reversed one, bending, a hole, a larger one") {
    const std::string loads = "F_max = \"80 kN\"\n";
    check_combined(rod("0 MPa"), {{loads + "F_back = \"-40 kN\"", "sigma_max"},
                                  {loads + "M_b = \"300 N*m\"", "sigma_max"},
                                  {loads + "M_head = \"300 N*m\"", ""},
                                  {loads + "d_hole = \"6 mm\"", "sigma_max"},
                                  {loads + "F_abuse = \"90 kN\"", "sigma_max"},
                                  {loads + "F_mean = \"40 kN\"", ""}});
  }

  TEST_CASE("the mass of an attachment next to the weight of another one") {
    const std::string lug = example_of("pin.lug", "F = \"=values.m*9.81 m/s^2\"");
    check_combined(lug, {{"m = \"900 kg\"\nm_block = \"90 kg\"", "F"}, {"m = \"900 kg\"\nm_frame = \"90 kg\"", ""}});
  }

  TEST_CASE("strengths of one material, and stresses of one part, in proportion") {
    const auto check_ratings = [](const std::string& lines, const std::string& inputs) {
      CHECK_MESSAGE(
          inputs_found(&project::strengths_out_of_proportion, example_of("fatigue.combined", lines)) == inputs, lines);
    };
    check_ratings("R_m = \"690 MPa\"\nR_e = \"490 MPa\"", "");
    check_ratings("R_m = \"690 MPa\"\nR_e = \"49 MPa\"", "R_m");
    check_ratings("sigma_D = \"180 MPa\"\ntau_D = \"11 MPa\"", "sigma_D");
    CHECK(inputs_found(&project::strengths_out_of_proportion,
                       example_of("shaft.overhung", "sigma_adm = \"900 MPa\"\ntau_adm = \"50 MPa\"")) == "sigma_adm");
  }

  TEST_CASE("the strength of a part by its word, forces at the rim of a disc, an added eccentricity") {
    const std::string key = example_of("shaft.key", "R_e_1 = \"370 MPa\"\nR_e_2 = \"300 MPa\"\nR_e_k = \"420 MPa\"");
    check_symbols(
        key, {{"R_e_key = \"350 MPa\"", "R_e_k"}, {"R_e_shaft = \"320 MPa\"", "R_e_1"}, {"R_e_key = \"420 MPa\"", ""}});
    check_combined(example_of("machine.disc"), {{"m_blades = \"12 kg\"", "D"}, {"m_casing = \"12 kg\"", ""}});
  }
}

TEST_SUITE("project: loads combined of [values]") {
  TEST_CASE("actions that no step takes") {
    check_combined(column("=1.35*values.G"), {{actions, "P"}});
    check_combined(column("=1.35*values.G + 1.5*values.Q"), {{actions, ""},
                                                             {actions + "Q_snow = \"40 kN\"", "P"},
                                                             {actions + "W = \"40 kN\"", "P"},
                                                             {actions + "Q_adm = \"40 kN\"", ""},
                                                             {actions + "H_axis = \"40 kN\"", ""}});
    check_combined(column("400 kN"), {{"Q_snow = \"40 kN\"", ""}});
  }

  TEST_CASE("factors and peaks of a value, and the other end of a cycle") {
    check_combined(
        column("=values.F"),
        {{"F = \"300 kN\"\nf_F = 1.25", "P"}, {"F = \"300 kN\"\nf_F = 1", ""}, {"F = \"300 kN\"\nf_T = 1.25", ""}});
    const std::string jack = column("=values.p_oil*pi*(63 mm)^2/4");
    check_combined(jack, {{"p_oil = \"160 bar\"\np_relief = \"250 bar\"", "P"},
                          {"p_oil = \"160 bar\"\np_relief = \"160 bar\"", ""},
                          {"p_oil = \"160 bar\"\np_idle = \"250 bar\"", ""}});
    check_combined(rod("0 MPa"), {{"F_max = \"80 kN\"\nF_min = \"-10 kN\"", "sigma_max"}, {"F_max = \"80 kN\"", ""}});
    check_combined(rod("=4*values.F_min/(pi*(30 mm)^2)"), {{"F_max = \"80 kN\"\nF_min = \"-10 kN\"", ""}});
  }

  TEST_CASE("notches and ranges next to a typed fatigue limit") {
    const std::string one = "F_max = \"40 kN\"\n";
    check_combined(rod("0 MPa"), {{one + "K_t_thread = 3", "sigma_D"},
                                  {one + "beta_k = 1.6", "sigma_D"},
                                  {one + "K_t_thread = 1", ""},
                                  {one + "sigma_range = \"110 MPa\"", "sigma_D"},
                                  {one + "sigma_range = \"220 MPa\"", ""}});
  }
}
