// Regression tests of steps that are connected, with a value of their own that contradicts the other step: speeds next
// to powers, flywheels and ends of a start, masses of links, strengths of shafts, pins and lugs.
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string worm_and_belt(const std::string& n_1) {
  return "[worm]\ncalculator = \"gear.worm\"\nz_1 = 2\nz_2 = 40\nm_x = \"4 mm\"\nd_1 = \"40 mm\"\nb_2 = \"30 mm\"\n"
         "P = \"0.6 kW\"\nn_1 = \"1400 rpm\"\nK_A = 1.25\ncasting = \"chill\"\nS_Wmin = 1\nsigma_adm = \"60 MPa\"\n"
         "A_h = \"0.25 m^2\"\ndT_adm = \"60 K\"\n[belt]\ncalculator = \"belt.synchronous\"\nsynchronous_belt = \"XH\"\n"
         "P = \"=worm.P_2\"\nK_A = 1.5\nz_1 = 24\nz_2 = 24\na = \"700 mm\"\nb = \"101.6 mm\"\nn_1 = \"" +
         n_1 + "\"\n";
}

std::string wheel_and_start(const std::string& u, const std::string& n_2) {
  return "[fly]\ncalculator = \"machine.flywheel\"\npoints = [[\"0 deg\", \"200 N*m\"], [\"150 deg\", \"200 N*m\"], "
         "[\"160 deg\", \"6000 N*m\"], [\"200 deg\", \"6000 N*m\"], [\"210 deg\", \"200 N*m\"], [\"360 deg\", \"200 "
         "N*m\"]]\nomega = \"150 rpm\"\ndelta = 0.1\nD = \"1000 mm\"\nv_adm = \"30 m/s\"\neta = 0.9\nP_n = \"22 kW\"\n"
         "[start]\ncalculator = \"machine.run_up\"\nparts = [{ J = \"0.2 kg*m^2\" }, { J = \"=fly.J_F\", u = " +
         u +
         " }]\nmotor = [[\"0 rpm\", \"260 N*m\"], [\"1200 rpm\", \"300 N*m\"], [\"1400 rpm\", \"200 N*m\"], [\"1440 "
         "rpm\", \"146 N*m\"]]\nload = [[\"0 rpm\", \"25 N*m\"], [\"1440 rpm\", \"25 N*m\"]]\nt_adm = \"10 s\"\nn_2 = "
         "\"" +
         n_2 + "\"\n";
}

std::string belt_and_start(const std::string& moment) {
  return "[belts]\ncalculator = \"belt.v\"\nbasis = \"optibelt\"\nsection = \"SPA\"\nP = \"7.5 kW\"\nK_A = 1.2\nn_1 = "
         "\"1450 rpm\"\nd_1 = \"125 mm\"\nd_2 = \"250 mm\"\nL = \"1800 mm\"\nz = 3\n[start]\n"
         "calculator = \"machine.run_up\"\nparts = [{ J = \"0.03 kg*m^2\" }, { J = \"1.8 kg*m^2\", u = \"=1/belts.i\" "
         "}]\nload = [[\"0 rpm\", \"2 N*m\"], [\"1450 rpm\", \"45 N*m\"]]\nn_2 = \"1440 rpm\"\nt_adm = \"20 s\"\n"
         "motor = [[\"0 rpm\", \"100 N*m\"], [\"1450 rpm\", \"" +
         moment + "\"]]\n";
}

std::string link(const std::string& mass) {
  return "[mech]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"60 mm\"\nl = \"300 mm\"\n"
         "crank = { speed = \"20 rpm\", positions = 180 }\nlinks.slider.mass = \"40 kg\"\nlinks.rod.mass = \"" +
         mass +
         "\"\nloads = [{ link = \"slider\", at = \"B\", F_x = \"-8 kN\", F_y = \"0 N\" }]\n[rod]\n"
         "calculator = \"link.member\"\nload = \"=mech.links.rod\"\nh = \"40 mm\"\nb = \"25 mm\"\nmaterial = \"S355\"\n"
         "ends_y = \"pinned_pinned\"\nends_z = \"fixed_fixed\"\nbeta_basis = \"recommended\"\nmethod = \"johnson\"\n"
         "n_st = 3\nS = 2\n";
}

std::string lug_and_pin(const std::string& lug, const std::string& pin, const std::string& d) {
  return "[values]\nQ = \"20 kN\"\nf = 1.35\n[lug]\ncalculator = \"pin.lug\"\nF = \"" + lug + "\"\nd = \"" + d +
         "\"\nb = \"80 mm\"\na = \"28 mm\"\nt = \"20 mm\"\np_adm = \"100 MPa\"\nmaterial = \"S355\"\nS = 1.5\n[bolt]\n"
         "calculator = \"pin.joint\"\nF = \"" +
         pin +
         "\"\nheld = \"loose\"\nloading = \"steady\"\nd = \"30 mm\"\nt_1 = \"20 mm\"\nt_2 = \"14 mm\"\nc = \"2 mm\"\n"
         "material = \"42CrMo4\"\np_adm_1 = \"100 MPa\"\np_adm_2 = \"120 MPa\"\n";
}

