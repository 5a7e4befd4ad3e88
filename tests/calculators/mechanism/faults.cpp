// Faults of a mechanism are reported in the words of the project file, with the place.
#include "tests/lib/project/texts.hpp"

#include <algorithm>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string press = R"([press]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "60 rpm", positions = 12 }

[press.ground]
O = ["0 mm", "0 mm"]
B = ["0 mm", "0 mm"]

[press.links.crank]
points = { O = ["0 mm", "0 mm"], A = ["50 mm", "0 mm"] }
angle = "30 deg"

[press.links.rod]
points = { A = ["0 mm", "0 mm"], B = ["200 mm", "0 mm"] }
angle = "-7 deg"

[press.links.slider]
points = { B = ["0 mm", "0 mm"] }
angle = "0 deg"
mass = "2 kg"

[press.joints]
O = { type = "revolute", links = ["crank", "ground"] }
A = { type = "revolute", links = ["crank", "rod"] }
B = { type = "revolute", links = ["rod", "slider"] }
guide = { type = "prismatic", links = ["slider", "ground"], points = ["B", "B"] }

[[press.loads]]
name = "F1"
link = "slider"
at = "B"
F_x = "-1 kN"
F_y = "0 N"
)";

/// Messages when a part of the press is replaced.
std::string with(const std::string& part, const std::string& other) { return issues_of(replaced(press, part, other)); }

}  // namespace

