// Each condition of the rules for conditions of service that only [values] state.
#include "lib/project/references/stated/conditions.hpp"

#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

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
    "= \"90 MPa\"\nmaterial = \"S355\"\nS = 2\n";

const std::string bearing =
    "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6309\"\nF_r = \"6 kN\"\nn = \"1200 rpm\"\nL_h = \"3000 "
    "h\"\ns_0 = 1.5\n";

const std::string history =
    "[h]\ncalculator = \"fatigue.history\"\nblocks = [{ sigma_a = \"180 MPa\", n = 500 }]\nsigma_D = \"120 MPa\"\nN_D "
    "= "
    "1e6\nk = 5\nmean = \"goodman\"\nR_m = \"690 MPa\"\nR_e = \"490 MPa\"\nS_F = 1.5\nn_req = 10\n";

const std::string life =
    "[l]\ncalculator = \"fatigue.life\"\nsigma_max = \"300 MPa\"\nsigma_min = \"-300 MPa\"\nsigma_D = \"250 MPa\"\n"
    "R_m = \"690 MPa\"\nR_e = \"490 MPa\"\ngroup = \"carbon-steel\"\nN = 1e4\nS_D = 1.2\nS_F = 1.5\n";

const std::string shaft =
    "[t]\ncalculator = \"shaft.torsion\"\nT = \"300 N*m\"\nd = \"60 mm\"\nmaterial = \"C45E\"\nS = 2\n";

void check(const std::string& steps, std::initializer_list<ValuesRow> rows) {
  check_values(&project::conditions_stated_only, steps, rows);
}

void names(const std::string& steps, std::initializer_list<const char*> all, const std::string& value,
           const std::string& inputs) {
  check_names(&project::conditions_stated_only, steps, all, value, inputs);
}

}  // namespace

