// Each condition of the rules for loads, strengths and factors that are a part of a value of [values].
#include "lib/project/references/drives/own_names.hpp"

#include "lib/project/references/agreement/drive_lines.hpp"
#include "lib/project/references/drives/stages.hpp"
#include "lib/project/references/machine/other_steps.hpp"
#include "lib/project/references/machine/repetitions.hpp"
#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string found(const std::string& text, const std::string& step = "") {
  return inputs_found(&project::values_in_part, text, step);
}

std::string shaft(const std::string& T, const std::string& more = "") {
  return "[s]\ncalculator = \"shaft.torsion\"\nd = \"60 mm\"\nmaterial = \"C45E\"\nS = 2\nT = \"" + T + "\"\n" + more;
}

std::string lug(const std::string& F, const std::string& more = "") {
  return "[e]\n" +
         with_lines(
             "calculator = \"pin.lug\"\nF = \"" + F +
                 "\"\nd = \"40 mm\"\nb = \"110 mm\"\na = \"38 mm\"\nt = \"25 mm\"\np_adm = \"90 MPa\"\nmaterial = "
                 "\"S355\"\nS = 2\n",
             more);
}

const std::string torque = "[values]\nT = \"300 N*m\"\nshare = 0.5\n\n";
const std::string force = "[values]\nF = \"40 kN\"\nn = 4\nphi = \"30 deg\"\n\n";
const std::string power = "[values]\nP = \"20 kW\"\nn = \"1000 rpm\"\nl = \"2 m\"\nF = \"2 kN\"\n\n";

}  // namespace

