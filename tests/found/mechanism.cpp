// What must not pass again of mechanisms and of what takes their loads: rows of the list of what was found by use.
#include "tests/cli/process.hpp"
#include "tests/found/modes.hpp"

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
  TEST_CASE("A27: 77 positions miss the peak near the dead point, and say so") {
    CHECK(mode_of(solved_as_found(tight(77)), "press", "resolution") == "not-covered");
    CHECK(mode_of(solved_as_found(tight(7200)), "press", "resolution") != "not-covered");
  }

  TEST_CASE("A31: the mass of a drawn link lies nowhere until its centre is named") {
    CHECK(contains(messages_of(drawn("mass = \"2 kg\"\n")), "nothing says where its mass centre lies"));
    CHECK(messages_of(drawn("mass = \"2 kg\"\nS = \"S\"\n")).empty());
    CHECK(messages_of(drawn("")).empty());
  }

  TEST_CASE("A29: a stock with a bound that nobody reads, a spread of another kind, a tolerance of everything") {
    const std::string axle = "[axle]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\n";
    CHECK(contains(messages_of(axle + "T = \"1 N*m\"\nd = { stock = \"R20\", max = \"50 mm\" }\n"),
                   "'max' is no field here"));
    CHECK(contains(messages_of(axle + "T = { mean = \"1 N*m\", sd = \"100 kg\" }\n"), "'sd' is a spread of a moment"));
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

  TEST_CASE("C2: a step may be called what it is") {
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
