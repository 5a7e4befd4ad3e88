// Cylinders between two points. Lengths, forces and moments were recomputed by virtual work, with the law of cosines.
#include "tests/calculators/rows.hpp"
#include "tests/lib/project/accounts.hpp"
#include "tests/lib/project/texts.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// A boom of 2 m about O carries 10 kN at its tip T; its pin P, 0.8 m from O, is held from C on the ground.
const std::string boom = R"([lift]
calculator = "mechanism.planar"
ground = { O = ["0 mm", "0 mm"], C = ["400 mm", "-600 mm"] }
links.boom = { points = { O = ["0 mm", "0 mm"], P = ["800 mm", "0 mm"], T = ["2 m", "0 mm"] }, angle = "20 deg" }
joints.O = { type = "revolute", links = ["ground", "boom"] }
loads = [{ name = "weight", link = "boom", at = "T", F_x = "0 N", F_y = "-10 kN" }]
)";
const std::string between = "links = [\"ground\", \"boom\"], points = [\"C\", \"P\"]";

std::string lifted() {
  return boom + "positions = 3\ncylinders.ram = { " + between +
         ", from = \"1 m\", to = \"1.2 m\", speed = \"50 mm/s\" }\n";
}

std::string pushed(const std::string& more) {
  return boom + "crank = { joint = \"O\", speed = \"2 rad/s\", at = [[\"0 deg\"], [\"20 deg\"], [\"50 deg\"]] }\n" +
         "cylinders.ram = { " + between + ", F = \"20 kN\"" + more + " }\n";
}

const std::vector<double>& series(const project::Project& project, const std::string& path) {
  return entry_of(project, path).value.si;
}

void check_series(const project::Project& project, const std::string& path, const std::vector<double>& expected) {
  CAPTURE(path);
  const auto& found = series(project, path);
  REQUIRE(found.size() == expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) CHECK(found[k] == doctest::Approx(expected[k]).epsilon(1e-9));
}

}  // namespace

TEST_SUITE("cylinders") {
  TEST_CASE("a cylinder between two points drives by its length") {
    const auto p = solved(lifted());
    check_series(p, "cylinders.ram.F", {31539.000161890, 30813.185133502, 28842.470966831});
    check_series(p, "cylinders.ram.s", {1.0, 1.1, 1.2});
    check_series(p, "cylinders.ram.v", {0.05, 0.05, 0.05});
    check_series(p, "cylinders.ram.P", {1576.9500080945, 1540.6592566751, 1442.1235483415});
    check_series(p, "cylinders.ram.stroke", {0.2});
  }

  TEST_CASE("it is the same as its two links and three joints written out") {
    const auto by_hand = solved(boom + R"(positions = 3
links.barrel = { points = { C = ["0 mm", "0 mm"] }, origin = ["400 mm", "-600 mm"], angle = "68 deg" }
links.rod = { points = { P = ["0 mm", "0 mm"] }, origin = ["752 mm", "274 mm"], angle = "68 deg" }
joints.C = { type = "revolute", links = ["ground", "barrel"] }
joints.P = { type = "revolute", links = ["rod", "boom"] }
joints.bore = { type = "prismatic", links = ["rod", "barrel"], points = ["P", "C"], angle = "0 deg" }
cylinders.ram = { joint = "bore", from = "1 m", to = "1.2 m", speed = "50 mm/s" }
)");
    for (const char* path : {"cylinders.ram.F", "cylinders.ram.s", "cylinders.ram.P", "joints.O.F", "links.boom.phi"})
      check_series(by_hand, path, series(solved(lifted()), path));
  }

  TEST_CASE("a given force pushes the ends apart, whatever the length") {
    const auto p = solved(pushed(""));
    check_series(p, "drive.M", {6687.1952905097, 6890.7928465370, 3765.7685722881});
    check_series(p, "cylinders.ram.F", {20e3, 20e3, 20e3});
    check_series(p, "cylinders.ram.s", {0.72111025509280, 0.94177282838786, 1.2182030188745});
    check_series(p, "cylinders.ram.v", {1.3312804709490, 1.1903059569181, 0.90899836214427});
    check_series(p, "cylinders.ram.P", {26625.609418981, 23806.119138362, 18179.967242885});
  }

  TEST_CASE("the force may follow the length, as that of a gas spring") {
    const auto p =
        solved(pushed(", course = \"gas\"") + "courses.gas.over_stroke = [[\"0.7 m\", 1], [\"1.3 m\", 0.4]]\n");
    check_series(p, "cylinders.ram.F",
                 {20e3 * (1.0 - 0.02111025509280), 20e3 * (1.0 - 0.24177282838786), 20e3 * (1.0 - 0.5182030188745)});
  }

  TEST_CASE("an impossible cylinder is reported") {
    const auto with = [](const std::string& cylinder) {
      return first_error(boom + "cylinders.ram = { " + cylinder + " }\n");
    };
    CHECK(with("speed = \"1 mm/s\"") == "'ram' names neither the links that it lies between nor a joint");
    CHECK(with("joint = \"O\", " + between) == "'joint' and 'links' both state the parts moved by 'ram'");
    CHECK(with("links = [\"ground\", \"boom\"]") == "a cylinder between two points needs 'links' and 'points'");
    CHECK(with("links = [\"ground\", \"bom\"], points = [\"C\", \"P\"]") == "unknown link 'bom'");
    CHECK(with("links = [\"ground\", \"boom\"], points = [\"C\", \"Q\"]") == "the link 'boom' has no point 'Q'");
    CHECK(with("links = [\"boom\", \"boom\"], points = [\"T\", \"P\"]") ==
          "a cylinder lies between two links, or a link and the ground");
    CHECK(with(between + ", F = \"1 kN\", speed = \"1 mm/s\"") == "the force of 'ram' is given, and so is its motion");
    CHECK(with("joint = \"O\", F = \"1 kN\"") ==
          "'F' belongs to a cylinder between two points, and 'ram' drives a joint");
    CHECK(with(between + ", course = \"x\"") == "'course' is the load curve of F, and 'ram' has no F");
  }
}
