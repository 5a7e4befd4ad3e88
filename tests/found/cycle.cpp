// Regression tests of loads over a cycle: reductions of series, laws between positions.
#include "tests/found/modes.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string press = R"([press]
calculator = "mechanism.planar"
template = "slider_crank"
r = "40 mm"
l = "300 mm"
crank = { speed = "120 rpm", positions = 360 }
links.rod.mass = "2 kg"
links.slider.mass = "5 kg"
[[press.loads]]
name = "punch"
link = "slider"
at = "B"
F_x = "-80 kN"
F_y = "0 N"
useful = "yes"
over = [["0 deg", 0], ["318 deg", 0], ["330 deg", 1], ["350 deg", 1], ["360 deg", 0]]
)";

std::string pin(const std::string& F, const std::string& step = "press") {
  return "[pin]\ncalculator = \"pin.joint\"\nF = \"=" + F +
         "\"\nheld = \"in_fork\"\nloading = \"pulsating\"\nd = \"80 mm\"\nt_1 = \"80 mm\"\nt_2 = \"60 mm\"\nR_m = "
         "\"700 "
         "MPa\"\np_adm_1 = \"60 MPa\"\np_adm_2 = \"80 MPa\"\nn = \"=" +
         step +
         ".links.rod.omega\"\npv_adm = \"15 MPa*m/s\"\naccept.eye_wall = \"drawing\"\naccept.fork_wall = "
         "\"drawing\"\n";
}

std::string bending(const std::string& F) { return mode_of(solved_as_found(press + pin(F)), "pin", "bending"); }

std::string driven(const std::string& share, const std::string& positions) {
  return "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\nl = \"200 "
         "mm\"\ncrank "
         "= { speed = \"60 rpm\", positions = " +
         positions + " }\nlinks.rod.mass = \"1 kg\"\nlinks.slider.mass = \"2 kg\"\ncourses.k = { share_of_phi = \"" +
         share +
         "\" }\n[[press.loads]]\nname = \"f\"\nlink = \"slider\"\nat = \"B\"\nF_x = \"-50 kN\"\nF_y = \"0 N\"\ncourse "
         "= "
         "\"k\"\n";
}

}  // namespace

TEST_SUITE("found cycle") {
  TEST_CASE("R1, R5: a load takes its series, or its peak") {
    for (const char* all : {"press.joints.B.F", "-(-press.joints.B.F)", "1.1*press.joints.B.F",
                            "peak(press.joints.B.F)", "max(press.joints.B.F)",
                            "sqrt(press.joints.B.x^2 + press.joints.B.y^2)", "1.2*peak(press.joints.B.F) + 2 kN"})
      CHECK_MESSAGE(bending(all) == "pass", all);
  }

  TEST_CASE("R1, R5: and no lower value, however it is combined") {
    for (const char* less :
         {"mean(press.joints.B.F)", "min(press.joints.B.F)", "rms(press.joints.B.F)", "at(press.joints.B.F, 90 deg)",
          "amplitude(press.joints.B.F)", "range(press.joints.B.F)", "max(press.joints.B.y)", "2*mean(press.joints.B.F)",
          "sqrt(mean(press.joints.B.F)^2)", "peak(press.joints.B.F) - 70 kN", "min(press.joints.B.F, 5 kN)",
          "max(mean(press.joints.B.F), 1 kN)", "abs(at(press.joints.B.F, 90 deg))", "mean(press.drive.M)/(40 mm)",
          "(max(press.joints.B.F) + min(press.joints.B.F))/8"})
      CHECK_MESSAGE(bending(less) == "not-judged", less);
  }

  TEST_CASE("R1: nor through a shared value, nor through another step") {
    const std::string shared = "[values]\nF = \"=mean(press.joints.B.F)\"\n";
    CHECK(mode_of(solved_as_found(shared + press + pin("values.F")), "pin", "bending") == "not-judged");
  }

  TEST_CASE("R1: the allowable speed of a chain is not the speed of a part over its cycle") {
    const auto limit = [](const std::string& v_max) {
      return mode_of(solved_as_found(press +
                                     "[chain]\ncalculator = \"chain.inverted_tooth\"\np = \"12.7 mm\"\nb = \"50 "
                                     "mm\"\nz_1 = 25\nz_2 = 75\nn_1 = \"1000 rpm\"\nP = \"15 kW\"\nK_A = 1.4\na = "
                                     "\"500 mm\"\nP_b = \"5 kW\"\nq = \"2.5 kg/m\"\nF_u = \"54 kN\"\nS_min = 8\n"
                                     "v_max = \"" +
                                     v_max + "\"\n"),
                     "chain", "speed");
    };
    CHECK(limit("25 m/s") == "pass");
    CHECK(limit("=25 m/s + min(press.points.B.v_x)") == "pass");
    CHECK(limit("=5 m/s + min(press.points.B.v_x)") == "not-covered");
  }

  TEST_CASE("R3: one extreme of a stress is not a cycle; both are") {
    const auto cycle = [](const std::string& stresses) {
      return mode_of(solved_as_found(press + "[c]\ncalculator = \"fatigue.cycle\"\n" + stresses +
                                     "\nsigma_D = \"120 MPa\"\nS_D = 1.5\nR_e = \"355 MPa\"\nS_F = 2\n"),
                     "c", "yield");
    };
    CHECK(cycle("sigma_max = \"=max(press.links.rod.N)/(10000 mm^2)\"\nr = -1") == "not-judged");
    CHECK(cycle("sigma_max = \"=max(press.links.rod.N)/(10000 mm^2)\"\nsigma_min = "
                "\"=min(press.links.rod.N)/(10000 mm^2)\"") == "pass");
  }

  TEST_CASE("T1: waves that vanish at every position are seen") {
    const auto project = solved_as_found(driven("sin(180*phi)", "360"));
    CHECK(mode_of(project, "press", "resolution") == "pass");
    const Value* const F = project.steps[0]->value("joints.B.F");
    REQUIRE(F != nullptr);
    CHECK(std::abs(largest(*F).value) > 45e3);
  }

  TEST_CASE("T1: a wave that would need too many positions is not assessed") {
    CHECK(mode_of(solved_as_found(driven("sin(40001*phi)", "36")), "press", "resolution") == "not-judged");
  }

  TEST_CASE("T5: a pulse between positions that are far apart still has its impulse") {
    const ExampleStep blow("dynamics.impulse",
                           "m = \"1 kg\"\nF_x = \"5000 N*exp(-((t-0.4321 s)/(0.00005 s))^2)\"\nt_2 = \"1 s\"");
    CHECK(std::abs(blow("I_x") - 0.443113) < 1e-5);  // F w sqrt(pi)
  }
}
