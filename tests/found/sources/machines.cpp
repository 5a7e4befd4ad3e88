// Regression tests of steps next to a mechanism, of steps that nothing takes, and of starts and repetitions.
#include "tests/found/modes.hpp"
#include "tests/pages.hpp"

#include <cmath>
#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string press(const std::string& name, const std::string& force, const std::string& crank = "") {
  return "[" + name +
         "]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"40 mm\"\nl = \"200 mm\"\ncrank = { "
         "speed = \"120 rpm\"" +
         crank + " }\nloads = [{ name = \"work\", link = \"slider\", at = \"B\", F_x = \"-" + force +
         "\", F_y = \"0 N\" }]\n\n";
}

std::string shaft(const std::string& lines = "") {
  return "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"=peak(press.drive.M)\"\nd = \"60 mm\"\ntau_adm = \"40 "
         "MPa\"\n" +
         lines;
}

std::string pin(const std::string& force, const std::string& lines = "") {
  return "[pin]\ncalculator = \"pin.joint\"\n" + force +
         "n = \"=press.links.rod.omega\"\nheld = \"in_fork\"\nloading = \"pulsating\"\nd = \"20 mm\"\nt_1 = \"20 mm\"\n"
         "t_2 = \"10 mm\"\nmaterial = \"C45E\"\np_adm_1 = \"40 MPa\"\np_adm_2 = \"80 MPa\"\npv_adm = \"2 MPa*m/s\"\n" +
         lines;
}

std::string lug(const std::string& part, const std::string& lines = "") {
  return "[" + part + "]\ncalculator = \"pin.lug\"\nload = \"=pin." + part +
         "\"\nb = \"60 mm\"\na = \"20 mm\"\nsigma_adm = \"80 MPa\"\ntau_adm = \"40 MPa\"\np_adm = \"40 MPa\"\n" + lines;
}

std::string life(const std::string& sigma_D, const std::string& lines = "") {
  return "[life]\ncalculator = \"fatigue.life\"\nsigma_max = \"150 MPa\"\nsigma_min = \"-150 MPa\"\nsigma_D = \"" +
         sigma_D + "\"\nR_m = \"690 MPa\"\nR_e = \"490 MPa\"\ngroup = \"carbon-steel\"\nS_D = 1.5\nS_F = 1.5\n" + lines;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string state(const std::string& text, std::string_view step, std::string_view mode) {
  return mode_of(solved_as_found(text), step, mode);
}

}  // namespace