TEST_SUITE("project: values in part") {
  TEST_CASE("a torque by a bare number") {
    for (const std::string T : {"=0.5*values.T", "=values.T/2", "=values.T/4", "=0.84*values.T"})
      CHECK_MESSAGE(found(torque + shaft(T)) == "T", T);
    for (const std::string T : {"=values.T", "=0.85*values.T", "=values.share*values.T", "=2*values.T", "=0*values.T",
                                "=values.T*cos(60 deg)", "=values.T*sin(30 deg)", "=values.T*tan(20 deg)"})
      CHECK_MESSAGE(found(torque + shaft(T)).empty(), T);
    const std::string rest = shaft("=values.T/2").replace(1, 1, "r");
    CHECK(found(torque + shaft("=values.T/2") + "\n" + rest).empty());  // two halves
    CHECK(found(torque + shaft("=values.T/4") + "\n" + rest) == "T");
    CHECK(found(torque + shaft("=values.T/4") + "\n" + shaft("=values.T").replace(1, 1, "r")) == "T");
  }

  TEST_CASE("a force that two equal parts share") {
    for (const std::string F : {"=values.F/2", "=0.5*values.F", "=values.F*0.5", "=values.F / 2"})
      CHECK_MESSAGE(found(force + lug(F)).empty(), F);
    for (const std::string F :
         {"=values.F/4", "=0.3*values.F", "=values.F/2.5", "=values.F/20", "=0.25*values.F", "=values.F/2/2"})
      CHECK_MESSAGE(found(force + lug(F)) == "F", F);
    for (const std::string F : {"=values.F/values.n", "=values.F*sin(values.phi)/2*0 + values.F"})
      CHECK_MESSAGE(found(force + lug(F)).empty(), F);
  }

  TEST_CASE("a part by a number that looks like a half, or of another quantity") {
    CHECK(found(force + lug("=values.F*1.2/2")).empty());  // half of the force, with a factor
    CHECK(found(force + lug("=values.F*1.5/2.5")) == "F");
    CHECK(found(force + lug("=values.F*12/20")) == "F");
    const std::string weight = "[values]\nm = \"1000 kg\"\n\n";
    CHECK(found(weight + lug("=0.05*values.m*(9.81 m/s^2)")).empty());  // see formulas.cpp
    const std::string moved = "[values]\nT = \"=press.drive.M\"\n\n";
    CHECK(found(moved + shaft("=0.5*values.T") + press_of_heavy_rod).empty());  // see reductions.cpp
  }

  TEST_CASE("a count of the step explains its share of a load, apart from teeth") {
    const std::string stated = "[values]\nP = \"6 kW\"\n\n";
    const auto chain = [](const std::string& P, const std::string& strands) {
      return example_of("chain.roller", "P = \"" + P + "\"\nstrands = " + strands);
    };
    CHECK(found(stated + chain("=values.P/3", "3")).empty());
    CHECK(found(stated + chain("=values.P/3", "2")) == "P");
    CHECK(found(stated + chain("=values.P/19", "1")) == "P");  // z_1 = 19
  }

  TEST_CASE("the mean power of a drive is its load") {
    const std::string power = "[values]\nP = \"20 kW\"\n\n";
    for (const char* const drive : {"belt.v", "chain.roller"}) {
      CHECK(found(power + example_of(drive, "P = \"=0.5*values.P\"")) == "P");
      CHECK(found(power + example_of(drive, "P = \"=0.9*values.P\"")).empty());
    }
  }

  TEST_CASE("amplitude and mean of one value make it up") {
    const std::string stated = "[values]\nT = \"260 N*m\"\nT_a = \"40 N*m\"\n\n";
    const auto shoulder = [&](const std::string& mean, const std::string& amplitude) {
      return found(stated + example_of("fatigue.din743", "M_tm = \"" + mean + "\"\nM_ta = \"" + amplitude + "\""));
    };
    CHECK(shoulder("=values.T/4", "=values.T/4") == "M_tm");
    CHECK(shoulder("=values.T/2", "=values.T/4") == "M_tm");
    CHECK(shoulder("=values.T/2", "=values.T/2").empty());
    CHECK(shoulder("=values.T/4", "=values.T_a").empty());  // of two values
    CHECK(shoulder("=values.T", "=0.1*values.T").empty());
  }

  TEST_CASE("strengths, factors and pressures under their own names") {
    const std::string strengths = "[values]\nR_e = \"300 MPa\"\nK_A = 1.5\nS = 2\n\n";
    const auto with_strength = [&](const std::string& lines) {
      return found(
          strengths + "[s]\n" +
          with_lines("calculator = \"shaft.torsion\"\nd = \"60 mm\"\nR_e = \"300 MPa\"\nS = 2\nT = \"300 N*m\"\n",
                     lines));
    };
    CHECK(with_strength("R_e = \"=1.2*values.R_e\"") == "R_e");
    CHECK(with_strength("R_e = \"=values.R_e\"").empty());
    CHECK(with_strength("R_e = \"=0.8*values.R_e\"").empty());
    CHECK(with_strength("R_e = \"=1.01*values.R_e\"").empty());  // digits
    CHECK(with_strength("S = \"=0.99*values.S\"").empty());
    CHECK(with_strength("R_e = \"=0.99*values.R_e\"").empty());
    CHECK(with_strength("S = \"=1.01*values.S\"").empty());
    CHECK(with_strength("S = \"=0.8*values.S\"") == "S");
    CHECK(with_strength("S = \"=1.2*values.S\"").empty());
    const std::string pressures = "[values]\np = \"1 MPa\"\n\n";
    const auto wall = [&](const std::string& p) {
      return found(pressures + "[v]\ncalculator = \"vessel.cylinder\"\np = \"" + p +
                   "\"\nR = \"600 mm\"\nsigma_adm = \"140 MPa\"\n");
    };
    CHECK(wall("=0.8*values.p") == "p");
    CHECK(wall("=1.2*values.p").empty());
    CHECK(wall("=values.p").empty());
  }

  TEST_CASE("teeth explain no share of a power") {
    const std::string worm = example_of("gear.worm", "P = \"=0.5*values.P\"");  // of two threads
    CHECK(found("[values]\nP = \"0.6 kW\"\n\n" + worm) == "P");
    const std::string losses = example_of("gear.worm", "P = \"=0.95*values.P\"");
    CHECK(found("[values]\nP = \"0.6 kW\"\n\n" + losses).empty());
  }

  TEST_CASE("a required life as a part of a life by its name") {
    const auto bearing = [](const std::string& value, const std::string& L_h) {
      return found("[values]\n" + value +
                   "\n\n[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6309\"\nF_r = \"6 kN\"\n" +
                   "n = \"1200 rpm\"\nL_h = \"" + L_h + "\"\n");
    };
    CHECK(bearing("life = \"20000 h\"", "=values.life/10") == "L_h");
    CHECK(bearing("life = \"20000 h\"", "=values.life").empty());
    CHECK(bearing("L_h = \"20000 h\"", "=values.L_h/10") == "L_h");
    CHECK(bearing("pause = \"20000 h\"", "=values.pause/10").empty());
    const auto part = [](const std::string& value, const std::string& N) {
      return found("[values]\n" + value + "\n\n" + example_of("fatigue.life", "N = \"" + N + "\""));
    };
    CHECK(part("cycles = 2e6", "=values.cycles/10") == "N");
    CHECK(part("strokes_a_piece = 2e6", "=values.strokes_a_piece/10").empty());
  }

  TEST_CASE("a diameter or a radius as a part of a value of its own name") {
    const auto wall = [](const std::string& name, const std::string& lines) {
      return found("[values]\n" + name + " = \"1200 mm\"\n\n" + example_of("vessel.cylinder", lines));
    };
    CHECK(wall("R", "R = \"=values.R/2\"") == "R");
    CHECK(wall("R", "R = \"=values.R*0.96\"").empty());
    CHECK(wall("R", "R = \"=values.R*1.04\"").empty());
    CHECK(wall("R", "R = \"=values.R*1.06\"") == "R");
    CHECK(wall("D", "R = \"=values.D/2\"").empty());
    CHECK(wall("D_i", "R = \"=values.D_i/4\"") == "R");
    CHECK(wall("Dm", "R = \"=values.Dm/4\"").empty());  // of no diameter
    CHECK(wall("L", "R = \"=values.L/4\"").empty());
  }

  TEST_CASE("the length of a column by a bare number") {
    const std::string height = "[values]\nh = \"4 m\"\nn = 2\nlower = \"2 m\"\n\n";
    const auto column = [](const std::string& l) { return example_of("column.buckling", "l = \"" + l + "\""); };
    CHECK(found(height + column("=values.h/2")) == "l");
    CHECK(found(height + column("=0.25*values.h")) == "l");
    CHECK(found(height + column("=0.9*values.h")).empty());
    CHECK(found(height + column("=values.h/values.n")).empty());
    CHECK(found(height + column("=values.lower")).empty());
    std::string upper = column("=values.h/2");
    upper.replace(0, upper.find(']'), "[upper");
    CHECK(found(height + column("=values.h/2") + upper).empty());
  }

  TEST_CASE("a computed speed under the name of another one") {
    const std::string speeds = "[values]\nn_1 = \"1000 rpm\"\ni = 3\nslip = 0.98\n\n";
    const auto drive = [](const std::string& n) { return example_of("chain.roller", "n_1 = \"" + n + "\""); };
    CHECK(found(speeds + drive("=values.n_1*values.i")) == "n_1");
    CHECK(found(speeds + drive("=values.n_1/values.i")).empty());  // of a later stage
    CHECK(found(speeds + drive("=values.n_1*values.slip")).empty());
    CHECK(found(speeds + drive("=values.n_1")).empty());
    std::string first = example_of("gear.worm", "n_1 = \"=values.n_1\"");
    first.replace(0, first.find(']'), "[first");
    CHECK(found(speeds + drive("=values.n_1*values.i") + first).empty());
  }

  TEST_CASE("a speed that is a part of another one by a bare number") {
    const std::string speed = "[values]\nn = \"1000 rpm\"\ni = 4\n\n";
    const auto bearing = [&](const std::string& n) {
      return found(speed + "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6309\"\nF_r = \"6 kN\"\nn = \"" + n +
                   "\"\nL_h = \"3000 h\"\n");
    };
    CHECK(bearing("=values.n/60") == "n");
    CHECK(bearing("=0.5*values.n") == "n");
    CHECK(bearing("=values.n").empty());
    CHECK(bearing("=0.9*values.n").empty());
    CHECK(bearing("=values.n/values.i").empty());
    CHECK(bearing("=2*values.n").empty());
    CHECK(
        found("[values]\nn = \"1000 rpm\"\nslow = \"=values.n/60\"\n\n[b]\ncalculator = \"bearing.rolling\"\nbearing = "
              "\"6309\"\nF_r = \"6 kN\"\nn = \"=values.slow\"\nL_h = \"3000 h\"\n")
            .empty());
  }

  TEST_CASE("half of a size with more words in its name, of an overhang, of a length between rings") {
    const std::string sizes =
        "[values]\nD_rotor = \"600 mm\"\nL_rings = \"2400 mm\"\na_over = \"50 mm\"\nd_2 = \"400 mm\"\n\n";
    CHECK(found(sizes + example_of("machine.disc", "D = \"=values.D_rotor/2\"")) == "D");
    CHECK(found(sizes + example_of("machine.disc", "D = \"=values.D_rotor\"")).empty());
    CHECK(found(sizes + example_of("machine.disc", "D = \"=0.8*values.D_rotor\"")).empty());
    CHECK(found(sizes + example_of("vessel.external", "L = \"=values.L_rings/2\"")) == "L");
    CHECK(found(sizes + example_of("vessel.external", "D_a = \"=values.D_rotor/2\"")) == "D_a");
    CHECK(found(sizes + example_of("shaft.overhung", "a = \"=values.a_over/2\"")).find("a") == 0);
    CHECK(found(sizes + example_of("belt.flat", "d_1 = \"=values.d_2/2\"")).empty());  // a ratio
    const std::string wall = "[values]\nc_corr = \"2 mm\"\n\n";
    CHECK(found(wall + example_of("vessel.cylinder", "c = \"=values.c_corr/2\"")) == "c");
  }
}

