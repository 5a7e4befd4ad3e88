// Regression tests of steps that state one drive, one part or one surface differently, and of [values] that no step
// takes.
#include "tests/found/modes.hpp"
#include "tests/pages.hpp"

#include <algorithm>
#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string in_place_of(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string example(const std::string& name) { return text_of(LOADPATH_ROOT "/examples/" + name + "/project.toml"); }

std::string how(const std::string& text, std::string_view step, std::string_view mode) {
  return mode_of(solved_as_found(text), step, mode);
}

account::Headline headline_of(const std::string& text) {
  return account::conclude(project::modes(solved_as_found(text))).headline;
}

std::string conveyor_and(const std::string& moment, const std::string& n_2, const std::string& more = "") {
  return "[conveyor]\ncalculator = \"drive.train\"\nP = \"5.5 kW\"\nn_1 = \"1450 rpm\"\nstages = [{ name = \"gears\", "
         "kind = \"gear\", z_1 = 20, z_2 = 80, eta = 0.97 }]\n\n[up]\ncalculator = \"machine.run_up\"\n"
         "parts = [{ name = \"rotor\", J = \"0.02 kg*m^2\" }]\nmotor = [[\"0 rpm\", \"" +
         moment + "\"], [\"1450 rpm\", \"" + moment + "\"]]\nn_2 = \"" + n_2 + "\"\n" + more;
}

std::string lift_with_gears(const std::string& K_A) {
  return example("lift") +
         "\n[g]\ncalculator = \"gear.pair\"\nz_1 = \"=train.stages.first.z_1\"\nz_2 = \"=train.stages.first.z_2\"\n"
         "m_n = \"3 mm\"\nx_1 = 0.3\nb = \"30 mm\"\nT_1 = \"=train.T_1\"\nn_1 = \"=train.n_1\"\nK_A = " +
         K_A + "\ncutting = \"hobbed\"\nK_f = 1.6\nsigma_adm_1 = \"200 MPa\"\nsigma_adm_2 = \"180 MPa\"\n";
}

std::string wheel_and(const std::string& moment) {
  return "[fly]\ncalculator = \"machine.flywheel\"\nM_of_phi = \"200 N*m + 350 N*m*sin(2*phi)\"\nrole = \"load\"\n"
         "omega = \"300 rpm\"\ndelta = 0.05\n\n[up]\ncalculator = \"machine.run_up\"\nparts = [{ name = \"w\", J = "
         "\"=fly.J_F\" }]\nmotor = [[\"0 rpm\", \"" +
         moment + "\"], [\"300 rpm\", \"" + moment + "\"]]\nn_2 = \"300 rpm\"\n";
}

std::string engine_and(const std::string& P) {
  return "[flywheel]\ncalculator = \"machine.flywheel\"\nM_of_phi = \"20 kN*m + 9.5 kN*m*sin(2*phi)\"\nrole = "
         "\"drive\"\nomega = \"180 rpm\"\ndelta = 0.01\n\n[train]\ncalculator = \"drive.train\"\nP = \"" +
         P +
         "\"\nn_1 = \"=flywheel.omega\"\nstages = [{ name = \"g\", kind = \"gear\", z_1 = 19, z_2 = 19, eta = 0.98 "
         "}]\n";
}

std::string cone_on_shell(const std::string& R, const std::string& more = "") {
  return "[values]\np = \"0.4 MPa\"\n\n[shell]\ncalculator = \"vessel.cylinder\"\np = \"=values.p\"\nR = \"600 mm\"\n"
         "z_l = 0.85\nsigma_adm = \"120 MPa\"\n\n[cone]\ncalculator = \"vessel.cone\"\np = \"=values.p\"\nR = \"" +
         R + "\"\nalpha = \"30 deg\"\nsigma_adm = \"120 MPa\"\n" + more;
}

}  // namespace