std::string frame_and_column(const std::string& frame, const std::string& more) {
  return "[k]\ncalculator = \"column.effective_length\"\nl = \"4 m\"\nG_1 = 10\nG_2 = 0.8\nframe = \"" + frame +
         "\"\n[col]\ncalculator = \"column.buckling\"\nP = \"80 kN\"\nl = \"=k.l\"\nsection = \"HEB 200\"\n"
         "material = \"S235JR\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1\n" +
         more;
}

}  // namespace

TEST_SUITE("found connected steps") {
  TEST_CASE("a power that is taken belongs to the speed of its shaft") {
    const auto state = [](const std::string& n_1) {
      return mode_of(solved_as_found(worm_and_belt(n_1)), "belt", "power");
    };
    CHECK(state("=worm.n_2") == state("70 rpm"));
    CHECK(state("70 rpm") != "not-judged");
    CHECK(state("700 rpm") == "not-judged");
  }

  TEST_CASE("a flywheel among the parts of a start has its speed there") {
    const auto state = [](const std::string& u) {
      return mode_of(solved_as_found(wheel_and_start(u, "1440 rpm")), "start", "time");
    };
    CHECK(state("0.104") == "pass");
    CHECK(state("0.0104") == "not-judged");
  }

  TEST_CASE("a start ends near the last speed of motor and load") {
    const auto state = [](const std::string& n_2) {
      return mode_of(solved_as_found(belt_and_start("60 N*m").replace(
                         belt_and_start("60 N*m").find("n_2 = \"1440 rpm\""), 16, "n_2 = \"" + n_2 + "\"")),
                     "start", "time");
    };
    CHECK(state("1440 rpm") == "pass");
    CHECK(state("700 rpm") == "not-judged");
  }

  TEST_CASE("no motor has many times the torque of the belt that it drives") {
    const auto state = [](const std::string& M) {
      return mode_of(solved_as_found(belt_and_start(M)), "start", "time");
    };
    CHECK(state("60 N*m") == "pass");
    CHECK(state("494 N*m") == "not-judged");
  }

  TEST_CASE("a link has at least half of the mass of its bar") {
    const auto state = [](const std::string& mass) { return mode_of(solved_as_found(link(mass)), "rod", "yield"); };
    CHECK(state("2.2 kg") != "not-judged");
    CHECK(state("2.2 g") == "not-judged");
  }

  TEST_CASE("a lug has the diameter of the pin of the same load, and the pin its factor") {
    const auto lug = [](const std::string& d) {
      return mode_of(solved_as_found(lug_and_pin("=values.f*values.Q", "=values.f*values.Q", d)), "lug", "bearing");
    };
    CHECK(lug("30 mm") != "not-judged");
    CHECK(lug("31 mm") != "not-judged");
    CHECK(lug("40 mm") == "not-judged");
    const auto pin = [](const std::string& of_lug, const std::string& of_pin) {
      return mode_of(solved_as_found(lug_and_pin(of_lug, of_pin, "30 mm")), "bolt", "shear");
    };
    CHECK(pin("=values.f*values.Q", "=values.f*values.Q") == "pass");
    CHECK(pin("=1.2*values.f*values.Q", "=values.f*values.Q") == "pass");
    CHECK(pin("=values.f*values.Q", "=values.Q") == "not-judged");
  }

  TEST_CASE("a column of a sway frame has the effective length factor that is found for it") {
    const auto state = [](const std::string& frame, const std::string& more) {
      return mode_of(solved_as_found(frame_and_column(frame, more)), "col", "buckling");
    };
    CHECK(state("braced", "ends = \"pinned_pinned\"\n") == "pass");
    CHECK(state("sway", "ends = \"pinned_pinned\"\n") == "not-judged");
    CHECK(state("sway", "beta_y = \"=k.beta\"\nbeta_z = 1\n") == "pass");
  }

  TEST_CASE("a fatigue limit has the material of the part, also where that is taken from another step") {
    const auto state = [](const std::string& material) {
      return mode_of(solved_as_found("[rod]\ncalculator = \"link.member\"\nN = \"10 kN\"\nV = \"0 N\"\nM_b = \"0 "
                                     "N*m\"\nends = \"pinned_pinned\"\nl = \"200 mm\"\nd = \"20 mm\"\nmaterial = "
                                     "\"C45E\"\nS = 1.5\n[limit]\ncalculator = \"fatigue.endurance\"\nd_h = \"20 mm\"\n"
                                     "d = \"20 mm\"\nfinish = \"machined\"\nrule = \"shigley\"\nschool = \"marin\"\n"
                                     "P_s = 0.99\nloading = \"tension\"\nmaterial = \"" +
                                     material +
                                     "\"\n[life]\ncalculator = \"fatigue.cycle\"\ncycle = \"=rod.cycle\"\nr = -1\nS_D "
                                     "= 1.5\nS_F = 1.5\nmaterial = \"=rod.material\"\nd_h = \"20 mm\"\nsigma_D = "
                                     "\"=limit.sigma_D\"\n"),
                     "life", "fatigue");
    };
    CHECK(state("=rod.material") == "pass");
    CHECK(state("C45E") == "pass");
    CHECK(state("42CrMo4") == "not-judged");
  }
}
