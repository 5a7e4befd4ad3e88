// Gears, friction, springs, loads over the crank angle and internal forces of a mechanism in a project.
#include "calculators/mechanism/input/loads.hpp"

#include "lib/project/project.hpp"
#include "tests/lib/project/accounts.hpp"
#include "tests/lib/project/texts.hpp"

using namespace loadpath;
using namespace loadpath::planar;
using namespace loadpath::test;

namespace {

const std::string press = R"([press]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "300 rpm", positions = 72 }

[press.ground]
O = ["0 mm", "0 mm"]
C = ["70 mm", "0 mm"]
B = ["70 mm", "0 mm"]

[press.links.pinion]
points = { O = ["0 mm", "0 mm"] }
angle = "10 deg"

[press.links.wheel]
points = { C = ["0 mm", "0 mm"], A = ["30 mm", "0 mm"] }
angle = "40 deg"

[press.links.rod]
points = { A = ["0 mm", "0 mm"], B = ["150 mm", "0 mm"] }
angle = "-10 deg"

[press.links.slider]
points = { B = ["0 mm", "0 mm"] }
angle = "0 deg"

[press.joints]
O = { type = "revolute", links = ["pinion", "ground"] }
C = { type = "revolute", links = ["wheel", "ground"] }
mesh = { type = "gear", links = ["pinion", "wheel"], points = ["O", "C"], radii = ["20 mm", "50 mm"] }
A = { type = "revolute", links = ["wheel", "rod"] }
B = { type = "revolute", links = ["rod", "slider"] }
guide = { type = "prismatic", links = ["slider", "ground"], points = ["B", "B"] }

[press.springs]
back = { links = ["slider", "ground"], points = ["B", "O"], k = "2 N/mm", free = "100 mm" }

[[press.loads]]
name = "F1"
link = "slider"
at = "B"
F_x = "-1 kN"
F_y = "0 N"
)";

std::string with(const std::string& part, const std::string& other) { return issues_of(replaced(press, part, other)); }
std::string message_of(const std::string& part, const std::string& other) {
  return first_error(replaced(press, part, other));
}

}  // namespace