TEST_SUITE("found disagreements") {
  TEST_CASE("a motor that does not reach the torque of the shaft that it runs up") {
    for (const char* const n_2 : {"=conveyor.n_1", "1450 rpm"}) {  // 36.2 N m
      CHECK(how(conveyor_and("3 N*m", n_2), "up", "stall") == "not-judged");
      CHECK(how(conveyor_and("40 N*m", n_2), "up", "stall") == "pass");
    }
    CHECK(how(conveyor_and("3 N*m", "1450 rpm", "because.motor = \"a pony motor, without the belt\"\n"), "up",
              "stall") == "pass");
    CHECK(how(conveyor_and("3 N*m", "1150 rpm", ""), "up", "stall") == "pass");  // another machine
  }

  TEST_CASE("a motor that does not reach the mean moment of its flywheel") {
    CHECK(how(wheel_and("12 N*m"), "up", "stall") == "not-judged");
    CHECK(how(wheel_and("210 N*m"), "up", "stall") == "pass");
  }

  TEST_CASE("a start that the gears of the line are not assessed for") {
    CHECK(how(example("lift"), "run_up", "stall") == "pass");
    CHECK(how(lift_with_gears("1"), "run_up", "stall") == "not-judged");  // 65 N m of 26.5 N m
    CHECK(how(lift_with_gears("2.5"), "run_up", "stall") == "pass");
  }

  TEST_CASE("only a peak factor of the same line covers its start") {
    const auto key = [](const std::string& T, const std::string& T_max) {
      return how(lift_with_gears("1") + "\n[key]\ncalculator = \"shaft.key\"\nT = \"" + T + "\"\nT_max = \"" + T_max +
                     "\"\ntorque = \"one_way\"\nd = \"25 mm\"\nkey = \"8x7\"\nl = \"40 mm\"\nl_n = \"45 mm\"\n"
                     "R_e_1 = \"370 MPa\"\nR_e_2 = \"200 MPa\"\nR_e_k = \"420 MPa\"\n",
                 "run_up", "stall");
    };
    CHECK(key("=train.T_1", "70 N*m") == "pass");
    CHECK(key("=train.T_1", "-70 N*m") == "pass");
    CHECK(key("=train.T_1", "30 N*m") == "not-judged");
    CHECK(key("10 N*m", "70 N*m") == "not-judged");  // of another machine
    CHECK(key("0 N*m", "70 N*m") == "not-judged");
    CHECK(key("=0*train.T_1", "70 N*m") == "not-judged");
  }

  TEST_CASE("a train at the speed of a flywheel transmits its mean power") {
    CHECK(how(engine_and("5 kW"), "train", "strength") == "not-judged");
    CHECK(how(engine_and("377 kW"), "train", "strength") == "open");
  }

  TEST_CASE("a cone has the radius of a shell of its pressure") {
    CHECK(how(cone_on_shell("300 mm"), "cone", "strength") == "not-judged");
    CHECK(how(cone_on_shell("600 mm"), "cone", "strength") == "pass");
    CHECK(how(cone_on_shell("300 mm", "because.R = \"on the nozzle\"\n"), "cone", "strength") == "pass");
  }

  TEST_CASE("the ends of a shell are tested under its head of water") {
    const std::string vessel = example("pressure-vessel");
    CHECK(how(vessel, "ends", "strength") == "pass");
    const std::string dry = in_place_of(vessel, "h_t = \"=shell.h_t\"", "h_t = \"0 m\"");
    CHECK(how(dry, "ends", "strength") == "not-judged");
    CHECK(how(dry + "\n[ends.because]\nh_t = \"at the top\"\n", "ends", "strength") == "pass");
  }

  TEST_CASE("a ground surface is not rough") {
    const auto shaft = [](const std::string& lines) {
      return how(in_place_of(example("gearbox-shaft"), "R_z = \"6.3 um\"", lines), "shaft", "fatigue");
    };
    CHECK(shaft("R_z = \"6.3 um\"\nfinish = \"ground\"") == "pass");
    CHECK(shaft("R_z = \"63 um\"\nfinish = \"ground\"") == "not-judged");
  }

  TEST_CASE("the order of the tooth mesh is that of a gear on the shaft") {
    const auto shaft = [](const std::string& h) {
      const std::string orders = "orders = [{ name = \"teeth\", h = " + h + " }]";
      return how(in_place_of(example("gearbox-shaft"), "orders = [{ name = \"teeth\", h = \"=gears.z_1\" }]", orders),
                 "shaft", "fatigue");
    };
    CHECK(shaft("21") == "pass");
    CHECK(shaft("\"=gears.z_1\" }, { name = \"teeth_2\", h = 42") == "pass");
    for (const char* const wrong : {"84", "1", "20"}) CHECK(shaft(wrong) == "not-judged");
  }

  TEST_CASE("the orders of a shaft with gears include their mesh") {
    const auto shaft = [](const std::string& orders) {
      return how(in_place_of(example("gearbox-shaft"), "orders = [{ name = \"teeth\", h = \"=gears.z_1\" }]", orders),
                 "shaft", "fatigue");
    };
    CHECK(shaft("orders = [{ name = \"blades\", h = 20 }]") == "not-judged");
    CHECK(shaft("orders = [{ name = \"blades\", h = 20 }, { name = \"gear\", h = 21 }]") == "pass");
  }

  TEST_CASE("the orders of a worm shaft include the mesh of its threads") {
    const auto shaft = [](const std::string& orders) {
      return how(
          "[gears]\ncalculator = \"gear.worm\"\nz_1 = 2\nz_2 = 40\nm_x = \"4 mm\"\nd_1 = \"40 mm\"\nb_2 = \"30 mm\"\n"
          "P = \"0.6 kW\"\nn_1 = \"1400 rpm\"\n[shaft]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\n"
          "group = \"carbon-steel\"\npieces = [{ name = \"all\", l = \"200 mm\", d = \"24 mm\" }]\n"
          "supports = [{ name = \"left\", x = \"10 mm\", holds = \"both\" }, { name = \"right\", x = \"190 mm\" }]\n"
          "seats = [{ name = \"end\", x = \"0 mm\", T = \"=gears.worm.T\", way = \"drives\" }, { name = \"worm\", x = "
          "\"100 mm\", load = \"=gears.worm\", way = \"takes\", integral = true }]\n"
          "k_max = 2\nS_F = 1.5\nS_D = 1.5\nr_T = 0\nR_z = \"6.3 um\"\norders = [" +
              orders + "]\n",
          "shaft", "fatigue");
    };
    CHECK(shaft("{ name = \"blades\", h = 20 }") == "not-judged");
    CHECK(shaft("{ name = \"blades\", h = 20 }, { name = \"mesh\", h = 2 }") == "pass");
  }

  TEST_CASE("a gear on a shaft has a mass and inertia that fit its size") {
    const auto shaft = [](const std::string& mass, const std::string& I_p) {
      const std::string was = "mass = \"8 kg\", J = \"0.035 kg*m^2\", I_p = \"0.035 kg*m^2\"";
      return how(
          in_place_of(example("gear-stage"), was, "mass = \"" + mass + "\", J = \"0.4 kg*m^2\", I_p = \"" + I_p + "\""),
          "wheel_shaft", "fatigue");
    };
    CHECK(shaft("8 kg", "0.035 kg*m^2") == "pass");  // a disc of 146 mm has 0.021 kg m^2
    CHECK(shaft("8 kg", "0.005 kg*m^2") == "not-judged");
    CHECK(shaft("80 kg", "0.35 kg*m^2") == "not-judged");  // and 4.9 kg
  }

  TEST_CASE("a moment of inertia is about the axis, of a body with a plausible density") {
    const auto fan = [](const std::string& J, const std::string& x, const std::string& rho = "7850 kg/m^3") {
      return solved_as_found(
          "[fan]\ncalculator = \"machine.run_up\"\nparts = [{ name = \"rotor\", J = \"0.05 kg*m^2\" }, { name = "
          "\"fan\", J = \"" +
          J +
          "\", u = 0.5 }]\nmotor = [[\"0 rpm\", \"45 N*m\"], [\"1400 rpm\", \"45 N*m\"]]\nload = [[\"0 rpm\", "
          "\"2 N*m\"], [\"1400 rpm\", \"26 N*m\"]]\nn_2 = \"1400 rpm\"\n\n[w]\ncalculator = \"dynamics.inertia\"\n"
          "rho = \"" +
          rho + "\"\nparts = [{ name = \"rim\", D = \"600 mm\", d_i = \"500 mm\", h = \"80 mm\", x = \"" + x +
          "\" }]\n");
    };
    CHECK(mode_of(fan("=w.J", "100 mm"), "fan", "stall") == "pass");
    CHECK(mode_of(fan("=w.J_S", "0 mm"), "fan", "stall") == "pass");
    CHECK(mode_of(fan("=w.J_S", "100 mm"), "fan", "stall") == "not-judged");
    CHECK(mode_of(fan("=w.J", "0 mm", "720 kg/m^3"), "fan", "stall") == "pass");  // wood
    CHECK(mode_of(fan("=w.J", "0 mm", "785 kg/m^3"), "fan", "stall") == "not-judged");
  }

  TEST_CASE("an ellipsoid or a hemisphere has the radius of a shell of its pressure, however it is typed") {
    const auto head = [](const std::string& lines) {
      return how(
          "[shell]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\nmeasured = \"inner\"\n"
          "sigma_adm = \"140 MPa\"\n\n[head]\nmeasured = \"inner\"\nsigma_adm = \"140 MPa\"\n" +
              lines,
          "head", "strength");
    };
    const std::string ellipsoid = "calculator = \"vessel.ellipsoid\"\nb = \"300 mm\"\n";
    CHECK(head(ellipsoid + "p = \"1 MPa\"\na = \"500 mm\"\n") == "not-judged");
    CHECK(head(ellipsoid + "p = \"1 MPa\"\na = \"600 mm\"\n") == "pass");
    const std::string sphere = "calculator = \"vessel.sphere\"\n";
    CHECK(head(sphere + "p = \"1 MPa\"\nR = \"300 mm\"\n") == "not-judged");
    CHECK(head(sphere + "p = \"1 MPa\"\nR = \"600 mm\"\n") == "pass");
    CHECK(head(sphere + "p = \"0.8 MPa\"\nR = \"300 mm\"\n") == "pass");  // of another vessel
  }

  TEST_CASE("flanks have the roughness of their finish, and oils have a viscosity") {
    const auto rating = [](const std::string& lines) { return mode_with("gear.rating", lines, "pitting_1"); };
    CHECK(rating("finish = \"ground\"\nR_z1 = \"5 um\"\nR_z2 = \"5 um\"") == "pass");
    CHECK(rating("finish = \"ground\"\nR_z1 = \"20 um\"\nR_z2 = \"20 um\"") == "not-judged");
    CHECK(rating("finish = \"ground\"\nR_z1 = \"0.1 um\"\nR_z2 = \"0.1 um\"") == "not-judged");
    CHECK(rating("finish = \"hobbed\"\nR_z1 = \"0.6 um\"\nR_z2 = \"0.6 um\"") == "not-judged");
    const std::string iso = "standard = \"iso6336\"\nnu_40 = ";
    CHECK(rating(iso + "\"220 mm^2/s\"") == "pass");
    CHECK(rating(iso + "\"22000 mm^2/s\"") == "not-judged");
  }

  TEST_CASE("the length of a column is for its first buckling mode, not a higher one") {
    const auto rod = [](const std::string& lines) {
      return how(
          "[el]\ncalculator = \"column.effective_length\"\nl = \"2.5 m\"\nend_1 = \"pinned\"\nend_2 = "
          "\"pinned\"\nmode = 2\n\n[rod]\ncalculator = \"column.buckling\"\nP = \"10 kN\"\nd = \"45 mm\"\nE = "
          "\"210 GPa\"\nR_e = \"340 MPa\"\nsigma_P = \"270 MPa\"\nmethod = \"euler\"\nn_st = 3\nends = "
          "\"pinned_pinned\"\n" +
              lines,
          "rod", "buckling");
    };
    CHECK(rod("l = \"=el.l\"\n") == "pass");
    CHECK(rod("l = \"=el.s\"\n") == "pass");
    CHECK(rod("l = \"=el.l*el.beta_n\"\n") == "not-judged");
    CHECK(rod("l = \"=el.s/2\"\n") == "not-judged");
    CHECK(rod("l = \"=el.s/2\"\nbecause.l = \"braced in the middle\"\n") == "pass");
  }

  TEST_CASE("a fatigue limit is for the rectangle of its part") {
    const std::string link = example("press-link");
    CHECK(how(link, "web_life", "fatigue") == "pass");
    CHECK(how(in_place_of(link, "h = \"=web.h\"", "h = \"5 mm\""), "web_life", "fatigue") == "not-judged");
    CHECK(how(in_place_of(link, "h = \"=web.h\"", "h = \"40 mm\""), "web_life", "fatigue") == "pass");
  }

  TEST_CASE("a pin turns at the speed of its link, not at the minimum of it") {
    const std::string link = example("press-link"), n = "n = \"=press.links.lower.omega\"";
    CHECK(how(link, "pin", "bending") == "pass");
    CHECK(how(in_place_of(link, n, "n = \"=min(press.links.lower.omega)\""), "pin", "bending") == "not-judged");
    CHECK(how(in_place_of(link, n, "n = \"=mean(press.links.lower.omega)\""), "pin", "bending") == "not-judged");
    CHECK(how(in_place_of(link, n, "n = \"=peak(press.links.lower.omega)\""), "pin", "bending") == "pass");
  }

  TEST_CASE("a flywheel on a shaft has the mass of its rim") {
    const std::string press = example("press");
    CHECK(how(press, "shaft", "yield") == "pass");
    CHECK(how(in_place_of(press, "mass = \"=flywheel.m_rim\"", "mass = \"1 kg\""), "shaft", "yield") == "not-judged");
  }

  TEST_CASE("pitting of a ring gear is outside the scope, not a step to add") {
    const auto project = solved_as_found(
        "[ring]\ncalculator = \"gear.pair\"\nmesh = \"internal\"\nz_1 = 30\nz_2 = 84\nm_n = \"3 mm\"\nb = \"30 mm\"\n"
        "T_1 = \"60 N*m\"\nn_1 = \"700 rpm\"\ncutting = \"hobbed\"\nK_f = 1.6\nsigma_adm_1 = \"200 MPa\"\n");
    const auto modes = project::modes(project);
    const auto pitting = std::ranges::find(modes, "pitting_1", &account::Mode::id);
    REQUIRE(pitting != modes.end());
    CHECK(pitting->state == account::State::not_judged);
    CHECK_FALSE(pitting->is_assessable);
  }

  TEST_CASE("a column without any load is not assessed, however stocky it is") {
    const std::string column =
        "[rod]\ncalculator = \"column.buckling\"\nl = \"900 mm\"\nd = \"45 mm\"\nends = \"fixed_free\"\n"
        "E = \"210 GPa\"\nR_e = \"340 MPa\"\nsigma_P = \"270 MPa\"\nmethod = \"euler\"\nn_st = 3\n";
    CHECK(headline_of(column) == account::Headline::incomplete);
    CHECK(how(column, "rod", "slenderness") == "pass");
    CHECK(headline_of(column + "P = \"40 kN\"\n") == account::Headline::pass);
  }
}

