// Regression tests of [values] that no step takes, under names of their own: peaks, lives, temperatures, a vacuum, a
// motor.
#include "tests/found/modes.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string under(const std::string& values, const std::string& steps) {
  return "[values]\n" + values + "\n\n" + steps;
}

/// Whether a step passes a mode with these values, as it does without them.
bool is_held(const std::string& values, const std::string& steps, std::string_view step, std::string_view mode) {
  CHECK(mode_of(solved_as_found(steps), step, mode) == "pass");
  const std::string state = mode_of(solved_as_found(under(values, steps)), step, mode);
  CHECK((state == "pass" || state == "not-judged"));
  return state == "not-judged";
}

const std::string key =
    "[key]\ncalculator = \"shaft.key\"\nT = \"300 N*m\"\ntorque = \"one_way\"\nd = \"50 mm\"\nkey = \"14x9\"\nl = \"70 "
    "mm\"\nl_n = \"75 mm\"\nR_e_1 = \"370 MPa\"\nR_e_2 = \"300 MPa\"\nR_e_k = \"420 MPa\"\n";

const std::string bearing =
    "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6308\"\nF_r = \"2 kN\"\nn = \"1000 rpm\"\nL_h = \"10000 "
    "h\"\ns_0 = 1.5\n";

const std::string shell =
    "[shell]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\nc = \"1 mm\"\nsigma_adm = \"120 MPa\"\n";

const std::string wheels =
    "[w]\ncalculator = \"drive.friction_wheels\"\nP = \"1.5 kW\"\nn_1 = \"700 rpm\"\nd_1 = \"200 mm\"\nd_2 = \"600 "
    "mm\"\nb = \"80 mm\"\npair = \"leather\"\nq_adm = \"30 N/mm\"\n";

const std::string belt =
    "[belt]\ncalculator = \"belt.flat\"\nP = \"15 kW\"\nK_A = 1.2\nn_1 = \"1450 rpm\"\nd_1 = \"200 mm\"\nd_2 = \"500 "
    "mm\"\na = \"1200 mm\"\nmu = 0.4\nkind = \"synthetic\"\ndelta = \"2.5 mm\"\nrho = \"1100 kg/m^3\"\nsigma_adm = \"6 "
    "MPa\"\nE_b = \"40 MPa\"\nsigma_f = \"9 MPa\"\nm_f = 6\nL_req = \"4000 h\"\n";

}  // namespace

