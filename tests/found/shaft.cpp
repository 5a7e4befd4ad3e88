// Regression tests of shafts: faults found in use.
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string gears = R"([gears]
calculator = "gear.pair"
z_1 = 20
z_2 = 57
m_n = "2.5 mm"
T_1 = "60 N*m"
b = "25 mm"
)";
const std::string plain = "torques = \nT = \"100 N*m\"\ntheta_adm = \nG = ";

}  // namespace

TEST_SUITE("found shaft") {
  TEST_CASE("A12: a torque that comes from a gear bends the shaft, and varies") {
    const auto project = solved_as_found(gears + R"(
[axle]
calculator = "shaft.torsion"
T = "=gears.T_2"
tau_adm = "20 MPa"
)");
    CHECK(mode_of(project, "axle", "yield") == "pass");
    for (const char* id : {"fatigue", "critical_bending", "critical_torsion"})
      CHECK(mode_of(project, "axle", id) == "not-judged");
    CHECK(mode_of(project, "axle", "bending") == "not-covered");  // the forces of the teeth accompany the torque
  }

  TEST_CASE("a torque that is typed passes with its scope") {
    CHECK(mode_with("shaft.torsion", plain, "yield") == "pass");
    for (const char* id : {"bending", "fatigue", "twist", "deflection", "brittle"})
      CHECK(mode_with("shaft.torsion", plain, id) == "open");
    CHECK(mode_with("shaft.torsion", plain + "\nK_A = 1.5", "fatigue") == "not-judged");
    CHECK(mode_with("shaft.torsion", plain + "\nF = \"900 N\"", "bending") == "not-covered");
    CHECK(mode_with("shaft.torsion", plain, "wall") == "none");
    CHECK(mode_with("shaft.torsion", plain + "\nchi = 0.95", "wall") == "not-judged");
  }

  TEST_CASE("A29: without a torque nothing passes") {
    CHECK(mode_with("shaft.torsion", plain + "\nT = \"0 N*m\"", "yield") == "none");
    CHECK(mode_with("shaft.overhung", "F = \"0 N\"\nT = \"0 N*m\"", "yield") == "none");
    CHECK(mode_with("shaft.overhung", "", "yield") == "pass");
  }

  TEST_CASE("A32: C45E has 430 MPa finished to 40 mm, 370 MPa where it was quenched and tempered at 45 mm") {
    const std::string lines = plain + "\ntau_adm = \nmaterial = \"C45E\"\nS = 2\nd = \"40 mm\"";
    CHECK(std::abs(ExampleStep("shaft.torsion", lines)("tau_all") / 1e6 - 430.0 / 2.0 / std::sqrt(3.0)) < 1e-6);
    const ExampleStep quenched("shaft.torsion", lines + "\nd_h = \"45 mm\"");
    CHECK(std::abs(quenched("tau_all") / 1e6 - 370.0 / 2.0 / std::sqrt(3.0)) < 1e-6);
    CHECK_FALSE(ExampleStep("shaft.torsion", lines + "\nd_h = \"35 mm\"").fault().empty());
  }
}