TEST_SUITE("project: ratios of stages") {
  TEST_CASE("a drive has the ratio of the stage whose load it takes") {
    const auto asked = [](const std::string& stage, const std::string& lines, const std::string& shaft = "1") {
      const std::string at = "\"=x.shafts[" + shaft + "].";
      const std::string step = with_lines(
          "calculator = \"belt.synchronous\"\nsynchronous_belt = \"H\"\nK_A = 1.5\nz_1 = "
          "20\nz_2 = 40\na = \"500 mm\"\nb = \"50.8 mm\"\nP = " +
              at + "P\"\nn_1 = " + at + "n\"\n",
          lines);
      return inputs_found(&project::ratios_of_stages,
                          "[x]\ncalculator = \"drive.train\"\nP = \"0.6 kW\"\nn_1 = \"1400 rpm\"\nstages = [{ " +
                              stage + ", eta = 0.98 }]\n\n[s]\n" + step,
                          "s");
    };
    CHECK(asked("kind = \"belt\", i = 2", "").empty());
    CHECK(asked("kind = \"belt\", i = 2.03", "").empty());
    CHECK(asked("kind = \"belt\", i = 2.1", "") == "z_2");
    CHECK(asked("kind = \"belt\", i = 1.9", "") == "z_2");
    CHECK(asked("kind = \"other\", i = 3", "").empty());
    CHECK(asked("kind = \"belt\", i = 3", "n_1 = \"1395 rpm\"") == "z_2");
    CHECK(asked("kind = \"belt\", i = 3", "n_1 = \"1000 rpm\"").empty());
    CHECK(asked("kind = \"belt\", i = 3", "P = \"0.6 kW\"").empty());
    CHECK(asked("kind = \"belt\", i = 3", "", "2").empty());  // behind the last stage
  }

  TEST_CASE("pulleys have the ratio of the stage but for slip") {
    const auto asked = [](const std::string& i, const std::string& lines = "") {
      const std::string belt =
          example_of("belt.flat",
                     "P = \"=x.shafts[1].P\"\nn_1 = \"=x.shafts[1].n\"\nd_1 = \"200 mm\"\nd_2 = \"500 mm\"\n" + lines);
      return inputs_found(&project::ratios_of_stages, belt +
                                                          "\n[x]\ncalculator = \"drive.train\"\nP = \"15 kW\"\nn_1 = "
                                                          "\"1450 rpm\"\nstages = [{ kind = \"belt\", i = " +
                                                          i + ", eta = 0.98 }]\n");
    };
    CHECK(asked("2.5").empty());
    CHECK(asked("2.4").empty());
    CHECK(asked("2.6").empty());
    CHECK(asked("2.2") == "d_2");
    CHECK(asked("2.8") == "d_2");
    CHECK(asked("2.8", "d_2 =\nn_2 = \"580 rpm\"").empty());
  }
}