TEST_SUITE("found machines") {
  TEST_CASE("a peak at a few crank angles is not that of the cycle") {
    CHECK(state(press("press", "8 kN") + shaft(), "shaft", "yield") == "pass");
    const std::string part = press("press", "8 kN", ", at = [\"0 deg\", \"2 deg\"]");
    CHECK(state(part + shaft(), "shaft", "yield") == "not-judged");
    CHECK(state(part + shaft("because.T = \"it swings so far only\"\n"), "shaft", "yield") == "pass");
  }

  TEST_CASE("a typed force next to values of a mechanism is not below those of its joints") {
    const std::string machine = press("press", "8 kN");
    CHECK(state(machine + pin("load = \"=press.joints.B\"\n"), "pin", "bending") == "pass");
    CHECK(state(machine + pin("F = \"1 kN\"\n"), "pin", "bending") == "not-judged");
    CHECK(state(machine + pin("F = \"9 kN\"\n"), "pin", "bending") == "pass");
    CHECK(state(machine + pin("F = \"1 kN\"\n", "because.F = \"of the oil pump\"\n"), "pin", "bending") == "pass");
  }

  TEST_CASE("the force of a joint transverse to a crank is the torque over its length, to a massless rod zero") {
    const auto project = solved_as_found(press("press", "8 kN"));
    const auto most = [&](const char* path) {
      double largest = 0.0;
      for (const double si : project.value(path)->si) largest = std::fmax(largest, std::abs(si));
      return largest;
    };
    CHECK(most("press.joints.A.F_t1") == doctest::Approx(most("press.drive.M") / 0.04).epsilon(1e-9));
    CHECK(most("press.joints.A.F_t2") < 1e-6 * most("press.joints.A.F"));
    CHECK(most("press.joints.O.F_t2") == doctest::Approx(most("press.joints.A.F_t1")).epsilon(1e-9));
    CHECK(project.value("press.joints.O.F_t1") == nullptr);  // the ground
    CHECK(project.value("press.joints.B.F_t2") == nullptr);  // the slider has a guide, and no axis
  }

  TEST_CASE("a rod that pulls across the lug of a crank") {
    const std::string rod =
        "[rod]\ncalculator = \"link.member\"\nload = \"=press.links.rod\"\nh = \"40 mm\"\nb = \"20 mm\"\nends = "
        "\"pinned_pinned\"\nmaterial = \"S235\"\nmethod = \"johnson\"\nn_st = 3\nS = 2\n\n";
    const auto machine = [&](const std::string& joint, const std::string& t_1) {
      return press("press", "8 kN") + rod +
             replaced(pin("load = \"=press.joints." + joint + "\"\n"), "t_1 = \"20 mm\"", "t_1 = \"" + t_1 + "\"");
    };
    CHECK(state(machine("B", "20 mm") + lug("eye") + lug("cheek"), "eye", "net") == "pass");
    CHECK(state(machine("B", "20 mm") + lug("eye") + lug("cheek"), "cheek", "net") == "pass");
    const std::string known = machine("A", "=rod.b") + lug("eye");  // the eye is that of the rod
    CHECK(state(known + lug("cheek"), "eye", "net") == "pass");
    CHECK(state(known + lug("cheek"), "cheek", "net") == "not-judged");
    CHECK(state(known + lug("cheek", "because.load = \"beam to the far side, sheet 3\"\n"), "cheek", "net") == "pass");
    const std::string unknown = machine("A", "20 mm") + lug("eye");
    CHECK(state(unknown, "eye", "net") == "pass");  // it may be that of the rod
    const std::string crank = replaced(replaced(rod, "[rod]", "[arm]"), "press.links.rod", "press.links.crank");
    const std::string of_crank = replaced(lug("eye"), "b = \"60 mm\"", "b = \"=arm.h\"");
    CHECK(state(machine("A", "20 mm") + crank + of_crank, "eye", "net") == "not-judged");
    CHECK(state(unknown + lug("cheek"), "eye", "net") == "not-judged");
    CHECK(state(unknown + lug("cheek"), "cheek", "net") == "not-judged");
  }

  TEST_CASE("a rod that pulls across the plate of a crank, pin by EN 1993") {
    const std::string machine =
        press("press", "8 kN") +
        "[rod]\ncalculator = \"link.member\"\nload = \"=press.links.rod\"\nh = \"40 mm\"\nb = \"20 mm\"\nends = "
        "\"pinned_pinned\"\nmaterial = \"S235\"\nmethod = \"johnson\"\nn_st = 3\nS = 2\n\n";
    const auto plates = [&](const std::string& joint, const std::string& t_1, const std::string& more = "",
                            const std::string& t_2 = "15 mm") {
      return machine + "[pin]\ncalculator = \"pin.en1993\"\nload = \"=press.joints." + joint +
             "\"\ngamma_F = 1.5\ngamma_M0 = 1\ngamma_M2 = 1.25\nd = \"30 mm\"\nd_0 = \"31 mm\"\nt_1 = \"" + t_1 +
             "\"\nt_2 = \"" + t_2 +
             "\"\nc = \"2 mm\"\nf_yp = \"355 MPa\"\nf_up = \"490 MPa\"\nf_y_1 = \"235 "
             "MPa\"\nf_y_2 = \"235 MPa\"\ne_a1 = \"60 mm\"\ne_c1 = \"50 mm\"\ne_a2 = \"60 mm\"\ne_c2 = \"50 mm\"\n" +
             more;
    };
    CHECK(state(plates("B", "20 mm"), "pin", "plate_1") == "pass");
    CHECK(state(plates("B", "20 mm"), "pin", "plate_2") == "pass");
    CHECK(state(plates("A", "=rod.b"), "pin", "plate_2") == "not-judged");  // the middle plate is that of the rod
    CHECK(state(plates("A", "20 mm"), "pin", "plate_1") == "not-judged");
    CHECK(state(plates("A", "=rod.b", "because.e_a2 = \"60 mm on all sides of the bore\"\n"), "pin", "plate_2") ==
          "pass");
    // The middle plate is that of the crank: the outer ones are those of the rod, or it is itself known.
    const std::string reason = "because.e_a1 = \"60 mm on all sides of the bore\"\n";
    CHECK(state(plates("A", "20 mm", "", "=rod.b"), "pin", "plate_1") == "not-judged");
    CHECK(state(plates("A", "20 mm", reason, "=rod.b"), "pin", "plate_1") == "pass");
    const std::string crank = replaced(machine, "[rod]", "[crank]");
    const std::string of_crank = replaced(crank.substr(crank.find("[crank]")), "links.rod", "links.crank");
    CHECK(state(plates("A", "=crank.b", of_crank), "pin", "plate_1") == "not-judged");
    CHECK(state(plates("A", "=crank.b", reason + of_crank), "pin", "plate_1") == "pass");
  }

  TEST_CASE("a heavier load case of the same joints that no step takes") {
    const std::string taken = press("press", "8 kN") + pin("load = \"=press.joints.B\"\n");
    CHECK(state(press("jam", "80 kN") + taken, "pin", "bending") == "not-judged");
    CHECK(state(press("idle", "0.8 kN") + taken, "pin", "bending") == "pass");
  }

  TEST_CASE("a limit from tests that no step takes as it is") {
    const std::string survival =
        "[s]\ncalculator = \"fatigue.survival\"\nsigma_0 = \"288 MPa\"\nN_0 = 1e6\nT_S = 1.25\n"
        "k = 5\nP = 0.975\n\n";
    CHECK(state(survival + life("=s.sigma_P"), "life", "fatigue") == state(life("250 MPa"), "life", "fatigue"));
    CHECK(state(survival + life("=s.sigma_0"), "life", "fatigue") == "not-judged");
    CHECK(state(survival + life("300 MPa"), "life", "fatigue") == "not-judged");
  }

  TEST_CASE("an effective length factor that no step takes") {
    const auto column = [](const std::string& ends) {
      return "[k]\ncalculator = \"column.effective_length\"\nl = \"4 m\"\nE = \"210 GPa\"\nI = \"2003 cm^4\"\n"
             "end_1 = \"elastic\"\nc_1 = \"40 kN*m/rad\"\nend_2 = \"pinned\"\n\n[col]\ncalculator = "
             "\"column.buckling\"\n"
             "section = \"HEB 200\"\nl = \"4 m\"\nP = \"500 kN\"\nmaterial = \"S235\"\nmethod = \"ec3\"\ngamma_M1 = 1\n"
             "gamma_F = 1.4\n" +
             ends;
    };
    CHECK(state(column("beta_y = 0.7\nbeta_z = 0.7\n"), "col", "buckling") == "not-judged");
    CHECK(state(column("ends = \"fixed_fixed\"\n"), "col", "buckling") == "not-judged");
    CHECK(state(column("beta_y = 1\nbeta_z = 1\n"), "col", "buckling") == "pass");
    CHECK(state(column("beta_y = \"=k.beta\"\nbeta_z = \"=k.beta\"\n"), "col", "buckling") == "pass");
  }

  TEST_CASE("the order of the tables in a file does not matter") {
    const std::string survival =
        "[s]\ncalculator = \"fatigue.survival\"\nsigma_0 = \"288 MPa\"\nN_0 = 1e6\nT_S = 1.25\n"
        "k = 5\nP = 0.975\n\n";
    CHECK(state(life("300 MPa") + "\n" + survival, "life", "fatigue") == "not-judged");
    CHECK(state(life("200 MPa") + "\n" + survival, "life", "fatigue") == state(life("200 MPa"), "life", "fatigue"));
    const std::string taken = press("press", "8 kN") + pin("load = \"=press.joints.B\"\n") + "\n";
    CHECK(state(taken + press("jam", "80 kN"), "pin", "bending") == "not-judged");
    CHECK(state(taken + press("idle", "0.8 kN"), "pin", "bending") == "pass");
  }

  TEST_CASE("a column whose forces cancel is not assessed") {
    const auto project = solved_as_found(
        "[values]\nF = \"20 kN\"\n\n[rod]\ncalculator = \"column.buckling\"\n"
        "P = \"=values.F - values.F\"\nl = \"100 mm\"\nd = \"10 mm\"\nends = "
        "\"pinned_pinned\"\nmaterial = \"S235\"\nmethod = \"johnson\"\nn_st = 3\n");
    CHECK(account::conclude(project::modes(project)).headline == account::Headline::incomplete);
  }

  TEST_CASE("a shaft has the peak factor of the start for which its key is calculated") {
    const std::string gearbox = text_of(LOADPATH_ROOT "/examples/gearbox-shaft/project.toml");
    CHECK(state(gearbox, "shaft", "yield") == "pass");
    CHECK(state(replaced(gearbox, "k_max = 2 ", "k_max = 1 "), "shaft", "yield") == "not-judged");
  }

  TEST_CASE("a disc turns no faster than calculated") {
    const auto run = [](const std::string& n) {
      return "[disc]\ncalculator = \"machine.disc\"\nn = \"" + n +
             "\"\nD = \"500 mm\"\nd_i = \"100 mm\"\nb = \"40 mm\"\nrho = \"7850 kg/m^3\"\nnu = 0.3\nE = \"210 "
             "GPa\"\nR_e = "
             "\"450 MPa\"\nS = 2\n\n[up]\ncalculator = \"machine.run_up\"\nparts = [{ name = \"disc\", J = "
             "\"=disc.J_z\" }]\nmotor = [[\"0 rpm\", \"45 N*m\"], [\"6000 rpm\", \"60 N*m\"]]\nn_2 = \"6000 rpm\"\n";
    };
    const auto headline = [&](const std::string& n) {
      return account::conclude(project::modes(solved_as_found(run(n)))).headline;
    };
    CHECK(headline("6000 rpm") == account::Headline::pass);
    CHECK(headline("3000 rpm") == account::Headline::incomplete);
  }

  TEST_CASE("a flywheel is not driven faster by its motor than calculated") {
    const auto start = [](const std::string& i, const std::string& lines = "") {
      const std::string text =
          "[wheel]\ncalculator = \"machine.flywheel\"\nM_of_phi = \"100 N*m + 60 N*m*sin(phi)\"\nomega = \"120 "
          "rpm\"\ndelta = 0.05\n\n[run]\ncalculator = \"machine.motion\"\nM = \"100 N*m\"\nJ_F = \"=wheel.J_F\"\n"
          "J_M = \"0.01 kg*m^2\"\nM_K = \"60 N*m\"\nn_0 = \"1500 rpm\"\ns_K = 0.2\ni = " +
          i + "\n" + lines;
      return mode_of(solved_as_found(text), "run", "start");
    };
    CHECK(start("12") == "pass");  // 125 rpm without load
    CHECK(start("8") == "not-judged");
    CHECK(start("8", "because.J_F = \"the rim is rated for 300 rpm by its maker\"\n") == "pass");
  }

  TEST_CASE("an end has the test, the vacuum and the liquid of its shell") {
    const auto vessel = [](const std::string& of_shell, const std::string& of_end, const std::string& more = "") {
      return "[shell]\ncalculator = \"vessel.cylinder\"\np = \"0.4 MPa\"\nR = \"500 mm\"\nmeasured = \"inner\"\nc = "
             "\"1 "
             "mm\"\ndelta = \"10 mm\"\nmaterial = \"P265GH\"\nS = 1.5\n" +
             of_shell +
             "\n[head]\ncalculator = \"vessel.end\"\nshell = \"=shell.shell\"\nform = \"korbbogen\"\nmaterial = "
             "\"P265GH\"\nl_f = \"40 mm\"\ndelta = \"10 mm\"\n" +
             of_end + more;
    };
    const std::string test = "p_t = \"0.8 MPa\"\nh_t = \"0 mm\"\n";
    CHECK(state(vessel("", ""), "head", "strength") == "pass");
    CHECK(state(vessel(test, test), "head", "strength") == "pass");
    CHECK(state(vessel(test, ""), "head", "strength") == "not-judged");
    const std::string vacuum =
        "\n[vacuum]\ncalculator = \"vessel.external\"\nwall = \"=shell.wall\"\np_e = \"0.1 MPa\"\n"
        "L = \"1000 mm\"\nmaterial = \"P265GH\"\n";
    CHECK(state(vessel("", "", vacuum), "head", "strength") == "not-judged");
    CHECK(state(vessel("", "because.p = \"a pad of elastomer carries it\"\n", vacuum), "head", "strength") == "pass");
  }
}