TEST_SUITE("found key") {
  TEST_CASE("a weak hub fails where shaft and key pass") {
    CHECK(mode_with("shaft.key", "R_e_2 = \nT = \"1 kN*m\"\np_adm_2 = \"60 MPa\"", "hub") == "fail");
    CHECK(mode_with("shaft.key", "R_e_2 = \nT = \"1 kN*m\"\np_adm_2 = \"60 MPa\"", "shaft") == "pass");
    CHECK(mode_with("shaft.key", "R_e_k = \"150 MPa\"\nT = \"1 kN*m\"", "key") == "fail");
    CHECK(mode_with("shaft.key", "R_e_1 = \"150 MPa\"\nT = \"1.1 kN*m\"", "shaft") == "fail");
    CHECK(mode_with("shaft.key", "R_e_2 = ", "hub") == "not-judged");
  }

  TEST_CASE("a key that is longer than the hub, of another shaft, or too high, fails") {
    CHECK(mode_with("shaft.key", "l_n = \"60 mm\"", "hub_length") == "fail");
    CHECK(mode_with("shaft.key", "l_n = ", "hub_length") == "not-judged");
    CHECK(mode_with("shaft.key", "d = \"44 mm\"", "fit") == "fail");
    CHECK(mode_with("shaft.key", "d = \"55 mm\"", "fit") == "fail");
    CHECK(mode_with("shaft.key", "d = \"45 mm\"", "fit") == "pass");
    CHECK_FALSE(ExampleStep("shaft.key", "t_2 = \"3 mm\"").fault().empty());  // it is 3.8 mm in the row 14x9
    const std::string typed = "key = \nb = \"14 mm\"\nh = \"9 mm\"\nt_1 = \"5.5 mm\"\n";
    CHECK(mode_with("shaft.key", typed + "t_2 = \"3 mm\"", "depth") == "fail");
    CHECK(mode_with("shaft.key", typed + "t_2 = \"3.8 mm\"", "depth") == "pass");
    CHECK(mode_with("shaft.key", "l = \"90 mm\"\nl_n = \"100 mm\"", "length") == "not-covered");
  }

  TEST_CASE("a torque that reverses is not assessed as if it did not") {
    CHECK(mode_with("shaft.key", "", "reversal") == "none");
    CHECK(mode_with("shaft.key", "torque = ", "reversal") == "open");
    CHECK(mode_with("shaft.key", "torque = \"reversing\"", "reversal") == "not-judged");
    CHECK(mode_with("shaft.key", "torque = \"reversing\"\nf_W = 0.5", "reversal") == "pass");
    CHECK(mode_with("shaft.key", "torque = \"reversing\"\nf_W = 0.4", "reversal") == "fail");
  }

  TEST_CASE("a start of five times the torque breaks the key, which K_A does not show") {
    CHECK(mode_with("shaft.key", "K_A = 1", "hub") == "pass");
    CHECK(mode_with("shaft.key", "K_A = 1\nT_max = \"-2.25 kN*m\"", "hub") == "fail");
  }

  TEST_CASE("the forces of a gear bend the shaft, and the key takes only its torque") {
    const auto project = solved_as_found(gears + R"(
[seat]
calculator = "shaft.key"
load = "=gears.gear_2"
d = "35 mm"
key = "10x8"
l = "45 mm"
)");
    CHECK(mode_of(project, "seat", "seat") == "not-judged");
    CHECK(mode_of(project, "seat", "reversal") == "not-judged");
  }
}

TEST_SUITE("found press fit") {
  TEST_CASE("the minimum interference slips where the maximum holds, the maximum yields where the minimum does not") {
    CHECK(mode_with("shaft.press_fit", "", "slip") == "pass");
    CHECK(mode_with("shaft.press_fit", "U_min = \"20 um\"", "slip") == "fail");
    CHECK(mode_with("shaft.press_fit", "U_max = \"120 um\"", "hub") == "fail");
    CHECK(mode_with("shaft.press_fit", "d_i = \"50 mm\"\nU_max = \"120 um\"", "shaft") == "fail");
  }

  TEST_CASE("an axial force next to the torque, oil, and heat make it slip") {
    CHECK(mode_with("shaft.press_fit", "F_z = \"-30 kN\"", "slip") == "fail");
    CHECK(mode_with("shaft.press_fit", "mu = 0.08", "slip") == "fail");
    CHECK(mode_with("shaft.press_fit", "dT_1 = \"5 K\"\ndT_2 = \"25 K\"", "slip") == "fail");
    CHECK(mode_with("shaft.press_fit", "dT_2 = \"-60 K\"", "hub") == "fail");
  }

  TEST_CASE("a hub heated beyond its limit is not fitted, and missing input is not assessed") {
    CHECK(mode_with("shaft.press_fit", "dT_adm = \"200 K\"", "shrinking") == "fail");
    CHECK(mode_with("shaft.press_fit", "mu_e = 0.1\nF_adm = \"100 kN\"", "pressing") == "fail");
    CHECK(mode_with("shaft.press_fit", "S_r = ", "slip") == "not-judged");
    CHECK(mode_with("shaft.press_fit", "S_F = ", "hub") == "not-judged");
    CHECK(mode_with("shaft.press_fit", "T = \"0 N*m\"", "hub") == "pass");
  }
}