TEST_SUITE("project: runs of a drive") {
  // 5.5 kW at 1450 rpm: 36.2 N*m; 140.5 N*m at 362.5 rpm behind the gears.
  const std::string conveyor =
      "[conveyor]\ncalculator = \"drive.train\"\nP = \"5.5 kW\"\nn_1 = \"1450 rpm\"\nstages = [{ name = \"gears\", "
      "kind = \"gear\", z_1 = 20, z_2 = 80, eta = 0.97 }]\n\n";

  std::string run_up(const std::string& M, const std::string& n_2, const std::string& lines = "") {
    return "[up]\n" +
           with_lines(
               "calculator = \"machine.run_up\"\nparts = [{ name = \"rotor\", J = \"0.02 kg*m^2\" }]\nmotor = [[\"0 "
               "rpm\", \"" +
                   M + "\"], [\"2000 rpm\", \"" + M + "\"]]\nn_2 = \"" + n_2 + "\"\n",
               lines) +
           "\n";
  }

  std::string asked_of_run(const std::string& text) { return inputs_found(&project::torques_of_line, text, "up"); }

  TEST_CASE("a motor reaches the torque of the shaft with the speed of the run") {
    const auto asked = [](const std::string& M, const std::string& n_2, const std::string& more = "") {
      return asked_of_run(conveyor + run_up(M, n_2) + more);
    };
    CHECK(asked("25 N*m", "1450 rpm") == "motor");
    CHECK(asked("32 N*m", "1450 rpm").empty());
    CHECK(asked("25 N*m", "1440 rpm") == "motor");
    CHECK(asked("25 N*m", "1380 rpm").empty());  // of another shaft, unless the run refers to the train
    CHECK(asked("100 N*m", "362.5 rpm").empty());
    CHECK(asked("100 N*m", "=abs(conveyor.shafts[2].n)") == "motor");
    CHECK(asked("125 N*m", "=abs(conveyor.shafts[2].n)").empty());
    CHECK(asked("25 N*m", "=0.95*conveyor.shafts[1].n") == "motor");
    CHECK(asked("25 N*m", "=0.8*conveyor.shafts[1].n").empty());
    const std::string second = "[other" + conveyor.substr(9);
    CHECK(asked("25 N*m", "1450 rpm", second).empty());                                        // either of them
    CHECK(asked_of_run(conveyor + run_up("-25 N*m", "0 rpm", "n_1 = \"1450 rpm\"")).empty());  // a stop
    CHECK(asked_of_run(run_up("25 N*m", "1450 rpm")).empty());
  }

  TEST_CASE("a start goes through the parts with the torque of the shaft") {
    const std::string shaft =
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"=conveyor.T_1\"\nd = \"30 mm\"\ntau_adm = \"40 MPa\"\n\n";
    const auto key = [](const std::string& T, const std::string& lines) {
      return with_lines(example_of("shaft.key"), "T = \"" + T + "\"\n" + lines) + "\n";
    };
    const auto asked = [&](const std::string& M, const std::string& parts) {
      return asked_of_run(conveyor + parts + run_up(M, "1450 rpm"));
    };
    CHECK(asked("50 N*m", key("=conveyor.T_1", "K_A = 1.25")) == "motor");
    CHECK(asked("50 N*m", key("=conveyor.shafts[1].T", "K_A = 1.25")) == "motor");
    CHECK(asked("44 N*m", key("=conveyor.T_1", "K_A = 1.25")).empty());
    CHECK(asked("50 N*m", key("=conveyor.T_1", "K_A = 1.25\nT_max = \"60 N*m\"")).empty());
    CHECK(asked("50 N*m", key("=conveyor.shafts[2].T", "K_A = 1.25")).empty());
    CHECK(asked("50 N*m", shaft) == "motor");
    CHECK(asked("35 N*m", shaft).empty());
    const std::string next =
        "[next]\ncalculator = \"drive.train\"\nT_1 = \"=conveyor.T_1\"\nn_1 = \"100 rpm\"\nstages = [{ kind = "
        "\"gear\", z_1 = 20, z_2 = 80, eta = 0.97 }]\n\n";
    CHECK(asked_of_run(conveyor + next + run_up("50 N*m", "=conveyor.n_1")).empty());  // no application factor
    CHECK(asked("35 N*m", key("=conveyor.T_1", "K_A = 1")).empty());
  }

  TEST_CASE("a motor reaches the mean moment of a flywheel that it drives") {
    const auto wheel = [](const std::string& name, const std::string& omega, const std::string& role = "load") {
      return "[" + name +
             "]\ncalculator = \"machine.flywheel\"\nM_of_phi = \"200 N*m + 350 N*m*sin(2*phi)\"\nrole = \"" + role +
             "\"\nomega = \"" + omega + "\"\ndelta = 0.05\n\n";
    };
    const auto part = [](const std::string& J, const std::string& u) {
      return "parts = [{ name = \"w\", J = \"" + J + "\", u = " + u + " }]";
    };
    const auto asked = [&](const std::string& wheels, const std::string& M, const std::string& J,
                           const std::string& u = "1") {
      return asked_of_run(wheels + run_up(M, "300 rpm", part(J, u)));
    };
    const std::string same = wheel("fly", "300 rpm"), slow = wheel("fly", "60 rpm");
    CHECK(asked(same, "150 N*m", "=fly.J_F") == "motor");
    CHECK(asked(same, "175 N*m", "=fly.J_F").empty());
    CHECK(asked(same, "150 N*m", "1 kg*m^2") == "motor");
    CHECK(asked(wheel("fly", "320 rpm"), "150 N*m", "1 kg*m^2") == "motor");
    CHECK(asked(wheel("fly", "300 rpm", "drive"), "150 N*m", "=fly.J_F").empty());
    CHECK(asked(slow, "30 N*m", "=fly.J_F", "0.2") == "motor");  // 40 N*m at the motor
    CHECK(asked(slow, "36 N*m", "=fly.J_F", "0.2").empty());
    CHECK(asked(slow, "30 N*m", "1 kg*m^2", "0.2").empty());
    CHECK(asked(slow, "30 N*m", "=1*fly.J_F", "0.2").empty());
    CHECK(asked(slow + wheel("other", "60 rpm"), "30 N*m", "=other.J_F", "0.2") == "motor");
  }

  TEST_CASE("a flywheel next to the speed of its motor without load") {  // 125 rpm
    const auto wheel = [](const std::string& name, const std::string& omega) {
      return "[" + name +
             "]\ncalculator = \"machine.flywheel\"\nM_of_phi = \"200 N*m + 350 N*m*sin(2*phi)\"\nrole = "
             "\"load\"\nomega = \"" +
             omega + "\"\ndelta = 0.05\n\n";
    };
    const auto asked = [](const std::string& wheels, const std::string& lines) {
      return inputs_found(&project::values_of_runs, example_of("machine.motion", lines) + "\n" + wheels);
    };
    CHECK(asked(wheel("fly", "100 rpm"), "J_F = \"=fly.J_F\"") == "J_F");
    CHECK(asked(wheel("fly", "110 rpm"), "J_F = \"=fly.J_F\"").empty());
    CHECK(asked(wheel("fly", "150 rpm"), "J_F = \"=fly.J_F\"").empty());
    CHECK(asked(wheel("fly", "100 rpm"), "J_F = \"20 kg*m^2\"").empty());
    CHECK(asked(wheel("fly", "120 rpm") + wheel("slow", "60 rpm"), "J_F = \"=fly.J_F\"\nJ_M = \"=slow.J_F\"").empty());
    CHECK(asked(wheel("fly", "100 rpm") + "[values]\nJ = \"20 kg*m^2\"\n", "J_F = \"=values.J\"").empty());
  }
}

