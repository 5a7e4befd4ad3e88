// Regression tests of values of a machine that do not suit each other: directions of loads, strokes, speeds that are
// asked for, sizes of bars behind a cycle, rims, gravity, lives and temperatures of gears.
#include "tests/found/modes.hpp"

#include <algorithm>
#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// Whether a mode of the step waits for a reason with these words.
bool is_held(const std::string& text, std::string_view step, const std::string& words) {
  const auto modes = project::modes(solved_as_found(text));
  return std::ranges::any_of(modes, [&](const account::Mode& mode) {
    return mode.step == step && mode.state == account::State::not_judged &&
           mode.note.text().find(words) != std::string::npos;
  });
}

std::string press(const std::string& load, const std::string& more = "") {
  return "[mech]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"60 mm\"\nl = \"300 mm\"\n"
         "crank = { speed = \"20 rpm\", positions = 60 }\nlinks.slider.mass = \"40 kg\"\n" +
         more + "loads = [{ link = \"slider\", at = \"B\", " + load + " }]\n";
}

const std::string along = "F_x = \"-8 kN\", F_y = \"0 N\"";

std::string bar_and_life(const std::string& d, const std::string& d_h) {
  return "[bar]\ncalculator = \"shaft.torsion\"\nT = \"400 N*m\"\ntau_adm = \"120 MPa\"\nl = \"900 mm\"\nmaterial = "
         "\"42CrMo4\"\nd = \"" +
         d +
         "\"\n[limit]\ncalculator = \"fatigue.endurance\"\nmaterial = \"42CrMo4\"\ngroup = \"alloy-steel\"\nloading = "
         "\"torsion\"\nrule = \"din743\"\nd = \"30 mm\"\nR_z = \"6.3 um\"\n[life]\ncalculator = \"fatigue.life\"\n"
         "cycle = \"=bar_cycle.cycle\"\nsigma_D = \"=limit.sigma_D\"\nmaterial = \"42CrMo4\"\ngroup = "
         "\"alloy-steel\"\nS_D = 1.5\nS_F = 1.5\n" +
         d_h +
         "[bar_cycle]\ncalculator = \"fatigue.cycle\"\nstress = \"shear\"\nsigma_max = \"=bar.tau_max\"\nsigma_min = "
         "\"0 MPa\"\n";
}

std::string flywheel(const std::string& D) {
  return "[fly]\ncalculator = \"machine.flywheel\"\npoints = [[\"0 deg\", \"200 N*m\"], [\"150 deg\", \"200 N*m\"], "
         "[\"160 deg\", \"6000 N*m\"], [\"200 deg\", \"6000 N*m\"], [\"210 deg\", \"200 N*m\"], [\"360 deg\", \"200 "
         "N*m\"]]\nomega = \"150 rpm\"\ndelta = 0.1\nv_adm = \"30 m/s\"\neta = 0.9\nP_n = \"22 kW\"\nD = \"" +
         D + "\"\n";
}

std::string bevel_and_bearing(const std::string& L_h, const std::string& n) {
  return "[bevel]\ncalculator = \"gear.bevel\"\nz_1 = 20\nz_2 = 40\nm_et = \"4 mm\"\nb = \"28 mm\"\nx_1 = 0.3\nh_fP = "
         "1.188\nP = \"3 kW\"\nn_1 = \"900 rpm\"\nK_A = 1.25\nQ_v = 8\nmounting = \"one_straddled\"\ncrowning = "
         "\"crowned\"\nI = 0.083\nJ_1 = 0.244\nJ_2 = 0.2\nH_B1 = 300\nH_B2 = 280\nS_Hmin = 1.1\nS_Fmin = 1.5\nL_h = "
         "\"" +
         L_h +
         "\"\n[bear]\ncalculator = \"bearing.rolling\"\nbearing = \"6210\"\nF_r = \"2 kN\"\nF_a = \"0.4 kN\"\nL_h = "
         "\"10000 h\"\ns_0 = 1.5\nn = \"" +
         n + "\"\n";
}

std::string worm_in(const std::string& T_ambient) {
  return "[values]\nT_ambient = \"" + T_ambient +
         "\"\n[worm]\ncalculator = \"gear.worm\"\nz_1 = 2\nz_2 = 40\nm_x = \"4 mm\"\nd_1 = \"40 mm\"\nb_2 = \"30 "
         "mm\"\nP = \"0.6 kW\"\nn_1 = \"1400 rpm\"\nK_A = 1.25\ncasting = \"chill\"\nS_Wmin = 1\nsigma_adm = \"60 "
         "MPa\"\nA_h = \"0.25 m^2\"\ndT_adm = \"60 K\"\n";
}