TEST_SUITE("found held bar") {
  TEST_CASE("the sleeve of a weak material governs, not the bar; its joint does not silently pass") {
    CHECK(mode_with("shaft.held", "", "yield") == "pass");
    CHECK(mode_with("shaft.held", "", "joint") == "not-judged");
    CHECK(mode_with("shaft.held", "sleeves = ", "joint") == "none");
    const std::string weak =
        "sleeves = [{ x = \"100 mm\", l = \"150 mm\", d = \"75 mm\", d_bore = \"60 mm\", G = \"27 GPa\", tau_adm = \"3 "
        "MPa\" }]";
    CHECK(mode_with("shaft.held", weak, "yield") == "fail");
  }

  TEST_CASE("a reversed torque, distributed or concentrated, is assessed alike") {
    CHECK(mode_with("shaft.held", "torques = [{ x = \"500 mm\", T = \"-2 kN*m\" }]", "yield") == "fail");
    CHECK(mode_with("shaft.held",
                    "torques = \nsleeves = \nsegments = [{ l = \"1 m\", d = \"20 mm\", m = \"-1 kN*m/m\" }]",
                    "yield") == "fail");
    CHECK(mode_with("shaft.held", "phi_adm = \"0.1 deg\"", "rotation") == "fail");
  }

  TEST_CASE("brittle and ductile are two modes; a thin tube and a steep cone do not pass") {
    CHECK(mode_with("shaft.held", "behaviour = \"brittle\"", "yield") == "none");
    CHECK(mode_with("shaft.held", "behaviour = \"brittle\"", "fracture") == "pass");
    CHECK(mode_with("shaft.held", "sleeves = \nsegments = [{ l = \"1 m\", d = \"100 mm\", d_bore = \"91 mm\" }]",
                    "wall") == "not-judged");
    CHECK(mode_with("shaft.held", "sleeves = \nsegments = [{ l = \"1 m\", d = \"500 mm\", d_2 = \"100 mm\" }]",
                    "yield") == "not-covered");
    CHECK(mode_with("shaft.held", "K_A = 1.5", "fatigue") == "not-judged");
  }

  TEST_CASE("the strength is that of the thickest member, of sleeves too") {
    const ExampleStep step("shaft.held",
                           "sleeves = [{ x = \"0 mm\", l = \"200 mm\", d = \"200 mm\", d_bore = \"60 mm\" }]");
    CHECK(step.project().steps[0]->value("d_s")->si[0] == doctest::Approx(0.2));
    const std::string beyond = "sigma_adm = \nbehaviour = \nmaterial = \"C45E\"\nS = 1.5\n";  // of its table, 100 mm
    CHECK(mode_with("shaft.held",
                    beyond + "G = \nsleeves = [{ x = \"0 mm\", l = \"200 mm\", d = \"200 mm\", d_bore = \"60 mm\" }]",
                    "yield") == "not-covered");
  }
}

TEST_SUITE("found groove") {
  TEST_CASE("a groove lies within its segment, and is only as sharp as can be manufactured") {
    const auto fault = [](const std::string& groove) {
      return ExampleStep("shaft.design",
                         "notches = [{ x = \"60 mm\", kind = \"shoulder\", r = \"2 mm\" }, { x = \"140 mm\", "
                         "kind = \"shoulder\", r = \"2 mm\" }, { kind = \"rectangular-groove\", " +
                             groove + " }]")
          .fault();
    };
    CHECK(fault("x = \"80 mm\", t = \"1.25 mm\", w = \"1.85 mm\", r = \"0.1 mm\"").empty());
    CHECK(fault("x = \"80 mm\", t = \"1.25 mm\", w = \"1.85 mm\", r = \"1 mm\"").find("root radius") !=
          std::string::npos);
    CHECK(fault("x = \"80 mm\", t = \"1.25 mm\", w = \"60 mm\", r = \"0.1 mm\"").find("within its piece") !=
          std::string::npos);
    CHECK(fault("x = \"98 mm\", t = \"1.25 mm\", w = \"10 mm\", r = \"0.1 mm\"").find("a component lies") !=
          std::string::npos);
  }

  TEST_CASE("a fillet has space on the thinner side, and leaves a face for the abutting part") {
    const auto fault = [](const std::string& fillet) {
      return ExampleStep("shaft.design", "notches = [{ x = \"60 mm\", kind = \"shoulder\", " + fillet +
                                             " }, { x = \"140 mm\", kind = \"shoulder\", r = \"2 mm\" }]")
          .fault();
    };
    CHECK(fault("r = \"5 mm\", h = \"2 mm\"").empty());  // as high as the step
    CHECK(fault("r = \"6 mm\"").empty());                // an arc that ends in an edge, as charts have it
    CHECK(fault("r = \"6 mm\", h = \"2 mm\"").find("exceeds the step height") != std::string::npos);
    CHECK(fault("r = \"360 mm\"").empty());  // sqrt(5 (720 - 5)) = 59.8 mm of the piece's 60
    CHECK(fault("r = \"365 mm\"").find("along a segment of 60 mm") != std::string::npos);
  }

  TEST_CASE("a torque given by power and speed is taken like a torque") {
    const ExampleStep step("shaft.held", "torques = [{ name = \"lever\", x = \"500 mm\", T = \"=5 kW/(1450 rpm)\" }]");
    const ExampleStep same("shaft.held", "torques = [{ name = \"lever\", x = \"500 mm\", T = \"32.92860892 N*m\" }]");
    CHECK(std::abs(step("R_1") / same("R_1") - 1.0) < 1e-6);  // 5000/(1450 pi/30)
  }
}

