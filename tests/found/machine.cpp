// Regression tests of flywheels and runs: faults found in use.
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/found/modes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string waves(int count) {
  return "M_of_phi = \"20 kN*m + 9 kN*m*sin(" + std::to_string(count) + "*phi)\"\ndelta = 0.01";
}

double relative(double value, double expected) { return std::abs(value / expected - 1.0); }

}  // namespace

TEST_SUITE("found machine") {
  TEST_CASE("A28: short waves are followed until their energy settles, or refused") {
    for (const int count : {1, 2, 7, 45, 180, 360, 720}) {
      CAPTURE(count);
      const ExampleStep wheel("machine.flywheel", waves(count));
      if (!wheel.fault().empty()) continue;
      CHECK(relative(wheel("Delta_E"), 2.0 * 9000.0 / count) < 1e-5);
    }
    CHECK(ExampleStep("machine.flywheel", waves(180)).fault().empty());
    CHECK_FALSE(ExampleStep("machine.flywheel", waves(1440)).fault().empty());
    CHECK_FALSE(ExampleStep("machine.flywheel", waves(5000)).fault().empty());
  }

  TEST_CASE("A28: the largest moment lies between the samples") {
    const ExampleStep wheel("machine.flywheel", "M_of_phi = \"20 kN*m + 9 kN*m*sin(180*phi + 10 deg)\"\ndelta = 0.01");
    CHECK(relative(wheel("M_peak"), 29e3) < 1e-6);
  }

  TEST_CASE("A28: a step of the formula at the end of its period is not a slope") {
    const double pi = std::numbers::pi;  // (phi - pi)^2/2 from pi to 2 pi, on either side of the mean
    const ExampleStep wheel("machine.flywheel", "M_of_phi = \"20 kN*m + 9 kN*m*phi/(180 deg)\"\ndelta = 0.01");
    CHECK(relative(wheel("Delta_E"), 9000.0 / pi * pi * pi / 2.0) < 1e-9);
  }

  TEST_CASE("A28: a formula that does not repeat in its period gives a warning") {
    const auto warned = [](const std::string& formula) {
      const ExampleStep wheel("machine.flywheel", "M_of_phi = \"" + formula + "\"\ndelta = 0.01");
      const auto& warnings = wheel.project().steps[0]->account().warnings;
      return std::any_of(warnings.begin(), warnings.end(),
                         [](const Message& m) { return m.text().find("does not repeat") != std::string::npos; });
    };
    const auto state = [](const std::string& lines) {
      return mode_with("machine.flywheel", lines + "\ndelta = 0.01", "period");
    };
    const std::string of_half =
        "M_of_phi = \"20 kN*m + 9 kN*m*sin(phi/2)\"";  // no leap at 360 deg, and the rest is lost
    CHECK(state(of_half) == "not-judged");
    CHECK(state(of_half + "\nperiod = \"720 deg\"") == "none");
    CHECK(state("M_of_phi = \"20 kN*m + 9 kN*m*sin(phi*2/3)^2\"\nperiod = \"540 deg\"") == "none");
    CHECK(state("M_of_phi = \"20 kN*m + 9 kN*m*sin(phi*4/3 - 60 deg)\"") == "not-judged");      // repeats after 270 deg
    CHECK(state("M_of_phi = \"20 kN*m + 9 kN*m*phi/(1 rad)*(1 - phi/(360 deg))\"") == "none");  // of one period
    CHECK(warned("20 kN*m + 9 kN*m*sin(phi/2)"));
    CHECK(warned("20 kN*m + 9 kN*m*phi/(180 deg)"));
    CHECK(warned("20 kN*m + 9 kN*m*cos(phi/2)"));
    CHECK_FALSE(warned("20 kN*m + 9 kN*m*cos(2*phi)"));
  }

  TEST_CASE("A28: an unevenness of 2 or more would reverse the wheel") {
    CHECK_FALSE(ExampleStep("machine.flywheel", "delta = 2").fault().empty());
    CHECK(ExampleStep("machine.flywheel", "delta = 0.1").fault().empty());
  }

  TEST_CASE("A28: the energy that the load takes while the run almost stalls") {
    // k omega^2/(M - k omega) over omega from 0 to 100 rad/s, k = 0.0999
    const ExampleStep fan("machine.run_up",
                          "parts = [{ J = \"1 kg*m^2\" }]\nmotor = [[\"0 rad/s\", \"10 N*m\"]]\n"
                          "load = [[\"0 rad/s\", \"0 N*m\"], [\"100 rad/s\", \"9.99 N*m\"]]\nn_2 = \"100 rad/s\"");
    const double a = 10.0 / 0.0999;
    CHECK(relative(fan("A_L"), -5000.0 - 100.0 * a - a * a * std::log1p(-100.0 / a)) < 1e-9);
  }

  TEST_CASE("flywheels and runs pass with their assessed modes") {
    CHECK(mode_with("machine.flywheel", "", "unevenness") == "pass");
    CHECK(mode_with("machine.flywheel", "", "bursting") == "open");
    CHECK(mode_with("machine.flywheel", "D = \"2 m\"", "bursting") == "not-judged");
    CHECK(mode_with("machine.flywheel", "D = \"2 m\"\nv_adm = \"30 m/s\"", "bursting") == "pass");
    CHECK(mode_with("machine.flywheel", "D = \"2 m\"\nv_adm = \"15 m/s\"", "bursting") == "fail");
    CHECK(mode_with("machine.flywheel", "P_n = \"300 kW\"", "motor") == "fail");
    CHECK(mode_with("machine.run_up", "", "stall") == "pass");
    CHECK(mode_with("machine.run_up", "", "time") == "open");
  }

  TEST_CASE("A14: a flywheel on a shaft 8.05 times as fast as the crank stores the same energy") {
    const std::string press =
        "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\nl = "
        "\"200 mm\"\ncrank = { speed = \"60 rpm\", positions = 360 }\n[[press.loads]]\nlink = "
        "\"slider\"\nat = \"B\"\nF_x = \"-1 kN\"\nF_y = \"0 N\"\n";
    const auto wheel = [&](const std::string& lines) {
      return press + "[wheel]\ncalculator = \"machine.flywheel\"\ndelta = 0.02\n" + lines;
    };
    const auto crank = solved_as_found(wheel("M = \"=press.drive.M\"\nomega = \"60 rpm\"\n"));
    const auto shaft = solved_as_found(wheel("M = \"=press.drive.M/8.05\"\nomega = \"483 rpm\"\nratio = 8.05\n"));
    REQUIRE(crank.value("wheel.J_F") != nullptr);
    REQUIRE(shaft.value("wheel.J_F") != nullptr);
    CHECK(relative(shaft.value("wheel.Delta_E")->si[0], crank.value("wheel.Delta_E")->si[0]) < 1e-9);
    CHECK(relative(shaft.value("wheel.J_F")->si[0], crank.value("wheel.J_F")->si[0] / (8.05 * 8.05)) < 1e-9);
    std::vector<Issue> issues;
    auto silent = project::read_project(wheel("M = \"=press.drive.M/8.05\"\nomega = \"483 rpm\"\n"), "a.toml",
                                        catalogue(), issues);
    REQUIRE(!has_errors(issues));
    project::solve(silent, issues);
    REQUIRE(has_errors(issues));
    CHECK(issues.back().message.text() ==
          "the moment runs over the turn of a crank at 60 rpm, and this shaft turns at 483 rpm");
    CHECK(issues.back().hint.text() == "give the ratio of the two, ratio = 8.05, with the moment on this shaft");
  }
}