std::string train(const std::string& values) {
  return "[values]\n" + values +
         "\n[train]\ncalculator = \"drive.train\"\nP = \"4 kW\"\nn_1 = \"1440 rpm\"\nstages = [{ name = \"g1\", kind = "
         "\"gear\", z_1 = 20, z_2 = 98, eta = 0.98 }, { name = \"g2\", kind = \"gear\", z_1 = 19, z_2 = 92, eta = 0.98 "
         "}]\n";
}

}  // namespace

TEST_SUITE("found unsuited values") {
  TEST_CASE("the loads of a mechanism do work") {
    const char* const words = "no load does work";
    for (const char* const load : {"F_x = \"0 N\", F_y = \"-8 kN\"", "F = \"8 kN\", direction = \"90 deg\""})
      CHECK_MESSAGE(is_held(press(load), "mech", words), load);
    for (const char* const load : {"F_x = \"-8 kN\", F_y = \"0 N\"", "F_x = \"-1 kN\", F_y = \"-8 kN\"",
                                   "F = \"8 kN\", direction = \"180 deg\""})
      CHECK_MESSAGE(!is_held(press(load), "mech", words), load);
    const std::string across = press("F_x = \"0 N\", F_y = \"-8 kN\"");
    CHECK_FALSE(is_held(across + "because.loads = \"a guide is tried\"\n", "mech", words));
  }

  TEST_CASE("a stroke of [values] is that of the mechanism") {
    const auto state = [](const std::string& values) {
      return is_held("[values]\n" + values + "\n\n" + press(along), "mech", "has a stroke of 120 mm");
    };
    CHECK(state("stroke = \"150 mm\""));
    CHECK(state("stroke_slider = \"60 mm\""));
    CHECK_FALSE(state("stroke = \"120 mm\""));
    CHECK_FALSE(state("stroke_of_mate = \"150 mm\""));
  }

  TEST_CASE("a machine has the gravity of the Earth") {
    CHECK(is_held(press(along, "gravity = \"9.81 mm/s^2\"\n"), "mech", "is not that of the Earth"));
    CHECK_FALSE(is_held(press(along, "gravity = \"9.81 m/s^2\"\n"), "mech", "is not that of the Earth"));
  }

  TEST_CASE("a speed that is asked for is that of a shaft") {
    const char* const words = "no shaft has this speed";
    CHECK(is_held(train("n_target = \"600 rpm\""), "train", words));
    CHECK(is_held(train("omega_soll = \"20 rad/s\""), "train", words));
    CHECK_FALSE(is_held(train("n_target = \"60 rpm\""), "train", words));
    CHECK_FALSE(is_held(train("n_required = \"290 rpm\""), "train", words));
    CHECK_FALSE(is_held(train("n_of_fan = \"600 rpm\""), "train", words));
  }

  TEST_CASE("a fatigue strength is for the size of the bar, also behind a cycle") {
    const char* const words = "the stress is that of 'bar', d = 45 mm";
    CHECK(is_held(bar_and_life("45 mm", "d_h = \"30 mm\"\n"), "life", words));
    CHECK_FALSE(is_held(bar_and_life("30 mm", "d_h = \"30 mm\"\n"), "life", "the stress is that of"));
    CHECK_FALSE(is_held(bar_and_life("25 mm", "d_h = \"30 mm\"\n"), "life", "the stress is that of"));
  }

  TEST_CASE("a rim is lighter than a cylinder of its diameter") {
    CHECK(is_held(flywheel("250 mm"), "fly", "a steel cylinder as wide as D has"));
    CHECK_FALSE(is_held(flywheel("1000 mm"), "fly", "a steel cylinder"));
  }

  TEST_CASE("gears are designed for the life of the bearings on their shaft") {
    CHECK(is_held(bevel_and_bearing("1000 h", "=bevel.n_2"), "bevel", "is shorter than that of 'bear'"));
    CHECK_FALSE(is_held(bevel_and_bearing("10000 h", "=bevel.n_2"), "bevel", "is shorter than"));
    CHECK_FALSE(is_held(bevel_and_bearing("1000 h", "450 rpm"), "bevel", "is shorter than"));
  }

  TEST_CASE("the oil of a worm gear in a warm room") {
    CHECK(is_held(worm_in("60 degC"), "worm", "the oil reaches"));
    CHECK_FALSE(is_held(worm_in("30 degC"), "worm", "the oil reaches"));
  }
}