TEST_SUITE("project: conditions of service") {
  TEST_CASE("a reliability above that of the rating life") {
    check(bearing, {{"reliability = 0.99", "R"},
                    {"survival = 0.99", "R"},
                    {"safety = 0.99", ""},
                    {"reliability = 0.9", ""},
                    {"reliability = 1", ""},
                    {"reliability = 99", ""}});
    check(bearing + "R = 0.95\n",
          {{"reliability = 0.99", "R"}, {"reliability = 0.95", ""}, {"reliability = 0.92", ""}});
    for (const std::string& other : {column, shell}) check(other, {{"reliability = 0.99", ""}});
    check(bearing + "a_1 = 0.6\n", {{"reliability = 0.99", ""}});
  }

  TEST_CASE("a factor of seams below that of the wall") {
    for (const std::string seam : {"weld", "seam", "joint"})
      for (const std::string factor : {"factor", "efficiency", "coefficient"})
        check(shell, {{seam + "_" + factor + " = 0.85", "z_l"}});
    check(shell, {{"weld = 0.85", ""},
                  {"efficiency = 0.85", ""},
                  {"weld_factor = 1", ""},
                  {"weld_factor = 0.9995", ""},
                  {"weld_factor = 0", ""},
                  {"weld_factor = -0.5", ""}});
    check(column, {{"weld_factor = 0.85", ""}});
  }

  TEST_CASE("a partial factor of loads above that of the column") {
    check(column, {{"gamma_Q = 1.5", "gamma_F"},
                   {"gamma_Q = 1.351", ""},
                   {"gamma_Q = 1.2", ""},
                   {"gamma_M2 = 1.5", ""},
                   {"gamma_R = 1.5", ""},
                   {"partial_gamma_Q = 1.5", ""}});
  }

  TEST_CASE("a dynamic factor of a load without an application factor") {
    names(lug,
          {"phi", "phi_dyn", "f_dyn", "k_dyn", "f_w", "f_s", "dynamic_factor", "load_factor", "impact_factor",
           "shock_factor", "gust_coefficient", "surge_allowance", "dyn_psi", "overload_factor", "shock_f", "shock_k",
           "gust_phi", "impact_load_factor", "f"},
          "1.4", "F");
    names(lug, {"impact", "factor", "shape_factor", "impact_factor_of_cranes", "k", "psi"}, "1.4", "");
    check(lug, {{"phi = 1", ""}, {"phi = 1.001", ""}, {"phi = 5", "F"}, {"phi = 5.01", ""}, {"gamma_Q = 1.5", "F"}});
    check(lug + "K_A = 1.2\n", {{"phi = 1.4", ""}});
    check(lug + "K_A = 1\n", {{"phi = 1.4", "F"}});
    check(column, {{"f = 1.4", ""}, {"load_factor = 1.35", ""}, {"load_factor = 1.5", "P"}, {"phi = 1.3", "P"}});
    for (const std::string name : {"phi", "wind"}) check(example_of("dynamics.inertia"), {{name + " = 1.4", ""}});
    std::string of_step = lug;
    of_step.replace(of_step.find("50 kN"), 5, "=w.T/0.01 m");
    const std::string torque =
        "\n[w]\ncalculator = \"shaft.torsion\"\nT = \"100 N*m\"\nd = \"60 mm\"\ntau_adm = \"40 "
        "MPa\"\n";
    check(of_step + torque, {{"phi = 1.4", ""}});  // the load of another step
    const std::string plate = with_lines(lug, "t = \"=w.d/2\"");
    check(plate + torque, {{"phi = 1.4", "F"}});
    std::string of_value = lug;
    of_value.replace(of_value.find("50 kN"), 5, "=values.F_s");
    check(of_value, {{"F_s = \"50 kN\"\nphi = 1.4", "F"}});
  }

  TEST_CASE("loads of the surroundings") {
    names(column,
          {"wind",          "gust",       "snow",        "ice",          "seismic",    "earthquake", "tilt",
           "sway",          "unbalance",  "imbalance",   "misalignment", "settlement", "tilt_angle", "wind_load",
           "wind_pressure", "wind_force", "wind_moment", "wind_speed",   "wind_max",   "design_wind"},
          "3", "P");
    names(column, {"angle", "load", "wind_tower", "q_snow", "F_wind"}, "3", "");
    check(column, {{"tilt = 0", ""}});
    for (const std::string word : {"none", "no", "free", "missing"}) {
      for (const std::string name : {"restraint", "restraints", "bracing", "braces", "braces_bracing"})
        check(column, {{name + " = \"" + word + "\"", "P"}});
    }
    check(column, {{"restraints = \"three\"", ""}, {"bracing_plan = \"none\"", ""}, {"coating = \"none\"", ""}});
  }

  TEST_CASE("a relief, set or test pressure above that of a wall") {
    names(shell,
          {"p_relief", "p_opening", "p_blowoff", "p_blow_off", "p_MAWP", "p_burst", "p_set", "pset", "p_psv", "p_prv",
           "p_srv", "p_sv", "p_rv", "p_ps", "p_safety", "p_test", "p_hydro", "p_proof"},
          "\"1.05 MPa\"", "p");
    names(shell,
          {"sigma_test", "tau_test", "stress_test", "strength_test", "r_test", "e_test", "s_test", "yield_test",
           "modulus_test", "p_fill", "p_steam"},
          "\"1.5 MPa\"", "");
    check(shell, {{"p_relief = \"1.001 MPa\"", ""},
                  {"p_relief = \"-1.2 MPa\"", "p"},
                  {"p_valve = \"1.1 MPa\"", ""},
                  {"p_valve = \"1.11 MPa\"", "p"},
                  {"p_valve_set = \"1.05 MPa\"", "p"},
                  {"p_valve_test = \"1.05 MPa\"", "p"}});
    const std::string tested = shell + "p_t = \"1.5 MPa\"\nh_t = \"0 m\"\nR_e_t = \"235 MPa\"\n";
    check(tested, {{"p_test = \"1.5 MPa\"", ""}, {"p_test = \"1.6 MPa\"", "p_t"}, {"p_set = \"1.4 MPa\"", "p"}});
    check(column, {{"p_relief = \"2 MPa\"", ""}});
    std::string other = shell;
    other.replace(0, 3, "\n[o]").replace(other.find("1 MPa"), 5, "3 MPa").replace(other.find("12 mm"), 5, "30 mm");
    check(shell + other, {{"p_relief = \"2 MPa\"", ""}, {"p_relief = \"4 MPa\"", "p"}});  // of the other one
  }

  TEST_CASE("load cycles of a part whose fatigue nothing assesses") {
    check(shell, {{"N = 1e6", "p"},
                  {"N_cycles = 1e6", "p"},
                  {"cycles = 1e4", "p"},
                  {"cycles = 9999", ""},
                  {"N_start = 1e6", ""}});
    check(lug, {{"N = 1e6", "F"}});
    check(shaft, {{"N = 1e6", "F"}});
    check(shell + "accept.fatigue = \"steady\"\n", {{"N = 1e6", ""}});
    check(shell + "\n" + life, {{"N = 1e6", ""}});
    check(bearing, {{"N = 1e6", ""}});  // its life is assessed
    check(shaft + "\n" + example_of("shaft.design"), {{"N = 1e6", ""}});
    check(shell + "\n" + example_of("shaft.design"), {{"N = 1e6", "p"}});
    check(example_of("shaft.key"), {{"N = 1e6", "T"}});
    check(example_of("belt.synchronous"), {{"N = 1e6", "P"}});
    check(column, {{"N = 1e6", ""}});
  }

  TEST_CASE("repetitions, a life and years next to those of a step") {
    names(history, {"passages", "passes", "starts", "trips"}, "20", "n_req");
    check(history,
          {{"passages = 10", ""}, {"passages = 10.005", ""}, {"passages = 10.02", "n_req"}, {"stops = 20", ""}});
    check(shell, {{"passages = 20", ""}});
    check(history + "t = \"2 h\"\n",
          {{"life = \"30 h\"", "n_req"}, {"life = \"20 h\"", ""}, {"grease = \"30 h\"", ""}, {"life = 30", ""}});
    check(history, {{"life = \"30 h\"", ""}});
    check(life, {{"years = 10", "N"}, {"years = 0", ""}, {"months = 10", ""}});
    check(history, {{"years = 10", ""}});
    for (const std::string& other :
         {bearing, column, with_lines(life, "N ="), example_of("gear.bevel", "L_h =\nN = 1e7")})
      check(other, {{"years = 10", ""}});
    check(column, {{"life = \"30 h\"", ""}});
  }

  TEST_CASE("an overspeed up to three times the speed") {
    names(disc, {"n_over", "overspeed", "n_trip", "n_runaway", "n_burst", "n_spin"}, "\"3450 rpm\"", "n");
    check(disc, {{"n_over = \"3000 rpm\"", ""},
                 {"n_over = \"9000 rpm\"", "n"},
                 {"n_over = \"9010 rpm\"", ""},
                 {"n_over = \"-3450 rpm\"", "n"},
                 {"n_limit = \"3450 rpm\"", ""},
                 {"n_over = 3450", ""}});
    check(column, {{"n_over = \"3450 rpm\"", ""}});
    check(example_of("gear.pair"), {{"n_1_fast = \"1450 rpm\"", ""},  // of the step: 1450 rpm
                                    {"n_1_fast = \"1600 rpm\"", "n_1"},
                                    {"n_1_fast = \"4400 rpm\"", ""}});
    std::string other = disc;
    other.replace(0, 3, "\n[o]").replace(other.find("3000 rpm"), 8, "3450 rpm");
    check(disc + other, {{"n_over = \"3450 rpm\"", ""}, {"n_over = \"3600 rpm\"", "n"}});
  }

  TEST_CASE("the level of a liquid next to a wall without one") {
    const std::string water = "rho = \"1000 kg/m^3\"\n";
    for (const std::string name : {"H", "h", "level", "height", "fill", "filling_height", "liquid"})
      check(shell, {{water + name + " = \"12 m\"", "p"}});
    check(shell, {{water + "H = \"0 m\"", ""},
                  {water + "L = \"12 m\"", ""},
                  {"H = \"12 m\"", ""},
                  {"H = \"12 m\"\nrho = \"1.2 kg/m^3\"", ""},
                  {"H = \"12 m\"\nrho = \"300 kg/m^3\"", ""},
                  {"H = \"12 m\"\nrho = \"3000 kg/m^3\"", ""},
                  {"H = \"12 m\"\nrho = \"7850 kg/m^3\"", ""},
                  {"H = \"12 m\"\nrho = 1000", ""}});
    check(shell + "h_l = \"2 m\"\nrho = \"1000 kg/m^3\"\n", {{water + "H = \"12 m\"", ""},
                                                             {"h_max = \"3 m\"", "h_l"},
                                                             {"h_max = \"2 m\"", ""},
                                                             {"liquid_level = \"3 m\"", "h_l"}});
    check(column, {{water + "H = \"12 m\"", ""}});
  }

  TEST_CASE("openings of a vessel, holes of a disc") {
    names(shell, {"nozzle", "nozzles", "opening", "openings", "manhole", "hole", "holes", "branch", "d_nozzle"},
          "\"400 mm\"", "p");
    check(shell, {{"d_pipe = \"400 mm\"", ""}, {"d_nozzle = \"0 mm\"", ""}});
    check(shell + "accept.nozzles = \"sheet 3\"\n", {{"d_nozzle = \"400 mm\"", ""}});
    check(disc, {{"d_hole = \"20 mm\"", "D"}, {"d_holes = \"20 mm\"", "D"}, {"d_nozzle = \"20 mm\"", ""}});
    check(disc + "accept.notches = \"sheet 3\"\n", {{"d_hole = \"20 mm\"", ""}});
    check(column, {{"d_hole = \"20 mm\"", ""}});
  }

  TEST_CASE("a residual stress next to a cycle") {
    check(life, {{"sigma_res = \"50 MPa\"", "sigma_m"},
                 {"residual = \"50 MPa\"", "sigma_m"},
                 {"sigma_res = \"-50 MPa\"", ""},
                 {"sigma_res = \"0 MPa\"", ""},
                 {"sigma_rest = \"50 MPa\"", ""},
                 {"residual = 50", ""}});
    check(column, {{"sigma_res = \"50 MPa\"", ""}});
  }

  TEST_CASE("a temperature at which steel may be brittle") {
    names(shell,
          {"T_min", "t_design", "theta_ambient", "T_service", "T_operating", "temperature", "T_low", "t", "theta",
           "ambient", "T_theta"},
          "\"-60 degC\"", "p");
    check(shell, {{"T_min = \"-19 degC\"", ""},
                  {"T_store = \"-60 degC\"", ""},
                  {"min = \"-60 degC\"", ""},
                  {"low = \"-60 degC\"", ""}});
    check(shaft, {{"T_min = \"-60 degC\"", "T"}});
    check(disc, {{"T_min = \"-60 degC\"", "n"}});
    check(bearing, {{"T_min = \"-60 degC\"", ""}});
    check(shell + "accept.low_temperature = \"P355NL1\"\n", {{"T_min = \"-60 degC\"", ""}});
    check(shaft + "accept.brittle = \"tested\"\n", {{"T_min = \"-60 degC\"", ""}});
    check(column, {{"T_min = \"-60 degC\"", ""}});
  }

  TEST_CASE("a corrosive environment next to strengths in air") {
    for (const std::string word : {"corrosive", "sea water", "salt spray", "acid", "chlorides"}) {
      for (const std::string name : {"environment", "atmosphere", "surroundings", "medium"})
        check(life, {{name + " = \"" + word + "\"", "surroundings"}});
    }
    check(life, {{"environment = \"dry air\"", ""}, {"coating = \"salt\"", ""}});
    check(life + "accept.surroundings = \"painted\"\n", {{"environment = \"acid\"", ""}});
    check(column, {{"environment = \"acid\"", ""}});
    check(example_of("shaft.design"), {{"environment = \"acid\"", "corrosion"}});
    check(shaft, {{"environment = \"acid\"", ""}});
  }

  TEST_CASE("a warm room around a worm gear") {
    const std::string worm =
        "[w]\ncalculator = \"gear.worm\"\nz_1 = 2\nz_2 = 40\nm_x = \"4 mm\"\nd_1 = \"40 mm\"\nb_2 = \"30 mm\"\nP = "
        "\"0.6 kW\"\nn_1 = \"1400 rpm\"\ncasting = \"chill\"\nS_Wmin = 1\nsigma_adm = \"60 MPa\"\nA_h = \"0.25 "
        "m^2\"\ndT_adm = \"60 K\"\n";
    names(worm, {"ambient", "T_room", "T_hall", "T_air"}, "\"45 degC\"", "dT_adm");
    check(worm, {{"ambient = \"40 degC\"", ""}, {"T_oil = \"45 degC\"", ""}, {"ambient = \"20 degC\"", ""}});
    check(column, {{"ambient = \"60 degC\"", ""}});
  }

  TEST_CASE("a fast flywheel, counted strokes, a seam and factors of loads by their words") {
    const std::string wheel = example_of("machine.flywheel");  // 180 rpm
    check(wheel, {{"n_fast = \"260 rpm\"", "omega"}, {"n_fast = \"150 rpm\"", ""}, {"n_fast = \"900 rpm\"", ""}});
    check(lug, {{"N_strokes = 500000", "F"}, {"N_lifts = 2e6", "F"}, {"N_lifts = 100", ""}});
    check(shell, {{"seam = 0.7", "z_l"}, {"seam = 1", ""}});
    check(lug, {{"phi_crane = 1.25", "F"}, {"phi_min = 1", ""}, {"phi_crane = \"30 deg\"", ""}});
    const std::string point = example_of("fatigue.combined");
    check(point, {{"K_A = 1.5", "sigma_m"}, {"K_A_mill = 1.5", "sigma_m"}, {"K_A = 1", ""}});
    check(point + shaft, {{"K_A = 1.5", ""}});  // a factor of the shaft
    check(shell, {{"d_manway = \"500 mm\"", "p"}});
  }
}
