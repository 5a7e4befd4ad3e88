#include "lib/io/csv.hpp"

#include "tests/lib/project/texts.hpp"

#include <algorithm>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string bar = bar_that_cannot_turn(12);

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
    const auto files = io::csv_of(project);
    REQUIRE(files.size() == 1);
    CHECK(files[0].first == "bar.csv");
  }

  TEST_CASE("columns carry their unit, rows are positions, angles are round") {
    const auto lines = lines_of(io::csv_of(told(bar).project).at(0).second);
    REQUIRE(lines.size() == 13);
    CHECK(lines[0].starts_with("crank angle [deg],drive.M [N*m],drive.P [W],joints.A.F [N],joints.A.x [N]"));
    CHECK(lines[1].starts_with("0,"));
    CHECK(lines[2].starts_with("30,"));
    for (const std::string& line : lines) CHECK(commas(line) == commas(lines[0]));
  }

  TEST_CASE("what is not available is an empty cell, never nan") {
    const std::string text = io::csv_of(told(bar).project).at(0).second;
    CHECK(text.find(",,,") != std::string::npos);
    CHECK(text.find("nan") == std::string::npos);
    CHECK(text.find("not available") == std::string::npos);
  }
}