TEST_SUITE("project: repetitions") {
  TEST_CASE("blocks that are slower than the shaft of a bearing") {  // 1450 rpm
    const auto asked = [](const std::string& lines) {
      return inputs_found(
          &project::repetitions_of_others,
          example_of("shaft.design") + "\n[b]\n" +
              with_lines("calculator = \"bearing.rolling\"\nbearing = \"6306\"\nload = \"=shaft.bearings.left\"\n",
                         lines),
          "b");
    };
    CHECK(asked("blocks = [{ q = 0.2, k = 1, n = \"1000 rpm\" }, { q = 0.8, k = 0.5, n = \"600 rpm\" }]") == "blocks");
    CHECK(asked("blocks = [{ q = 0.2, k = 1, n = \"1450 rpm\" }, { q = 0.8, k = 0.5, n = \"600 rpm\" }]").empty());
    CHECK(asked("blocks = [{ q = 0.2, k = 1, n = \"600 rpm\" }, { q = 0.8, k = 0.5, n = \"1450 rpm\" }]").empty());
    CHECK(asked("blocks = [{ q = 0.2, k = 1 }, { q = 0.8, k = 0.5, n = \"600 rpm\" }]").empty());
    CHECK(asked("blocks = [{ q = 0.2, k = 1, n = \"2000 rpm\" }, { q = 0.8, k = 0.5, n = \"600 rpm\" }]").empty());
    CHECK(asked("").empty());
  }
}
