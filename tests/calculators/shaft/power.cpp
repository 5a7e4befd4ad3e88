// A shaft whose torque follows from power and speed, and one with only a twist requirement.
#include "calculators/catalogue.hpp"
#include "lib/account/mode.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using namespace loadpath;

project::Project solved(const std::string& lines, std::vector<Issue>& issues) {
  project::Project p = project::read_project("[s]\n" + lines, "case.toml", catalogue(), issues);
  if (!has_errors(issues)) project::solve(p, issues);
  return p;
}

std::string complaints(const std::string& lines) {
  std::vector<Issue> issues;
  static_cast<void>(solved(lines, issues));
  std::string all;
  for (const Issue& issue : issues) all += issue.message.text() + "\n";
  return all;
}

double number(const std::string& lines, const std::string& path) {
  std::vector<Issue> issues;
  const project::Project p = solved(lines, issues);
  REQUIRE_FALSE(has_errors(issues));
  const Value* const value = p.value(path);
  return value == nullptr ? NAN : value->si[0];
}

const std::string torsion = "calculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\n";
const std::string overhung = "calculator = \"shaft.overhung\"\nF = \"2 kN\"\na = \"60 mm\"\nsigma_adm = \"60 MPa\"\n";
const std::string drive = "P = \"5.5 kW\"\nn = \"1450 rpm\"\n";

}  // namespace

TEST_SUITE("shaft power") {
  // T = 9549 P/n = 9549.3*5.5/1450 = 36.22 N*m; d = (16 T/(pi tau))^(1/3) = (16*36222/(pi*30))^(1/3) = 18.32 mm.
  TEST_CASE("power and speed replace the torque") {
    CHECK(number(torsion + drive, "s.M_max") == doctest::Approx(36.22).epsilon(1e-4));
    CHECK(number(torsion + drive, "s.d_strength") == doctest::Approx(0.01832).epsilon(1e-3));
    CHECK(number(torsion + drive + "K_A = 1.5\n", "s.M_max") == doctest::Approx(54.33).epsilon(1e-3));
    CHECK(number(overhung + drive, "s.M_t") == doctest::Approx(36.22).epsilon(1e-4));
    CHECK(number(overhung + drive + "K_A = 1.5\n", "s.M_t") == doctest::Approx(54.33).epsilon(1e-3));
  }

  TEST_CASE("the calculation shows the torque of the power") {
    for (const std::string& step : {torsion, overhung}) {
      std::vector<Issue> issues;
      const project::Project p = solved(step + drive, issues);
      const auto& lines = p.find("s")->account().derivation;
      const auto found = std::find_if(lines.begin(), lines.end(), [](const auto& line) {
        return line.step.why.text() == "torque of the power at this speed, P/(2 pi n)";
      });
      REQUIRE(found != lines.end());
      CHECK(found->step.symbol == "T");
    }
  }

  TEST_CASE("torque and power together, and only one of power and speed, are refused with the fix") {
    for (const std::string& step : {torsion, overhung}) {
      CHECK(complaints(step + drive + "T = \"30 N*m\"\n").find("give T, or P with n") != std::string::npos);
      CHECK(complaints(step + "P = \"5.5 kW\"\n")
                .find("the power P requires the speed n, and vice versa: T = P/(2 pi n)") != std::string::npos);
      CHECK(complaints(step + "T = \"30 N*m\"\nn = \"1450 rpm\"\n").find("requires the speed n") != std::string::npos);
      CHECK(complaints(step).find("give the torque T, or the power P with the speed n") != std::string::npos);
      CHECK(complaints(step + drive).empty());
    }
  }

  // phi = 32 T l/(pi G d^4) = 32*100*1/(pi*80e9*0.03^4) = 0.015719 rad.
  TEST_CASE("the twist needs no allowable stress; missing input for yielding is named") {
    const std::string twist =
        "calculator = \"shaft.torsion\"\nT = \"100 N*m\"\nd = \"30 mm\"\nl = \"1 m\"\nG = \"80 GPa\"\n";
    CHECK(number(twist, "s.phi") == doctest::Approx(0.015719).epsilon(1e-4));
    std::vector<Issue> issues;
    const account::Modes modes = project::modes(solved(twist, issues));
    CHECK(issues.empty());
    const auto yield = std::find_if(modes.begin(), modes.end(), [](const auto& mode) { return mode.id == "yield"; });
    REQUIRE(yield != modes.end());
    CHECK(yield->state == account::State::not_judged);
    CHECK(account::reason(*yield).text() == "give tau_adm, or S with the yield strength R_e (or a material)");
    CHECK(complaints("calculator = \"shaft.torsion\"\nT = \"100 N*m\"\nl = \"1 m\"\nG = \"80 GPa\"\n")
              .find("give tau_adm, or S with the yield strength R_e") != std::string::npos);
  }
}