TEST_SUITE("found values stated only") {
  TEST_CASE("a vacuum of [values] above the external pressure") {
    const auto shell = [](const std::string& vacuum) {
      return how(
          "[values]\np_half = \"0.05 MPa\"\np_vacuum = \"" + vacuum +
              "\"\n\n[shell]\ncalculator = \"vessel.external\"\np_e = \"=values.p_half\"\nD_a = \"1200 mm\"\nL = "
              "\"2400 mm\"\nc = \"1 mm\"\nmaterial = \"P265GH\"\n",
          "shell", "buckling");
    };
    CHECK(shell("0.1 MPa") == "not-judged");
    CHECK(shell("0.05 MPa") == "pass");
  }

  TEST_CASE("a vacuum of [values] for which no step assesses a wall") {
    const auto shell = [](const std::string& values) {
      return how("[values]\n" + values +
                     "\n\n[shell]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\nsigma_adm = \"120 "
                     "MPa\"\n",
                 "shell", "strength");
    };
    CHECK(shell("p_vacuum = \"0.1 MPa\"") == "not-judged");
    CHECK(shell("p_valve = \"1.1 MPa\"") == "pass");  // of the data sheet
  }

  TEST_CASE("a peak factor, repetitions and strengths of [values]") {
    const auto shoulder = [](const std::string& values) {
      return how("[values]\n" + values +
                     "\n\n[shoulder]\ncalculator = \"fatigue.din743\"\ngroup = \"quenched-tempered\"\nsigma_B = \"1100 "
                     "MPa\"\nsigma_S = \"900 MPa\"\nd_h = \"60 mm\"\nnotch = \"shoulder\"\nd = \"42 mm\"\nD = \"50 "
                     "mm\"\nr = \"2.5 mm\"\nR_z = \"6.3 um\"\nmean = \"proportional\"\nM_ba = \"800 N*m\"\nM_tm = "
                     "\"900 N*m\"\nM_ta = \"150 N*m\"\nf_max = 1\n",
                 "shoulder", "yield");
    };
    CHECK(shoulder("f_start = 3") == "not-judged");
    CHECK(shoulder("f_start = 1") == "pass");
    CHECK(shoulder("n_start = 40") == "pass");
    const auto bracket = [](const std::string& values) {
      return how("[values]\n" + values +
                     "\n\n[bracket]\ncalculator = \"fatigue.history\"\nblocks = [{ sigma_a = \"180 MPa\", n = 500 }]\n"
                     "sigma_D = \"120 MPa\"\nN_D = 1e6\nk = 5\nmean = \"goodman\"\nR_m = \"690 MPa\"\nR_e = \"490 "
                     "MPa\"\nS_F = 1.5\nn_req = 1\n",
                 "bracket", "fatigue");
    };
    for (const std::string period : {"days", "weeks", "months", "years", "shifts", "repetitions", "n_req"})
      CHECK_MESSAGE(bracket(period + " = 7300") == "not-judged", period);
    CHECK(bracket("days = 1") == "pass");
    const auto shaft = [](const std::string& values) {
      return how("[values]\n" + values +
                     "\n\n[shaft]\ncalculator = \"shaft.torsion\"\nT = \"300 N*m\"\nd = \"60 mm\"\nR_e = \"355 "
                     "MPa\"\nS = 2\n",
                 "shaft", "yield");
    };
    CHECK(shaft("R_e = \"235 MPa\"") == "not-judged");
    CHECK(shaft("R_e = \"400 MPa\"") == "pass");
    CHECK(shaft("R_m = \"235 MPa\"") == "pass");
  }

  TEST_CASE("a temperature of [values] above that of the strengths") {
    const auto limit = [](const std::string& values) {
      return headline_of("[values]\n" + values +
                         "\n\n[shoulder]\ncalculator = \"fatigue.endurance\"\nR_m = \"690 MPa\"\ngroup = "
                         "\"carbon-steel\"\nrule = \"din743\"\nloading = \"bending\"\nschool = \"serensen\"\nd = \"32 "
                         "mm\"\nK_t = 1.65\nr_n = \"3 mm\"\nR_z = \"6.3 um\"\n");
    };
    CHECK(limit("t_service = \"500 degC\"") == account::Headline::incomplete);
    CHECK(limit("t_service = \"60 degC\"") == account::Headline::pass);
    CHECK(limit("t_join = \"200 degC\"") == account::Headline::pass);
    const auto shaft = [](const std::string& values) {
      return how("[values]\n" + values +
                     "\n\n[shaft]\ncalculator = \"shaft.torsion\"\nT = \"300 N*m\"\nd = \"60 mm\"\ntau_adm = \"40 "
                     "MPa\"\n",
                 "shaft", "yield");
    };
    CHECK(shaft("t_service = \"500 degC\"") == "not-judged");
    CHECK(shaft("t_service = \"20 degC\"") == "pass");
  }
}
