// Rows and series in files next to a project: their reading, and one error a file with its fix.
#include "tests/cli/process.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace loadpath::test;

namespace {

const std::string step =
    "[s]\ncalculator = \"section.polygon\"\npoints = [[\"0 mm\", \"0 mm\"], [\"40 mm\", \"0 mm\"], [\"0 mm\", \"30 "
    "mm\"]]\n";
const std::string of_file = "[s]\ncalculator = \"section.polygon\"\npoints = ";

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Ran run(const Desk& desk, const std::string& rows, const std::string& table = "{ file = \"rows.csv\" }") {
  desk.put("rows.csv", rows);
  desk.put("p.toml", of_file + table + "\n");
  return desk.run({"run", "p.toml"});
}

}  // namespace

TEST_SUITE("cli rows in files") {
  TEST_CASE("cells are separated by commas, by semicolons with decimal commas, by tabs and by blanks") {
    const Desk desk;
    desk.put("inside.toml", step);
    const std::string same = desk.run({"run", "inside.toml"}).out;
    for (const char* rows : {"y [mm], z [mm]\n0, 0\n40, 0\n0, 30\n", "y [cm];z [mm]\n0;0\n4,0;0\n0;30,0\n",
                             "y [mm]\tz [cm]\n0\t0\n40\t0\n0\t3\n", "y [mm] z [mm]\n0 0\n40   0\n0 30\n",
                             "\xef\xbb\xbfz (mm), y (mm)\r\n0, 0\r\n0, 40\r\n30, 0\r\n"}) {
      CAPTURE(rows);
      const Ran ran = run(desk, rows);
      CHECK(ran.error == "");
      CHECK(ran.out == same);
    }
  }

  TEST_CASE("columns with other names are given by name or by number, and others are left out") {
    const Desk desk;
    desk.put("inside.toml", step);
    const Ran ran = run(desk, "no; across [mm]; up [mm]\n1; 0; 0\n2; 40; 0\n3; 0; 30\n",
                        "{ file = \"rows.csv\", columns = { y = \"across\", z = 3 } }");
    CHECK(ran.error == "");
    CHECK(ran.out == desk.run({"run", "inside.toml"}).out);
    const Ran wrong = run(desk, "y [mm], z [mm]\n0, 0\n", "{ file = \"rows.csv\", columns = { y = \"x\", z = 2 } }");
    CHECK(wrong.code == 2);
    CHECK(holds(wrong.error, "'rows.csv' has 2 columns, and no column 'x'"));
  }

  TEST_CASE("one error per file, at its own line, with the fix") {
    const Desk desk;
    const Ran unit = run(desk, "# measured\ny, z\n0, 0\n40, 0\n0, 30\n");
    CHECK(unit.code == 2);
    CHECK(holds(unit.error, "rows.csv:2:1: error: "));
    CHECK(holds(unit.error, "the heading 'y' has no unit"));
    CHECK(holds(unit.error, "name the unit in the header: y [mm]"));
    const Ran dimension = run(desk, "y [kg], z [mm]\n0, 0\n40, 0\n0, 30\n");
    CHECK(holds(dimension.error, "rows.csv:1:1: error: "));
    CHECK(holds(dimension.error, "a mass; a length is expected"));
    CHECK(holds(dimension.error, "name the unit in the header: y [mm]"));
    const Ran number = run(desk, "y [mm], z [mm]\n0, 0\n40, oops\n0, oops\n");
    CHECK(holds(number.error, "rows.csv:3:5: error: "));
    CHECK_FALSE(holds(number.error, "rows.csv:4"));
    const Ran cells = run(desk, "y [mm], z [mm]\n0, 0\n40\n");
    CHECK(holds(cells.error, "rows.csv:3:1: error: "));
    for (const Ran* ran : {&unit, &dimension, &number, &cells}) {
      const std::size_t first = ran->error.find("error: ");
      CHECK(ran->error.find("error: ", first + 1) == std::string::npos);
    }
  }

  TEST_CASE("a series takes its unit from the heading, and a unit that contradicts it is reported") {
    const Desk desk;
    const std::string history =
        "[h]\ncalculator = \"fatigue.history\"\nsigma_D = \"100 MPa\"\nN_D = 1e6\nk = 5\nminer = \"elementary\"\nsigma "
        "= ";
    desk.put("gauge.csv", "t [s];S1 [MPa]\n0;0\n1;150,0\n2;-50\n3;100\n4;0\n");
    desk.put("row.csv", "t [s];0;1;2;3;4\nS1 [MPa];0;150,0;-50;100;0\n");
    const auto damage = [&](const std::string& sigma) {
      desk.put("h.toml", history + sigma + "\n");
      return desk.run({"run", "h.toml", "--json"});
    };
    const Ran named = damage("{ file = \"gauge.csv\", column = \"S1\" }");
    const Ran along = damage("{ file = \"row.csv\", row = \"S1\" }");
    const Ran typed = damage("{ values = [0, 150, -50, 100, 0], unit = \"MPa\" }");
    CHECK(typed.code != 2);
    CHECK(named.code == typed.code);
    CHECK(along.code == typed.code);
    const auto damage_in = [](const Ran& ran) {
      const std::size_t at = ran.out.find("\"D\"");
      return at == std::string::npos ? std::string() : ran.out.substr(at, ran.out.find('}', at) - at);
    };
    CHECK_FALSE(damage_in(typed).empty());
    CHECK(damage_in(named) == damage_in(typed));
    CHECK(damage_in(along) == damage_in(typed));
    const Ran against = damage("{ file = \"gauge.csv\", column = \"S1\", unit = \"kPa\" }");
    CHECK(against.code == 2);
    CHECK(holds(against.out + against.error, "the heading is 'S1 [MPa]', and unit = "));
    const Ran both = damage("{ file = \"row.csv\", row = \"S1\", column = 2 }");
    CHECK(both.code == 2);
    CHECK(holds(both.out + both.error, "a series is a column or a row of the file, not both"));
  }
}