TEST_SUITE("found names of stated values") {
  TEST_CASE("a life of [values] above the required life of a belt, under any name") {
    for (const char* const values :
         {"L_req = \"20000 h\"", "L_h = \"20000 h\"", "life = \"40000 h\"", "years = 10\nhours_per_day = \"16 h\""})
      CHECK(is_held(values, belt, "belt", "strength"));
    CHECK(!is_held("L_h = \"4000 h\"", belt, "belt", "strength"));
    for (const char* const values :
         {"L_req = \"2000 h\"", "L_req = \"4000 h\"", "L_h = \"2000 h\"", "life = \"2000 h\""})
      CHECK_FALSE(is_held(values, belt, "belt", "strength"));
  }

  TEST_CASE("load cycles of [values] above those of a part, under their own name") {
    const std::string part =
        "[part]\ncalculator = \"fatigue.life\"\nsigma_max = \"300 MPa\"\nsigma_min = \"-300 MPa\"\nsigma_D = \"250 "
        "MPa\"\n"
        "R_m = \"690 MPa\"\nR_e = \"490 MPa\"\ngroup = \"carbon-steel\"\nN = 1e4\nS_D = 1.2\nS_F = 1.5\n";
    CHECK(is_held("N = 1e5", part, "part", "fatigue"));
    CHECK_FALSE(is_held("N = 1e3", part, "part", "fatigue"));
  }

  TEST_CASE("a peak factor next to the peak torque of a key") {
    for (const char* const name : {"k_max", "k_start", "start_factor", "T_max_factor", "shock"})
      CHECK(is_held(std::string(name) + " = 4", key, "key", "hub"));
    for (const char* const values : {"k_max = 0.9", "n_start = 4", "k_max = 40", "k_wear = 4"})
      CHECK_FALSE(is_held(values, key, "key", "hub"));
    CHECK_FALSE(is_held("k_max = 2", key + "T_max = \"600 N*m\"\n", "key", "hub"));
    const std::string limited = under("k_max = 2", key + "because.T_max = \"a clutch limits it\"\n");
    CHECK(mode_of(solved_as_found(limited), "key", "hub") == "pass");
  }

  TEST_CASE("a shock next to the application factor of a machine without peak factors") {
    CHECK(is_held("shock = 3", bearing, "b", "fatigue"));
    CHECK_FALSE(is_held("shock = 1", bearing, "b", "fatigue"));
  }

  TEST_CASE("a required life under another name, and a reliability") {
    for (const char* const values :
         {"life = \"40000 h\"", "service_life = \"40000 h\"", "R = 0.99", "years = 10\nhours_per_day = \"16 h\""})
      CHECK(is_held(values, bearing, "b", "fatigue"));
    for (const char* const values :
         {"life = \"9000 h\"", "grease_life = \"40000 h\"", "R = 0.5", "years = 1\nhours_per_day = \"16 h\""})
      CHECK_FALSE(is_held(values, bearing, "b", "fatigue"));
    // 250 days a year: that of the bearing, and 125 h more.
    for (const char* const values : {"life = \"10000 h\"", "years = 5\nhours_per_day = \"8 h\""})
      CHECK_FALSE(is_held(values, bearing, "b", "fatigue"));
    CHECK(is_held("years = 5\nhours_per_day = \"8.1 h\"", bearing, "b", "fatigue"));
  }

  TEST_CASE("a speed above the limit of the bearing") {
    CHECK(is_held("n_max = \"20000 rpm\"", bearing, "b", "fatigue"));
    CHECK_FALSE(is_held("n_max = \"3000 rpm\"", bearing, "b", "fatigue"));
  }

  TEST_CASE("a larger load under its own name, a peak of it") {
    for (const char* const values : {"F_r = \"20 kN\"", "F_max = \"60 kN\""})
      CHECK(is_held(values, bearing, "b", "fatigue"));
    for (const char* const values : {"F_r = \"1 kN\"", "F_clamp = \"20 kN\""})
      CHECK_FALSE(is_held(values, bearing, "b", "fatigue"));
  }

  TEST_CASE("a temperature without an index, and that of the surroundings") {
    for (const char* const values : {"T = \"400 degC\"", "ambient = \"200 degC\""})
      CHECK(is_held(values, shell, "shell", "strength"));
    CHECK(is_held("T = \"200 degC\"", bearing, "b", "fatigue"));
    for (const char* const values : {"T = \"60 degC\"", "t_join = \"200 degC\"", "T_joining = \"200 degC\""})
      CHECK_FALSE(is_held(values, shell, "shell", "strength"));
    CHECK_FALSE(is_held("T = \"110 degC\"", bearing, "b", "fatigue"));
  }

  TEST_CASE("a vacuum under other names, and a larger allowance for corrosion") {
    for (const char* const values :
         {"vacuum = \"-0.1 MPa\"", "p_vac = \"0.1 MPa\"", "p_ext = \"0.1 MPa\"", "vacuum = \"full\"", "c = \"3 mm\""})
      CHECK(is_held(values, shell, "shell", "strength"));
    for (const char* const values : {"p_valve = \"1.1 MPa\"", "vacuum = \"none\"", "c = \"0.5 mm\"", "c = 3"})
      CHECK_FALSE(is_held(values, shell, "shell", "strength"));
    // The allowance is that of every wall.
    std::string second = shell;
    second.replace(1, 5, "other");
    CHECK(is_held("c = \"3 mm\"", shell + second, "shell", "strength"));
  }

  TEST_CASE("a motor that is weaker than its drive, or has another speed") {
    for (const char* const values :
         {"P_motor = \"1.1 kW\"", "T_motor = \"10 N*m\"", "n_motor = \"1450 rpm\"", "n = \"1450 rpm\""})
      CHECK(is_held(values, wheels, "w", "contact"));
    for (const char* const values : {"P_motor = \"2.2 kW\"", "T_motor = \"30 N*m\"", "n_motor = \"720 rpm\"",
                                     "n = \"235 rpm\"", "n_target = \"900 rpm\""})
      CHECK_FALSE(is_held(values, wheels, "w", "contact"));
  }

  TEST_CASE("a reason next to the first speed of a drive answers for its motor") {
    std::string second = wheels;
    second.replace(1, 1, "v");
    const std::string reason = wheels + "because.P = \"the drive is throttled\"\n";
    CHECK(mode_of(solved_as_found(under("P_motor = \"1.1 kW\"", reason + second)), "v", "contact") == "pass");
  }

  TEST_CASE("a torque above those of a drive, which 61 N m reach on its slow side; an energy is not a torque") {
    for (const char* const values : {"T_max = \"100 N*m\"", "T_2 = \"100 N*m\""})
      CHECK(is_held(values, wheels, "w", "contact"));
    for (const char* const values : {"T_max = \"100 J\"", "T_2 = \"100 J\"", "T_max = \"60 N*m\""})
      CHECK_FALSE(is_held(values, wheels, "w", "contact"));
  }

  TEST_CASE("a value under its own name, except for a fraction that nothing explains") {
    const auto with_life = [](const std::string& life) {
      return "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6308\"\nF_r = \"2 kN\"\nn = \"1000 rpm\"\ns_0 = "
             "1.5\nL_h = \"" +
             life + "\"\n";
    };
    const auto rated = [&](const std::string& life, const std::string& more = "") {
      return mode_of(solved_as_found(under("L = \"50000 h\"\nshare = 0.1", with_life(life) + more)), "b", "fatigue");
    };
    CHECK(rated("=values.L/10") == "not-judged");
    CHECK(rated("=values.L/10", "because.L_h = \"exchanged every year\"\n") == "pass");
    CHECK(rated("=values.share*values.L") == "pass");  // the file states the share
    const auto shaft = [](const std::string& values, const std::string& lines) {
      return mode_of(solved_as_found(under(
                         values, "[s]\ncalculator = \"shaft.torsion\"\nT = \"300 N*m\"\nd = \"60 mm\"\n" + lines)),
                     "s", "yield");
    };
    const auto keyed = [](const std::string& lines) {
      std::string half = key;
      half.replace(half.find("300 N*m"), 7, "=values.T/2");
      return mode_of(solved_as_found(under("T = \"600 N*m\"", half + lines)), "key", "hub");
    };
    CHECK(keyed("") == "not-judged");
    CHECK(keyed("i = 2\n") == "pass");  // the number of keys explains the half
    CHECK(shaft("K_A = 1.5", "tau_adm = \"40 MPa\"\nK_A = \"=values.K_A/1.5\"\n") == "not-judged");
    CHECK(shaft("K_A = 1.5", "tau_adm = \"40 MPa\"\nK_A = \"=values.K_A\"\n") == "pass");
    CHECK(shaft("K_A = 1.5", "tau_adm = \"40 MPa\"\nK_A = \"=1.1*values.K_A\"\n") == "pass");
    CHECK(shaft("R_e = \"250 MPa\"", "S = 2\nR_e = \"=1.4*values.R_e\"\n") == "not-judged");
    CHECK(shaft("R_e = \"250 MPa\"", "S = 2\nR_e = \"=0.9*values.R_e\"\n") == "pass");
  }

  TEST_CASE("a power next to a torque: at the speed of [values], and without a speed") {
    const std::string shaft =
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"300 N*m\"\nd = \"60 mm\"\nmaterial = \"C45E\"\nS = 2\n";
    CHECK(is_held("P = \"100 kW\"\nn = \"1450 rpm\"", shaft, "shaft", "yield"));       // 659 N m
    CHECK_FALSE(is_held("P = \"40 kW\"\nn = \"1450 rpm\"", shaft, "shaft", "yield"));  // 263 N m
    CHECK(is_held("P = \"100 kW\"", shaft, "shaft", "yield"));
    CHECK_FALSE(is_held("P_idle = \"1 kW\"", shaft, "shaft", "yield"));
    const std::string taken = under("P = \"100 kW\"\nn = \"4000 rpm\"", shaft);
    CHECK(mode_of(solved_as_found(taken), "shaft", "yield") == "pass");  // 239 N m
  }

  TEST_CASE("a component of the load that no step takes") {
    CHECK(is_held("F_a = \"8 kN\"", bearing, "b", "fatigue"));
    CHECK_FALSE(is_held("F_a = \"0 N\"", bearing, "b", "fatigue"));
    std::string second = bearing;
    second.replace(1, 1, "c");
    const std::string pair = under("F_a = \"1 kN\"", bearing + "\n" + second + "F_a = \"1 kN\"\n");
    CHECK(mode_of(solved_as_found(pair), "b", "fatigue") == "pass");  // the other one locates the shaft
    const std::string shaft =
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"300 N*m\"\nd = \"60 mm\"\nmaterial = \"C45E\"\nS = 2\n";
    CHECK(is_held("M_b = \"800 N*m\"", shaft, "shaft", "yield"));
  }

  TEST_CASE("gears without a load next to a stated load") {
    const std::string worm =
        "[w]\ncalculator = \"gear.worm\"\nz_1 = 2\nz_2 = 40\nm_x = \"4 mm\"\nd_1 = \"40 mm\"\nb_2 = \"30 mm\"\nmu = "
        "0.05\n";
    const std::string bevel =
        "[w]\ncalculator = \"gear.bevel\"\nz_1 = 20\nz_2 = 40\nm_et = \"4 mm\"\nb = \"28 mm\"\nx_1 = 0.3\nh_fP = "
        "1.188\n";
    const auto load = [](const std::string& values, const std::string& gears, const std::string& more = "") {
      return mode_of(solved_as_found(under(values, gears + more)), "w", "load");
    };
    for (const char* const values : {"P = \"5 kW\"", "T_2 = \"200 N*m\"", "P_max = \"9 kW\""}) {
      CHECK(load(values, worm) == "not-judged");
      CHECK(load(values, bevel) == "not-judged");
    }
    CHECK(load("P_idle = \"0.1 kW\"", worm) == "none");
    CHECK(load("P = \"5 kW\"", worm, "because.m_x = \"rated by its manufacturer, sheet 3\"\n") == "none");
  }

  TEST_CASE("a strength below that of the material") {
    const std::string shaft =
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"300 N*m\"\nd = \"60 mm\"\nmaterial = \"C45E\"\nS = 2\n";
    CHECK(is_held("R_e = \"200 MPa\"", shaft, "shaft", "yield"));
    CHECK_FALSE(is_held("R_e = \"900 MPa\"", shaft, "shaft", "yield"));
  }

  TEST_CASE("a gauge pressure below zero is a vacuum, and a density with a level is a liquid") {
    CHECK(is_held("p_min = \"-0.08 MPa\"", shell, "shell", "strength"));
    CHECK(!is_held("p_min = \"0.2 MPa\"", shell, "shell", "strength"));
    CHECK(is_held("rho = \"1000 kg/m^3\"\nH = \"12 m\"", shell, "shell", "strength"));
    CHECK(!is_held("H = \"12 m\"", shell, "shell", "strength"));
  }

  TEST_CASE("loads of a column under other names: eccentricity, moment, stroke, partial factor") {
    const std::string post =
        "[post]\ncalculator = \"column.buckling\"\nP = \"60 kN\"\nl = \"2 m\"\nends = \"pinned_pinned\"\nsection = "
        "\"HEA 140\"\nmaterial = \"S235\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1.35\n";
    for (const char* const values :
         {"e = \"40 mm\"", "M = \"5 kN*m\"", "stroke = \"2.5 m\"", "gamma_p = 1.5", "gamma_Q = 1.5"})
      CHECK_MESSAGE(is_held(values, post, "post", "buckling"), values);
    for (const char* const values :
         {"e_bolts = \"40 mm\"", "M_frame = \"5 kN*m\"", "stroke = \"0.5 m\"", "gamma_G = 1.35", "gamma_M2 = 1.5"})
      CHECK_MESSAGE(!is_held(values, post, "post", "buckling"), values);
  }
}