TEST_SUITE("mechanism faults") {
  TEST_CASE("a train that is not back after its revolutions has no cycle; with crank angles no cycle is needed") {
    const auto once = solved(press);
    CHECK(verdict_of(once, "returns").state == account::State::fail);
    CHECK(verdict_of(once, "returns").note.text() ==
          "give the revolutions of the crank per cycle, crank = { turns = ... }; if these are too many, give crank "
          "angles in place of a cycle, crank = { at = [...] }, without mean values");
    CHECK(find_verdict(solved(replaced(press, "positions = 72", "positions = 72, turns = 5")), "returns") == nullptr);
    const auto given = solved(replaced(press, "positions = 72", "at = [\"10 deg\", \"20 deg\", \"40 deg\"]"));
    CHECK(find_verdict(given, "returns") == nullptr);
  }

  TEST_CASE("the geared press has no errors") { CHECK(issues_of(press).empty()); }

  TEST_CASE("fields that a joint's type does not take, or needs") {
    CHECK(message_of("links = [\"wheel\", \"rod\"] }", "links = [\"wheel\", \"rod\"], guide_length = \"20 mm\" }") ==
          "'guide_length' belongs to prismatic joints, and 'A' is of type revolute");
    CHECK(
        message_of("links = [\"wheel\", \"rod\"] }", "links = [\"wheel\", \"rod\"], radii = [\"1 mm\", \"2 mm\"] }") ==
        "'radii' belongs to joints of two wheels, and 'A' is of type revolute");
    CHECK(message_of("links = [\"wheel\", \"rod\"] }", "links = [\"wheel\", \"rod\"], mu = 0.1 }") ==
          "joint 'A' of type revolute needs 'pin_radius'");
    CHECK(message_of("points = [\"B\", \"B\"] }", "points = [\"B\", \"B\"], mu = 0.1 }") ==
          "joint 'guide' of type prismatic needs 'guide_length'");
    CHECK(message_of(", radii = [\"20 mm\", \"50 mm\"]", "") == "joint 'mesh' of type gear needs 'radii'");
    CHECK(message_of("\"gear\"", "\"ring_gear\"").find("the centre distance of 'mesh' is 70 mm") == 0);
    CHECK(message_of("\"20 mm\", \"50 mm\"", "\"25 mm\", \"50 mm\"") ==
          "the centre distance of 'mesh' is 70 mm, but the radii require 75 mm");
    CHECK(
        message_of("\"gear\", links = [\"pinion\", \"wheel\"], points = [\"O\", \"C\"], radii = [\"20 mm\", \"50 mm\"]",
                   "\"ring_gear\", links = [\"pinion\", \"wheel\"], points = [\"O\", \"C\"], radii = [\"50 mm\", \"20 "
                   "mm\"]") == "the wheel of the first link, 50 mm, does not fit into that of the second, 20 mm");
  }

  TEST_CASE("springs and their fields") {
    CHECK(message_of("k = \"2 N/mm\", free = \"100 mm\"", "k = \"2 N/mm\"") ==
          "the spring 'back' needs its free length");
    CHECK(message_of("k = \"2 N/mm\", free = \"100 mm\"", "free = \"100 mm\"") ==
          "'back' has neither a rate nor a damping");
    CHECK(message_of("k = \"2 N/mm\"", "k_turn = \"2 N*m/rad\", k = \"2 N/mm\"") ==
          "'back' mixes fields of a translational and a torsional spring");
    CHECK(message_of("points = [\"B\", \"O\"], k", "k") == "'back' needs the points of its ends");
    CHECK(message_of("points = [\"B\", \"O\"], k", "points = [\"B\", \"Q\"], k") ==
          "the link 'ground' has no point 'Q'");
    CHECK(message_of("{ links = [\"slider\", \"ground\"], points = [\"B\", \"O\"], k",
                     "{ links = [\"slider\", \"slider\"], points = [\"B\", \"B\"], k") ==
          "a spring acts between two links, or a link and the ground");
  }

  TEST_CASE("loads over the crank angle") {
    CHECK(message_of("F_y = \"0 N\"", "F_y = \"0 N\"\nover = [[\"90 deg\", 1], [\"20 deg\", 0]]") ==
          "the crank angles of 'over' must increase");
    CHECK(message_of("F_y = \"0 N\"", "F_y = \"0 N\"\nover = [[\"0 deg\", 1], [\"400 deg\", 0]]") ==
          "the crank angles of 'over' cover more than one cycle");
  }

  TEST_CASE("laws of motion") {
    CHECK(message_of("speed = \"300 rpm\", positions = 72 }", "law = [[\"0 s\", \"0 deg\"]] }") ==
          "a law of motion needs at least two instants");
    CHECK(message_of("speed = \"300 rpm\", positions = 72 }",
                     "law = [[\"1 s\", \"0 deg\"], [\"0.5 s\", \"90 deg\"]] }") == "the times of a law must increase");
    CHECK(with("speed = \"300 rpm\", positions = 72 }", "law = [[\"0 s\", \"10 deg\"], [\"0.5 s\", \"90 deg\"]] }")
              .empty());
  }

  TEST_CASE("a link that is stated to be a uniform bar") {
    CHECK(message_of("angle = \"-10 deg\"",
                     "angle = \"-10 deg\"\nmass = \"2 kg\"\nS = \"A\"\nJ = \"0 kg*m^2\"\nmass_line = \"uniform\"") ==
          "link 'rod' is not a uniform bar of 150 mm, which has its mass centre in the middle and J = 0.00375 kg·m²");
  }
}

TEST_SUITE("mechanism loads") {
  TEST_CASE("a load's factor is linear from each crank angle to the next, and around to the first") {
    planar::Load load;
    CHECK(share_at(load, 1.0, 2.0 * pi) == 1.0);
    load.over.resize(3);
    load.over[0] = {0.0, 0.0};
    load.over[1] = {pi, 1.0};
    load.over[2] = {1.5 * pi, 0.5};
    CHECK(share_at(load, 0.5 * pi, 2.0 * pi) == doctest::Approx(0.5));
    CHECK(share_at(load, 1.25 * pi, 2.0 * pi) == doctest::Approx(0.75));
    CHECK(share_at(load, 1.75 * pi, 2.0 * pi) == doctest::Approx(0.25));
    CHECK(share_at(load, 0.5 * pi + 6.0 * pi, 2.0 * pi) == doctest::Approx(0.5));
    CHECK(share_at(load, 0.5 * pi - 8.0 * pi, 2.0 * pi) == doctest::Approx(0.5));
  }
}
