// Regression tests of mechanisms and of what takes their loads: faults found in use.
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/cli/process.hpp"
#include "tests/found/modes.hpp"
#include "tests/lib/project/texts.hpp"

#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// A slider-crank of r = 50 mm whose rod is all but as long: near its dead points forces rise within a degree.
std::string tight(int positions) {
  return "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\nl = \"50.01 mm\"\n"
         "crank = { speed = \"60 rpm\", positions = " +
         std::to_string(positions) +
         " }\n[[press.loads]]\nlink = \"slider\"\nat = \"B\"\nF_x = \"-1 kN\"\nF_y = \"0 N\"\n";
}

/// A four-bar drawn far from the origin; its coupler has a mass.
std::string drawn(const std::string& coupler) {
  return R"toml([bar]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "60 rpm", positions = 36 }
gravity = "9.81 m/s^2"
[bar.ground]
O = ["500 mm", "300 mm"]
C = ["900 mm", "300 mm"]
[bar.links.crank]
points = { O = ["500 mm", "300 mm"], A = ["500 mm", "400 mm"] }
[bar.links.coupler]
points = { A = ["500 mm", "400 mm"], B = ["850 mm", "580 mm"], S = ["675 mm", "490 mm"] }
)toml" + coupler +
         R"toml([bar.links.rocker]
points = { C = ["900 mm", "300 mm"], B = ["850 mm", "580 mm"] }
[bar.joints]
O = { type = "revolute", links = ["ground", "crank"] }
A = { type = "revolute", links = ["crank", "coupler"] }
B = { type = "revolute", links = ["coupler", "rocker"] }
C = { type = "revolute", links = ["rocker", "ground"] }
)toml";
}

/// A crank of 50 mm at 35 deg moves a wheel that rolls on a line, by a rod of 200 mm that is stated at this angle.
std::string rolling(const std::string& rod) {
  return R"toml([roll]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "60 rpm", at = [["35 deg"]] }
ground = { O = ["0 mm", "0 mm"], L = ["0 mm", "-30 mm"] }
links.crank = { points = { O = ["0 mm", "0 mm"], A = ["50 mm", "0 mm"] }, angle = "35 deg" }
links.wheel = { points = { B = ["0 mm", "0 mm"] }, angle = "0 deg" }
joints.O = { type = "revolute", links = ["ground", "crank"] }
joints.A = { type = "revolute", links = ["crank", "rod"] }
joints.B = { type = "revolute", links = ["rod", "wheel"] }
joints.track = { type = "rolling_on_line", links = ["wheel", "ground"], points = ["B", "L"], radius = "30 mm" }
links.rod = { points = { A = ["0 mm", "0 mm"], B = ["200 mm", "0 mm"] }, angle = ")toml" +
         rod + "\" }\n";
}

/// A beam of 2 m, welded to the ground, with 1 kN at its tip.
std::string welded(const std::string& mass) {
  return R"toml([stand]
calculator = "mechanism.planar"
gravity = "9.81 m/s^2"
ground = { A = ["0 mm", "0 mm"] }
joints.A = { type = "rigid", links = ["ground", "beam"] }
loads = [{ link = "beam", at = "T", F_x = "0 N", F_y = "-1 kN" }]
[stand.links.beam]
points = { A = ["0 mm", "0 mm"], S = ["1 m", "0 mm"], T = ["2 m", "0 mm"] }
angle = "0 deg"
)toml" + mass +
         "\n";
}