TEST_SUITE("mechanism faults") {
  TEST_CASE("the press itself has no errors") { CHECK(issues_of(press).empty()); }

  TEST_CASE("a link that does not exist") {
    CHECK(with("[\"crank\", \"rod\"]", "[\"crank\", \"rdo\"]") == R"(a.toml:24:45: error: unknown link 'rdo'
24 | A = { type = "revolute", links = ["crank", "rdo"] }
   |                                             ^^^
   = help: did you mean 'rod'?
)");
    CHECK(with("link = \"slider\"", "link = \"hammer\"") == R"(a.toml:30:9: error: unknown link 'hammer'
30 | link = "hammer"
   |         ^^^^^^
   = help: available: crank, rod, slider, ground
)");
  }

  TEST_CASE("a point that its link does not have") {
    CHECK(with("at = \"B\"", "at = \"E\"") == R"(a.toml:31:7: error: the link 'slider' has no point 'E'
31 | at = "E"
   |       ^
   = help: available: B; or give 'E' among the points of 'slider'
)");
    CHECK(with("links = [\"crank\", \"rod\"] }", "links = [\"crank\", \"rod\"], points = [\"A\", \"Q\"] }") ==
          R"(a.toml:24:68: error: the link 'rod' has no point 'Q'
24 | A = { type = "revolute", links = ["crank", "rod"], points = ["A", "Q"] }
   |                                                                    ^
   = help: available: A, B; or give 'Q' among the points of 'rod', or name another point with points = [...]
)");
  }

  TEST_CASE("a joint of a link with itself") {
    CHECK(with("[\"crank\", \"rod\"]", "[\"crank\", \"crank\"]") ==
          R"(a.toml:24:34: error: joint 'A' connects 'crank' with itself
24 | A = { type = "revolute", links = ["crank", "crank"] }
   |                                  ^^^^^^^^^^^^^^^^^^
   = help: a joint is between two links, or between a link and the ground
)");
  }

  TEST_CASE("a point that two links share without a pin") {
    CHECK(with("points = { B = [\"0 mm\", \"0 mm\"] }",
               "points = { A = [\"1 mm\", \"0 mm\"], B = [\"0 mm\", \"0 mm\"] }") ==
          R"(a.toml:18:16: error: 'A' is a point of 'crank' and of 'slider', but no pin 'A' joins them
18 | points = { A = ["1 mm", "0 mm"], B = ["0 mm", "0 mm"] }
   |                ^^^^^^^^^^^^^^^^
   = help: give one of the two another name, or add the joint A = { type = "revolute", links = ["crank", "slider"] }
)");
  }

  TEST_CASE("no drive although there is a freedom") {
    CHECK(with("crank = { joint = \"O\", speed = \"60 rpm\", positions = 12 }\n", "") ==
          R"(a.toml:1:2: error: mobility 1, number of drives 0
1 | [press]
  |  ^^^^^
  = help: add a drive or a joint: 'crank', 'rod', 'slider' can still move
)");
  }

  TEST_CASE("a drive of a joint that does not exist, or that cannot turn") {
    CHECK(with("joint = \"O\"", "joint = \"Q\"") == R"(a.toml:3:20: error: unknown joint 'Q'
3 | crank = { joint = "Q", speed = "60 rpm", positions = 12 }
  |                    ^
  = help: available: O, A, B, guide
)");
    CHECK(with("joint = \"O\"", "joint = \"guide\"") ==
          R"(a.toml:3:20: error: a crank needs a revolute joint, and 'guide' is not one
3 | crank = { joint = "guide", speed = "60 rpm", positions = 12 }
  |                    ^^^^^
  = help: drive a slide or a slot by a cylinder: cylinders.C1 = { joint = "guide", ... }
)");
  }

  TEST_CASE("lengths that do not close") {
    CHECK(with("\"200 mm\"", "\"20 mm\"").starts_with("a.toml:25:5: error: joint 'B' does not close: a gap of "));
  }

  TEST_CASE("a link without a joint") {
    CHECK(issues_of(press + "[press.links.free]\npoints = { Z = [\"0 mm\", \"0 mm\"] }\n")
              .starts_with("a.toml:34:1: error: link 'free' has no joint\n"));
  }

  TEST_CASE("a load is complete, and of one kind") {
    CHECK(with("F_y = \"0 N\"\n", "").empty());  // the other one is zero
    CHECK(with("F_x = \"-1 kN\"\nF_y = \"0 N\"\n", "F = \"3 N\"\n")
              .starts_with("a.toml:28:1: error: give F with direction, or F_x and F_y\n"));
    CHECK(with("F_y = \"0 N\"\n", "F_y = \"0 N\"\nF = \"3 N\"\n")
              .starts_with("a.toml:28:1: error: give either F with direction or F_x and F_y, not both\n"));
    CHECK(
        with("F_x = \"-1 kN\"\nF_y = \"0 N\"\n", "")
            .starts_with("a.toml:28:1: error: a load has a force (F with direction, or F_x and F_y) or a couple M\n"));
    CHECK(
        with("at = \"B\"\n", "").starts_with("a.toml:28:1: error: a force needs the point it acts at: at = \"...\"\n"));
    CHECK(with("link = \"slider\"\nat", "link = \"ground\"\nat")
              .starts_with("a.toml:30:9: error: a load on the ground has no effect\n"));
  }

  TEST_CASE("a point is given in one way, and its error is reported once") {
    CHECK(with("A = [\"50 mm\", \"0 mm\"]", "A = { r = \"50 mm\", x = \"3 mm\" }")
              .starts_with("a.toml:10:38: error: a point has either x and y or r and angle\n"));
    CHECK(with("A = [\"50 mm\", \"0 mm\"]", "A = [\"50\", \"0 mm\"]") ==
          R"(a.toml:10:40: error: '50' has no unit; a length is expected
10 | points = { O = ["0 mm", "0 mm"], A = ["50", "0 mm"] }
   |                                        ^^
   = help: write '50 mm'
)");
  }

  TEST_CASE("fields that would have no effect with this drive") {
    CHECK(with("positions = 12", "positions = 12, at = \"30 deg\"") ==
          R"(a.toml:3:54: error: 'crank.positions' needs a full revolution, but 'crank.at' gives single crank angles
3 | crank = { joint = "O", speed = "60 rpm", positions = 12, at = "30 deg" }
  |                                                      ^^
  = help: leave out one of the two
)");
    CHECK(with("positions = 12", "start = \"9 deg\", at = \"30 deg\"")
              .starts_with("a.toml:3:51: error: 'crank.start' needs a full revolution, but 'crank.at' gives single "
                           "crank angles\n"));
    CHECK(with("[press.ground]", "positions = 12\n[press.ground]") ==
          R"(a.toml:5:13: error: 'positions' belongs to strokes of cylinders, and a crank drives
5 | positions = 12
  |             ^^
  = help: give the positions of a revolution in the crank: crank = { positions = 72 }
)");
  }

  TEST_CASE("a stroke has an end and a number of positions") {
    const std::string stroke = R"([press]
calculator = "mechanism.planar"
ground = { O = ["0 mm", "0 mm"] }
links.ram = { points = { P = ["100 mm", "0 mm"] }, mass = "2 kg", angle = "0 deg", origin = ["0 mm", "0 mm"] }
joints.G = { type = "prismatic", links = ["ram", "ground"], points = ["P", "O"] }
cylinders.c = { joint = "G", speed = "1 m/s", to = "150 mm" }
positions = 12
)";
    const auto without = [&](const std::string& part) {
      std::string text = stroke;
      text.erase(text.find(part), part.size());
      return issues_of(text);
    };
    CHECK(issues_of(stroke).empty());
    CHECK(without(", to = \"150 mm\"") ==
          R"(a.toml:7:13: error: 'positions' divides a stroke, and the cylinder 'c' has no end position
7 | positions = 12
  |             ^^
  = help: add 'to', the end position
)");
    CHECK(without("positions = 12\n") ==
          R"(a.toml:6:53: error: 'to' is the end of a stroke, and only one position is solved
6 | cylinders.c = { joint = "G", speed = "1 m/s", to = "150 mm" }
  |                                                     ^^^^^^
  = help: add the number of positions, positions = 72, or leave out 'to'
)");
  }

  TEST_CASE("numbers of the drive") {
    CHECK(with("positions = 12", "positions = 4")
              .starts_with("a.toml:3:54: error: crank.positions = 4: must be >= 8 and <= 7200\n"));
    CHECK(with("positions = 12", "positions = 12.5")
              .starts_with("a.toml:3:54: error: an integer is expected, not 12.5\n"));
    CHECK(with("\"60 rpm\"", "\"60 Hz\"") ==
          R"(a.toml:3:33: error: '60 Hz' is a frequency; an angular velocity is expected
3 | crank = { joint = "O", speed = "60 Hz", positions = 12 }
  |                                 ^^^^^
  = help: write it in rpm or in rad/s
)");
  }

  TEST_CASE("an expression in a mechanism is checked like any other") {
    CHECK(with("mass = \"2 kg\"", "mass = \"=2 kg * 3 m\"") ==
          R"(a.toml:20:10: error: 'links.slider.mass' is a mass, but this expression is a quantity in kg*m
20 | mass = "=2 kg * 3 m"
   |          ^^^^^^^^^^
)");
    CHECK(with("mass = \"2 kg\"", "mass = \"=2 kg - 3 kg\"")
              .starts_with("a.toml:20:10: error: links.slider.mass = -1 kg: must be >= 0 kg\n"));
  }

  TEST_CASE("a belt whose centres move apart is reported with its length") {
    const std::string belt = R"(
[press.links.pulley]
points = { A = ["0 mm", "0 mm"] }
angle = "0 deg"
[press.joints.P]
type = "revolute"
links = ["rod", "pulley"]
points = ["A", "A"]
[press.joints.loop]
type = "belt"
links = ["pulley", "ground"]
points = ["A", "T"]
radii = ["10 mm", "12 mm"]
)";
    std::string text = press + belt;
    text.replace(text.find("B = [\"0 mm\", \"0 mm\"]\n"), 22, "B = [\"0 mm\", \"0 mm\"]\nT = [\"0 mm\", \"300 mm\"]\n");
    const std::string said = issues_of(text);
    INFO(said);
    CHECK(said.find("error: the belt 'loop' keeps its length, and the distance of its centres changes as the mechanism "
                    "moves\n") != std::string::npos);
    CHECK(said.find("= help: keep both centres on one link") != std::string::npos);
  }

  TEST_CASE("gears whose ratios contradict each other") {
    const std::string said = issues_of(R"([a]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "60 rpm" }
ground = { O = ["0 mm", "0 mm"], C = ["60 mm", "0 mm"] }
links.pinion = { points = { O = ["0 mm", "0 mm"] }, angle = "0 deg" }
links.wheel = { points = { C = ["0 mm", "0 mm"] }, angle = "0 deg" }
joints.O = { type = "revolute", links = ["ground", "pinion"] }
joints.C = { type = "revolute", links = ["ground", "wheel"] }
joints.m1 = { type = "gear", links = ["pinion", "wheel"], points = ["O", "C"], radii = ["20 mm", "40 mm"] }
joints.m2 = { type = "gear", links = ["pinion", "wheel"], points = ["O", "C"], radii = ["30 mm", "30 mm"] }
)");
    INFO(said);
    CHECK(said.find("error: mobility 0, number of drives 1\n") != std::string::npos);
    CHECK(said.find("= help: the mechanism is locked: the ratios of 'm1', 'm2' contradict each other; correct their "
                    "radii, or remove one\n") != std::string::npos);
  }

  TEST_CASE("a rack off the pitch circle of its gear") {
    const std::string said = issues_of(R"([a]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "60 rpm", at = "10 deg" }
ground = { O = ["0 mm", "0 mm"], R = ["0 mm", "25 mm"] }
links.pinion = { points = { O = ["0 mm", "0 mm"] }, angle = "0 deg" }
links.rack = { points = { R = ["0 mm", "0 mm"] }, angle = "0 deg", origin = ["0 mm", "25 mm"] }
joints.O = { type = "revolute", links = ["pinion", "ground"] }
joints.G = { type = "prismatic", links = ["rack", "ground"], points = ["R", "R"] }
joints.mesh = { type = "rack", links = ["pinion", "rack"], points = ["O", "R"], radius = "20 mm" }
)");
    INFO(said);
    CHECK(said.find("error: the centre of the wheel of 'mesh' is 25 mm from the line of its rack, and its radius is "
                    "20 mm\n") != std::string::npos);
  }

  TEST_CASE("a torsion spring that every revolution winds up further") {
    const auto wound = solved(press + R"([press.springs.coil]
links = ["crank", "ground"]
k_turn = "2 N*m/rad"
free_angle = "0 deg"
)");
    const auto& verdicts = wound.steps[0]->account().verdicts;
    const auto found =
        std::find_if(verdicts.begin(), verdicts.end(), [](const auto& v) { return v.symbol == "returns_coil"; });
    REQUIRE(found != verdicts.end());
    CHECK(found->state == account::State::fail);
    CHECK(std::get<account::Quantity>(found->value).si == doctest::Approx(2.0 * pi));
  }
}
