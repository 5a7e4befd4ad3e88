#include "lib/project/step.hpp"
#include "tests/calculators/step_text.hpp"
#include "tests/lib/project/texts.hpp"

#include <algorithm>
#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string bar = R"says([bar]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "60 rpm", positions = 8 }
[bar.ground]
O = ["0 mm", "0 mm"]
[bar.links.crank]
points = { O = ["0 mm", "0 mm"], A = ["50 mm", "0 mm"] }
angle = "0 deg"
[bar.joints.O]
type = "revolute"
links = ["ground", "crank"]
[[bar.loads]]
name = "weight"
link = "crank"
at = "A"
F_x = "0 N"
F_y = "-100 N"
)says";  // 17 lines

std::string other_bar() {
  std::string text = bar;
  for (std::size_t at = 0; (at = text.find("bar", at)) != std::string::npos; at += 3) text.replace(at, 3, "rod");
  return text;
}

const account::Verdict& verdict(const project::Project& project, const std::string& step, const std::string& symbol) {
  const auto& all = project.find(step)->account().verdicts;
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& v) { return v.symbol == symbol; });
  REQUIRE(found != all.end());
  return *found;
}

}  // namespace

TEST_SUITE("project steps") {
  TEST_CASE("a step that does not exist is reported with the nearest one, or with all") {
    const std::string source = "[crank]\ncalculator = \"shaft.torsion\"\nT = \"9 N*m\"\ntau_adm = \"30 MPa\"\n";
    CHECK(issues_of(source + axle + "T = \"=crnak.M_max\"\ntau_adm = \"30 MPa\"\n") ==
          R"says(a.toml:7:7: error: unknown step 'crnak'
7 | T = "=crnak.M_max"
  |       ^^^^^^^^^^^
  = help: did you mean 'crank.M_max'?
)says");
    CHECK(issues_of(source + axle + "T = \"=2 * lever.drive.M\"\ntau_adm = \"30 MPa\"\n") ==
          R"says(a.toml:7:11: error: unknown step 'lever'
7 | T = "=2 * lever.drive.M"
  |           ^^^^^^^^^^^^^
  = help: available: crank, axle
)says");
  }

  TEST_CASE("a result that does not exist is reported with the nearest one") {
    CHECK(issues_of(bar + axle + "T = \"=peak(bar.drive.N)\"\ntau_adm = \"30 MPa\"\n") ==
          R"says(a.toml:20:12: error: 'bar' has no result 'drive.N'
20 | T = "=peak(bar.drive.N)"
   |            ^^^^^^^^^^^
   = help: did you mean 'bar.drive.M'?
)says");
    const std::string source = "[a]\ncalculator = \"shaft.torsion\"\nT = \"9 N*m\"\ntau_adm = \"30 MPa\"\n";
    CHECK(issues_of(source + axle + "T = \"=a.segments[1].M_y\"\ntau_adm = \"30 MPa\"\n") ==
          R"says(a.toml:7:7: error: 'a' has no result 'segments[1].M_y'
7 | T = "=a.segments[1].M_y"
  |       ^^^^^^^^^^^^^^^^^
  = help: did you mean 'a.segments[1].M_t'?
)says");
  }

  TEST_CASE("an element of a result list is suggested by its name") {
    const auto said = [](const std::string& load) {
      return issues_of(
          "[shaft]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\n"
          "pieces = [{ l = \"200 mm\", d = \"40 mm\" }]\n"
          "supports = [{ name = \"left\", x = \"10 mm\" }, { name = \"right\", x = \"190 mm\" }]\n"
          "seats = [{ name = \"wheel\", x = \"100 mm\", F_y = \"3 kN\" }]\n"
          "[ball]\ncalculator = \"bearing.rolling\"\nbearing = \"6208\"\nL_h = \"20000 h\"\nload = \"" +
          load + "\"\n");
    };
    CHECK(said("=shaft.bearing.left").find("help: did you mean 'shaft.bearings.left'?") != std::string::npos);
    CHECK(said("=shaft.left").find("help: did you mean 'shaft.bearings.left'?") != std::string::npos);
    const std::string supports = said("=shaft.supports.left");
    CHECK(supports.find("help: did you mean '=shaft.bearings.left'?") != std::string::npos);
    CHECK(supports.find("standstill") == std::string::npos);
  }

  TEST_CASE("misspelt values and tables are not steps") {
    const auto said = [](const std::string& T) {
      return issues_of("[values]\nT = \"9 N*m\"\n" + axle + "T = \"" + T + "\"\ntau_adm = \"30 MPa\"\n");
    };
    CHECK(said("=2*value.T").find("help: did you mean 'values.T'?") != std::string::npos);
    CHECK(said("=1 mm^3*materials.C45E.E").find("help: did you mean 'tables.materials.C45E.E'?") != std::string::npos);
  }

  TEST_CASE("an expression of another dimension is refused when the file is read") {
    CHECK(issues_of(bar + axle + "T = \"=peak(bar.joints.O.F)\"\ntau_adm = \"30 MPa\"\n") ==
          R"says(a.toml:20:7: error: 'T' is a moment, but this expression is a force
20 | T = "=peak(bar.joints.O.F)"
   |       ^^^^^^^^^^^^^^^^^^^^
)says");
  }

  TEST_CASE("power is moment times angular velocity, whatever the angle") {
    const auto project = solved(axle + "T = \"=6 kW / (60 rpm)\"\ntau_adm = \"30 MPa\"\n");
    CHECK(value(project, "axle.M_max") == doctest::Approx(6000.0 / (2.0 * std::acos(-1.0))));
  }

  TEST_CASE("a power over a frequency is the energy of a cycle and not a moment") {
    const std::string strength = "tau_adm = \"30 MPa\"\n";
    CHECK(issues_of(axle + "T = \"=1.4*5.5 kW/(2 Hz)\"\n" + strength) ==
          R"says(a.toml:3:7: error: 'T' is a moment, but this expression is an energy
3 | T = "=1.4*5.5 kW/(2 Hz)"
  |       ^^^^^^^^^^^^^^^^^
  = help: a power over a frequency is the energy of one cycle: divide by a speed in rpm or rad/s, or by rev*f; an energy by its angle
)says");
    const auto is_refused = [&](const std::string& t, const std::string& values) {
      const std::string all = values.empty() ? "" : "[values]\n" + values;
      return issues_of(all + axle + "T = \"=" + t + "\"\n" + strength).find("the energy of one cycle") !=
             std::string::npos;
    };
    CHECK(is_refused("values.P/values.f", "P = \"5.5 kW\"\nf = \"2 Hz\"\n"));
    CHECK(is_refused("values.T", "T = \"=5.5 kW/(2 Hz)\"\n"));
    CHECK(is_refused("5.5 kW/(12.6 1/s)", ""));  // in radians or in revolutions
    CHECK_FALSE(is_refused("5.5 kW/(2*pi*2 Hz)", ""));
    CHECK_FALSE(is_refused("5.5 kW/(rev*2 Hz)", ""));
    CHECK_FALSE(is_refused("5.5 kW/(2 Hz)/(2*pi)", ""));
    CHECK_FALSE(is_refused("5.5 kW/(2 Hz*(6.2832 rad))", ""));
    CHECK_FALSE(is_refused("2 N*m*(5 kW/(4 kW))*(2 Hz/(3 Hz))", ""));
    const auto project = solved(axle + "T = \"=6 kW / (2*pi*1 Hz)\"\n" + strength);
    CHECK(value(project, "axle.M_max") == doctest::Approx(6000.0 / (2.0 * std::acos(-1.0))));
  }

  TEST_CASE("a faulty expression is reported at its character") {
    CHECK(issues_of(axle + "T = \"= 3 N*m + \"\ntau_adm = \"30 MPa\"\n") ==
          R"says(a.toml:3:15: error: a value is missing at the end
3 | T = "= 3 N*m + "
  |               ^
  = help: write a number, a reference such as lever.drive.M, or a function
)says");
  }

  TEST_CASE("a step that takes one value refuses a series") {
    const std::string text = bar + other_bar();
    const std::string fed =
        text.substr(0, text.rfind("\"0 N\"")) + "\"=bar.joints.O.F\"" + text.substr(text.rfind("\"0 N\"") + 5);
    CHECK(issues_of(fed) ==
          R"says(a.toml:33:9: error: 'loads.weight.F_x' takes one value, and this is a series over bar: crank angle
33 | F_x = "=bar.joints.O.F"
   |         ^^^^^^^^^^^^^^
   = help: reduce it with peak, max, min, mean, rms or at
)says");
  }

  TEST_CASE("series over different cycles cannot be combined, neither in an expression nor in a step") {
    const std::string pin = "[pin]\ncalculator = \"shaft.overhung\"\na = \"50 mm\"\nsigma_adm = \"60 MPa\"\n";
    CHECK(
        issues_of(bar + other_bar() + pin + "F = \"=bar.joints.O.F\"\nT = \"=rod.drive.M\"\n") ==
        R"says(a.toml:40:7: error: this is a series over rod: crank angle, and another input is one over bar: crank angle
40 | T = "=rod.drive.M"
   |       ^^^^^^^^^^^
   = help: reduce one of them with peak, max, min, mean, rms or at
)says");
    const std::string said = issues_of(bar + other_bar() + pin + "F = \"1 N\"\nT = \"=bar.drive.M + rod.drive.M\"\n");
    INFO(said);
    CHECK(said.find("a.toml:40:") == 0);
    CHECK(said.find("bar: crank angle") != std::string::npos);
    CHECK(said.find("rod: crank angle") != std::string::npos);
  }

  TEST_CASE("a computed value out of bounds is reported at its expression") {
    CHECK(issues_of(bar + axle + "T = \"=bar.drive.M\"\ntau_adm = \"=(peak(bar.drive.M) - 1 kN*m) / (1 m^3)\"\n") ==
          R"says(a.toml:21:13: error: tau_adm = -0.000995 MPa: must be > 0 MPa
21 | tau_adm = "=(peak(bar.drive.M) - 1 kN*m) / (1 m^3)"
   |             ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
)says");
  }

  TEST_CASE("a rule that computed values break is reported at the field") {
    CHECK(issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\nd = \"=2 * 10 mm\"\nd_bore = \"=3 * 10 mm\"\n") ==
          R"says(a.toml:6:11: error: the bore must be smaller than the outer diameter of the shaft
6 | d_bore = "=3 * 10 mm"
  |           ^^^^^^^^^^
)says");
  }

  TEST_CASE("a step with a series as input gives series, and its check is the worst of them") {
    const auto project = solved(
        bar + "[axle]\ncalculator = \"shaft.torsion\"\nT = \"=bar.drive.M\"\ntau_adm = \"30 MPa\"\nd = \"20 mm\"\n");
    const Value* tau = project.value("axle.tau_max");
    REQUIRE(tau != nullptr);
    CHECK(tau->si.size() == 8);
    CHECK(tau->signature.axis == project.value("bar.drive.M")->signature.axis);
    const double largest = *std::max_element(tau->si.begin(), tau->si.end());
    CHECK(*verdict(project, "axle", "u_tau").utilisation == doctest::Approx(largest / 30e6));
  }

  TEST_CASE("a division by zero is not available, with the input that it comes from") {
    const auto project = told(axle + no_torque + "tau_adm = \"30 MPa\"\n" + relay).project;
    const account::Verdict& v = verdict(project, "axle", "u_tau");
    CHECK(v.state == account::State::not_available);
    CHECK(v.note.text() == "'T' is not available: = 1 N*m/(0*relay.u_tau)");
    CHECK(account::worst(project::verdicts(project)) == account::State::not_available);
  }

  TEST_CASE("extreme numbers give a verdict, never a pass") {
    const auto project = told(axle + "T = \"=1e29 N*m\"\nK_A = \"=1e29\"\ntau_adm = \"30 MPa\"\n").project;
    CHECK(verdict(project, "axle", "u_tau").state != account::State::pass);
  }

  TEST_CASE("inputs state their origin, elements with names too") {
    const auto project = solved(bar);
    for (const account::Entry& e : project.find("bar")->account().inputs) {
      if (e.path == "loads.weight.F_y") CHECK(e.origin.text.text() == "given");
      if (e.path == "gravity") CHECK(e.origin.text.text() == "default");
    }
  }

  TEST_CASE("the moment of a drive comes with the force of its joint") {
    const auto project = told(bar + axle + "T = \"=peak(bar.drive.M)\"\ntau_adm = \"30 MPa\"\n").project;
    const account::Verdict& bending = verdict(project, "axle", "F_bend");
    CHECK(bending.state == account::State::not_covered);
    CHECK(std::get<account::Quantity>(bending.value).si == doctest::Approx(100.0));
  }

  TEST_CASE("an input common to all loads takes no series of them") {
    const std::string press =
        "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"40 mm\"\nl = \"150 mm\"\n"
        "crank = { speed = \"60 rpm\", positions = 12 }\nlinks.slider.mass = \"5 kg\"\n";
    struct Row {
      const char *id, *key, *load;
    };
    for (const Row& row : {Row{"belt.flat", "P", "drive.P"}, Row{"belt.v", "P", "drive.P"},
                           Row{"belt.v_sizing", "P", "drive.P"}, Row{"belt.synchronous", "P", "drive.P"},
                           Row{"belt.course", "S_0", "links.rod.N"}, Row{"column.lightest", "P", "links.rod.N"}}) {
      CAPTURE(row.id);
      const Calculator* const calculator = find_calculator(calculators(), row.id);
      REQUIRE(calculator != nullptr);
      CHECK(first_error(with(calculator->example, row.key, std::string("\"=press.") + row.load + "\"") + press) ==
            std::string("'") + row.key + "' takes one value, and this is a series over press: crank angle");
    }
  }

  TEST_CASE("a named element is also found by its number") {
    const ExampleStep course("belt.course", "");
    for (const auto& [number, name] : {std::pair{"[1]", "motor"}, {"[3]", "pump"}, {"[4]", "fan"}}) {
      const double by_name = course(std::string("pulleys.") + name + ".alpha");
      CHECK(course(std::string("pulleys") + number + ".alpha") == by_name);
    }
    CHECK(course.project().value("common_belt.pulleys[5].alpha") == nullptr);
  }
}