/// A crank of 30 mm and a row of rockers of 100 mm, each moved by the one before over a coupler of 300 mm.
std::string chain(int dyads) {
  std::string ground = "O = [\"0 mm\", \"100 mm\"]", links, joints;
  std::string before = "crank", pin = "A", place = "[\"0 mm\", \"130 mm\"]";
  for (int k = 1; k <= dyads; ++k) {
    const std::string n = std::to_string(k), x = std::to_string(300 * k), top = "[\"" + x + " mm\", \"100 mm\"]";
    const std::string foot = "C" + n + " = [\"" + x + " mm\", \"0 mm\"]";
    ground += ", " + foot;
    links += "links.coupler" + n + " = { points = { " + pin + " = " + place + ", B" + n + " = " + top + " } }\n";
    links += "links.rocker" + n + " = { points = { " + foot + ", B" + n + " = " + top + " } }\n";
    joints += "joints.P" + n + " = { type = \"revolute\", links = [\"" + before + "\", \"coupler" + n +
              "\"], points = [\"" + pin + "\", \"" + pin + "\"] }\n";
    joints += "joints.B" + n + " = { type = \"revolute\", links = [\"coupler" + n + "\", \"rocker" + n + "\"] }\n";
    joints += "joints.C" + n + " = { type = \"revolute\", links = [\"ground\", \"rocker" + n + "\"] }\n";
    before = "rocker" + n, pin = "B" + n, place = top;
  }
  return "[chain]\ncalculator = \"mechanism.planar\"\ncrank = { joint = \"O\", speed = \"60 rpm\", positions = 12 }\n"
         "ground = { " +
         ground + " }\nlinks.crank = { points = { O = [\"0 mm\", \"100 mm\"], A = [\"0 mm\", \"130 mm\"] } }\n" +
         links + "joints.O = { type = \"revolute\", links = [\"ground\", \"crank\"] }\n" + joints +
         "loads = [{ link = \"" + before + "\", at = \"" + pin + "\", F_x = \"-100 N\", F_y = \"0 N\" }]\n";
}

double number_of(const project::Project& project, const std::string& path) {
  const Value* const value = project.steps[0]->value(path);
  REQUIRE(value != nullptr);
  return value->si[0];
}

