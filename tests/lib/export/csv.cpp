#include "lib/export/csv.hpp"

#include "tests/lib/project/texts.hpp"

#include <algorithm>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string bar = bar_that_cannot_turn(12);

/// At quarters of a turn of a crank of 5 mm, every place is a round number.
const std::string circle = R"([press]
calculator = "mechanism.planar"
template = "scotch_yoke"
r = "5 mm"
crank = { speed = "60 rpm", at = ["0 deg", "90 deg", "180 deg", "270 deg"] }
)";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = text.find('\n', from);
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

auto commas(const std::string& line) { return std::count(line.begin(), line.end(), ','); }

}  // namespace

TEST_SUITE("csv") {
  TEST_CASE("a file for each step that has series, none for the others") {
    const auto project = told(bar + axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\n").project;
    const auto files = exports::csv_of(project);
    REQUIRE(files.size() == 1);
    CHECK(files[0].first == "bar.csv");
  }

  TEST_CASE("columns carry their unit, rows are positions, angles are round") {
    const auto lines = lines_of(exports::csv_of(told(bar).project).at(0).second);
    REQUIRE(lines.size() == 13);
    CHECK(lines[0].starts_with("crank angle [deg],drive.M [N*m],drive.P [W],joints.A.F [N],joints.A.x [N]"));
    CHECK(lines[1].starts_with("0,"));
    CHECK(lines[2].starts_with("30,"));
    for (const std::string& line : lines) CHECK(commas(line) == commas(lines[0]));
  }

  TEST_CASE("only the chosen series, and no file where none is chosen") {
    const auto lines = lines_of(exports::csv_of(told(bar).project, project::SeriesChoice({"joints.?.F"})).at(0).second);
    CHECK(lines[0] == "crank angle [deg],joints.A.F [N],joints.B.F [N],joints.C.F [N],joints.D.F [N]");
    CHECK(lines.size() == 13);
    CHECK(exports::csv_of(told(bar).project, project::SeriesChoice({"other.*"})).empty());
  }

  TEST_CASE("cells have no rounding noise: a value that differs from a round number by rounding is that number") {
    const auto project = solved(circle);
    for (const std::string& line : lines_of(exports::csv_of(project).at(0).second)) {
      CAPTURE(line);
      CHECK(line.find("99999999") == std::string::npos);
      CHECK(line.find("00000000") == std::string::npos);
    }
    const std::string crank =
        exports::csv_of(project, project::SeriesChoice({"points.A.x", "points.A.y"})).at(0).second;
    CHECK(crank == "crank angle [deg],points.A.x [mm],points.A.y [mm]\n0,5,0\n90,0,5\n180,-5,0\n270,0,-5\n");
  }

  TEST_CASE("a value that is not available is an empty cell, never nan") {
    const std::string text = exports::csv_of(told(bar).project).at(0).second;
    CHECK(text.find(",,,") != std::string::npos);
    CHECK(text.find("nan") == std::string::npos);
    CHECK(text.find("not available") == std::string::npos);
  }
}