TEST_SUITE("found shaft between bearings") {
  TEST_CASE("two keys weaken the shaft more than one, by 1.15") {
    CHECK(ExampleStep("shaft.key", "")("notch.kind") != ExampleStep("shaft.key", "i = 2")("notch.kind"));
    const auto K_f = [](const std::string& kind) {
      const ExampleStep step("shaft.design",
                             "notches = [{ x = \"60 mm\", r = \"2 mm\" }, { x = \"140 mm\", r = \"2 mm\" }, { name = "
                             "\"key\", x = \"80 mm\", kind = \"" +
                                 kind + "\" }]");
      return std::pair(step("safeties.key.K_t"), step("safeties.key.K_ts"));
    };
    CHECK(std::abs(K_f("two-keyways").first - 1.15 * 2.14) < 1e-12);
    CHECK(std::abs(K_f("two-keyways").second / K_f("keyway").second - 1.15) < 1e-12);
  }

  TEST_CASE("notches that interact are not assessed one by one; a grey iron may break") {
    const auto state = [](const std::string& x, const std::string& mode) {
      return mode_with(
          "shaft.design",
          "R_z = \"6.3 um\"\nnotches = [{ x = \"60 mm\", r = \"2 mm\" }, { x = \"140 mm\", r = \"2 mm\" }, { x = "
          "\"100 mm\", kind = \"keyway\" }, { x = \"" +
              x + "\", kind = \"press-fit\" }]",
          mode);
    };
    CHECK(state("99 mm", "neighbours") == "not-judged");
    CHECK(state("88 mm", "neighbours") == "none");
    const std::string iron =
        "material = \nE = \"120 GPa\"\nG = \"46 GPa\"\nrho = \"7200 kg/m^3\"\nR_e = \"249 MPa\"\nR_m = \"250 "
        "MPa\"\nsigma_W = \"100 MPa\"\ngroup = ";
    CHECK(mode_with("shaft.design", iron + "\"grey-iron\"", "brittle") == "not-judged");
    CHECK(mode_with("shaft.design", iron + "\"ductile-iron\"", "brittle") == "open");
  }

  TEST_CASE("a revolution with few positions hides the peak load of the shaft") {
    const auto errors = [](const std::string& positions) {
      std::vector<Issue> issues;
      project::Project project = project::read_project(
          "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"40 mm\"\nl = \"90 "
          "mm\"\ncrank = { "
          "speed = \"60 rpm\", positions = " +
              positions +
              " }\nloads = [{ name = \"F\", link = \"slider\", at = \"B\", F_x = \"-2 kN\", F_y = \"0 N\" }]\n[shaft]\n"
              "calculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\nS_F = 1.5\nS_D = "
              "1.5\npieces = [{ l "
              "= \"400 mm\", d = \"70 mm\" }]\nsupports = [{ x = \"50 mm\", holds = \"both\" }, { x = \"350 mm\" "
              "}]\nseats = [{ "
              "x = \"200 mm\", load = \"=press.shafts.O\" }, { x = \"0 mm\", way = \"balances\" }]\n",
          "found.toml", catalogue(), issues);
      if (!has_errors(issues)) project::solve(project, issues);
      std::string all;
      for (const Issue& issue : issues) all += issue.severity == Severity::error ? issue.message.text() : "";
      return all;
    };
    CHECK(errors("72").empty());
    CHECK(errors("12").find("between the positions of the turn") != std::string::npos);
  }

  TEST_CASE("the torque does not reach the end of a long fit") {
    CHECK(mode_with("shaft.press_fit", "", "slip") == "pass");
    CHECK(mode_with("shaft.press_fit", "l = \"200 mm\"", "slip") == "not-covered");
  }
}