std::string messages_of(const std::string& text) {
  std::vector<Issue> issues;
  project::Project project = project::read_project(text, "part.toml", catalogue(), issues);
  if (!has_errors(issues)) project::solve(project, issues);
  std::string all;
  for (const Issue& issue : issues) all += issue.message.text() + "\n";
  return all;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_SUITE("found mechanism") {
  TEST_CASE("A27: 77 positions miss the peak near the dead point, and this is reported") {
    CHECK(mode_of(solved_as_found(tight(77)), "press", "resolution") == "not-covered");
    CHECK(mode_of(solved_as_found(tight(7200)), "press", "resolution") != "not-covered");
  }

  TEST_CASE("a punch that strikes between two positions: the peak of the drive is not missed") {
    const auto punched = [](const std::string& positions) {
      return solved_as_found(
          "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"40 mm\"\nl = \"300 "
          "mm\"\ncrank = { speed "
          "= \"120 rpm\", positions = " +
          positions +
          " }\nloads = [{ name = \"punch\", link = \"slider\", at = \"B\", F_x = \"-60 kN\", F_y = \"0 N\", over = "
          "[[\"0 deg\", 0], "
          "[\"318 deg\", 0], [\"322 deg\", 1], [\"358 deg\", 1], [\"360 deg\", 0]] }]\n");
    };
    CHECK(mode_of(punched("36"), "press", "resolution") == "pass");  // positions lie at the impact
    CHECK(mode_of(punched("180"), "press", "resolution") == "pass");
  }

  TEST_CASE("A31: the mass of a drawn link is that of the bar it draws, or its centre and inertia are given") {
    const double length = std::hypot(0.35, 0.18), J = 2.0 * length * length / 12.0;
    const auto bar = solved_as_found(drawn("mass = \"2 kg\"\n"));
    CHECK(number_of(bar, "links.coupler.J") == doctest::Approx(J).epsilon(1e-12));
    const auto given = solved_as_found(drawn("mass = \"2 kg\"\nS = \"S\"\nJ = \"" + std::to_string(J) + " kg*m^2\"\n"));
    CHECK(number_of(bar, "drive.M") == doctest::Approx(number_of(given, "drive.M")).epsilon(1e-5));
    CHECK(contains(messages_of(drawn("mass = \"2 kg\"\nS = \"S\"\n")), "'links.coupler.J' is missing"));
    CHECK(messages_of(drawn("")).empty());
    const std::string shaft =
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"200 N*m\"\nd = \"40 mm\"\ntau_adm = \"30 MPa\"\n";
    const auto later = solved_as_found(drawn("mass = \"=2 kg*shaft.u_tau/shaft.u_tau\"\n") + shaft);
    CHECK(number_of(later, "drive.M") == doctest::Approx(number_of(bar, "drive.M")).epsilon(1e-12));
  }

  TEST_CASE("B5: a rolling wheel has its stated position, however rough the rod that carries it") {
    for (const char* rod : {"-8.244296645 deg", "-10 deg", "-20 deg"}) {
      CAPTURE(rod);
      CHECK(std::abs(number_of(solved_as_found(rolling(rod)), "links.wheel.phi")) < 1e-9);
    }
  }

  TEST_CASE("B6: a welded beam has its couple, and inner forces from its one joint on") {
    const auto beam = solved_as_found(welded("mass = \"0 kg\""));
    CHECK(number_of(beam, "joints.A.M") == doctest::Approx(2000.0));  // 1 kN at 2 m: [D3], table 10.1
    CHECK(std::abs(number_of(beam, "links.beam.M_b")) == doctest::Approx(2000.0));
    CHECK(std::abs(number_of(beam, "links.beam.V")) == doctest::Approx(1000.0));
    CHECK(number_of(beam, "links.beam.length") == doctest::Approx(2.0));
    const auto heavy = solved_as_found(welded("mass = \"50 kg\"\nJ = \"17 kg*m^2\"\nS = \"S\""));
    CHECK(number_of(heavy, "joints.A.M") == doctest::Approx(2000.0 + 50.0 * 9.81 * 1.0));
  }

  TEST_CASE("B7: chains of many dyads and diagrams of many points are solved without errors") {
    for (const int dyads : {14, 60}) CHECK(messages_of(chain(dyads)).empty());
    std::string shares;
    for (int k = 0; k < 72; ++k) shares += (k == 0 ? "[\"" : ", [\"") + std::to_string(5 * k) + " deg\", 1]";
    CHECK(messages_of(replaced(tight(72), "F_y = \"0 N\"\n", "F_y = \"0 N\"\nover = [" + shares + "]\n")).empty());
  }

  TEST_CASE("C7: a rotor needs only its J, gravity is a magnitude") {
    const std::string rotor =
        replaced(tight(36), "[[press.loads]]", "[press.links.crank]\nJ = \"0.1 kg*m^2\"\n[[press.loads]]");
    CHECK(messages_of(rotor).empty());
    CHECK(contains(messages_of(replaced(rotor, "links.crank", "links.rod")),
                   "is not on a fixed pin and has a moment of inertia"));
    CHECK(contains(messages_of(replaced(tight(36), "crank =", "gravity = \"-9.81 m/s^2\"\ncrank =")),
                   "gravity = -9.81 m/s²: must be"));
  }

  TEST_CASE("A29: a stock with an unused bound, a scatter of another dimension, a tolerance above 100 %") {
    const std::string axle = "[axle]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\n";
    CHECK(contains(messages_of(axle + "T = \"1 N*m\"\nd = { stock = \"R20\", max = \"50 mm\" }\n"),
                   "'max' is not a valid key here"));
    CHECK(contains(messages_of(axle + "T = { mean = \"1 N*m\", sd = \"100 kg\" }\n"),
                   "'sd' must be a moment: it is the difference of two values"));
    CHECK(contains(messages_of(axle + "T = \"1 N*m\"\n[[expect]]\nvalue = \"axle.d\"\nis = \"1 mm\"\nwithin = \"10000 "
                                      "%\"\nsource = \"x\"\n"),
                   "within must be < 100 %"));
    CHECK(loadpath_with({"convert", "-300 °C", "K"}).code == 2);
    CHECK(loadpath_with({"convert", "-273.15 °C", "K"}).code == 0);
  }

  TEST_CASE("B1: every template is described") {
    for (const char* name : {"cam_follower", "cam_arm", "cam_flat_follower", "slider_crank"}) {
      CAPTURE(name);
      CHECK(loadpath_with({"describe", std::string("mechanism.planar.") + name}).code == 0);
    }
  }

  TEST_CASE("C2: a step may have the name of its element") {
    for (const char* name : {"shaft", "gear", "belt", "column", "sweep", "why"}) {
      CAPTURE(name);
      CHECK(messages_of(std::string("[") + name +
                        "]\ncalculator = \"shaft.torsion\"\nT = \"1 N*m\"\ntau_adm = \"30 MPa\"\n")
                .empty());
    }
    CHECK(contains(messages_of("[values]\ncalculator = \"shaft.torsion\"\nT = \"1 N*m\"\ntau_adm = \"30 MPa\"\n"),
                   "cannot name a step"));
  }
}
