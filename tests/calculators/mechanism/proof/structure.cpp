// The tables of the structure in a report: groups by their names, and how well their equations determine them.
#include "lib/toml/tree.hpp"
#include "tests/lib/project/accounts.hpp"
#include "tests/lib/project/texts.hpp"

#include <cmath>
#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

project::Project reference_of(const std::string& name) {
  std::string text;
  REQUIRE(toml::read_file(std::string(LOADPATH_ROOT) + "/reference/" + name + ".toml", text));
  return solved(text);
}

const account::Table& structure_of(const project::Project& project) {
  const account::Table* table = table_of(project, "Structural (Assur) groups");
  REQUIRE(table != nullptr);
  return *table;
}

/// The rows of the table of the mobility that are about Jacobians.
std::vector<std::vector<account::Cell>> jacobians_of(const project::Project& project) {
  const account::Table* table = table_of(project, "Mobility and conditioning");
  REQUIRE(table != nullptr);
  std::vector<std::vector<account::Cell>> rows;
  for (const auto& row : table->rows) {
    if (text_of(row[0]).find("Jacobian") != std::string::npos) rows.push_back(row);
  }
  return rows;
}

}  // namespace

TEST_SUITE("mechanism structure in a report") {
  TEST_CASE("text D, example 2: a crank and a six-link group, J = -482.605 m^6") {
    const auto project = reference_of("six-bar");
    const account::Table& structure = structure_of(project);
    REQUIRE(structure.rows.size() == 2);
    CHECK(text_of(structure.rows[0][2]) == "initial link");
    CHECK(text_of(structure.rows[1][2]) == "six-link group, class III, order 4");
    CHECK(text_of(structure.rows[1][3]) == "18 = 2 · 9 + 0");
    const auto rows = jacobians_of(project);
    REQUIRE(rows.size() == 1);
    CHECK(text_of(rows[0][0]) ==
          "Jacobian determinant of the group link2, link3, link4, link5, link6, link7, magnitude");
    const auto& J = std::get<account::Quantity>(rows[0][1]);
    CHECK(std::abs(J.si - 482.605) < 5e-4);
    CHECK(J.unit == "m^6");
  }

  TEST_CASE("over a cycle the smallest Jacobian: of a rod and a slider where the rod is most inclined") {
    const auto project = solved(R"([a]
calculator = "mechanism.planar"
template = "slider_crank"
r = "50 mm"
l = "200 mm"
crank = { speed = "60 rpm", positions = 72 }
)");
    CHECK(text_of(structure_of(project).rows[1][2]) == "two-link group, class II, order 2, RRP");
    const auto rows = jacobians_of(project);
    REQUIRE(rows.size() == 1);
    CHECK(text_of(rows[0][0]) == "minimum Jacobian determinant of the group rod, slider, magnitude, at 90°");
    const auto& J = std::get<account::Quantity>(rows[0][1]);
    CHECK(J.si == doctest::Approx(std::sqrt(0.2 * 0.2 - 0.05 * 0.05)).epsilon(1e-12));
    CHECK(J.unit == "m");
  }

  TEST_CASE("a meshing gear is a group of one link, and its Jacobian is the same at every position") {
    const auto project = solved(R"([a]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "60 rpm", positions = 12 }
ground = { O = ["0 mm", "0 mm"], C = ["70 mm", "0 mm"] }
links.pinion = { points = { O = ["0 mm", "0 mm"] }, angle = "0 deg" }
links.wheel = { points = { C = ["0 mm", "0 mm"] }, angle = "0 deg" }
joints.O = { type = "revolute", links = ["ground", "pinion"] }
joints.C = { type = "revolute", links = ["ground", "wheel"] }
joints.mesh = { type = "gear", links = ["pinion", "wheel"], points = ["O", "C"], radii = ["20 mm", "50 mm"] }
)");
    CHECK(text_of(structure_of(project).rows[1][2]) == "one-link group, class II, order 2, RRR");
    const auto rows = jacobians_of(project);
    REQUIRE(rows.size() == 1);
    CHECK(text_of(rows[0][0]) == "Jacobian determinant of the group wheel, magnitude");
    CHECK(std::get<account::Quantity>(rows[0][1]).si == doctest::Approx(0.05).epsilon(1e-12));
  }

  TEST_CASE("docs/mechanisms.md lists all solutions of 3 n = 2 p5 + p4 for one to four links: text A, table 10.2") {
    std::string page;
    REQUIRE(toml::read_file(std::string(LOADPATH_ROOT) + "/docs/mechanisms.md", page));
    for (int n = 1; n <= 4; ++n) {
      std::string row = "| " + std::to_string(n) + " | ";
      for (int p5 = 0; 2 * p5 <= 3 * n; ++p5)
        row += (p5 == 0 ? "" : ", ") + std::to_string(p5) + " + " + std::to_string(3 * n - 2 * p5);
      CHECK_MESSAGE(page.find("\n" + row + " |\n") != std::string::npos, row);
    }
  }
}
