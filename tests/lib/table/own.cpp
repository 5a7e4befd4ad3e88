#include "lib/table/own/own.hpp"

#include "lib/table/library.hpp"
#include "lib/table/tables.hpp"
#include "tests/lib/table/tables.hpp"

using namespace loadpath;
using namespace loadpath::table;

namespace {

const std::vector<std::string> groups{"chain", "material", "section", "tetmajer"};

/// Issues as "line:column: message | hint".
std::string told(const std::vector<Issue>& issues) {
  std::string all;
  for (const Issue& issue : issues) {
    all += (all.empty() ? "" : "\n") + std::to_string(issue.place.line) + ":" + std::to_string(issue.place.column) +
           ": " + issue.message.text() + (issue.hint.empty() ? "" : " | " + issue.hint.text());
  }
  return all;
}

struct Own {
  std::vector<Issue> issues;
  Tables tables;
};

/// A project with these tables, and what is wrong with them.
Own read(const std::string& text, const std::vector<std::string>& files = {}) {
  Own own;
  Library library;
  OwnReader reader(library, groups, own.issues);
  const toml::Tree tree = toml::read_toml(text, "a.toml", own.issues);
  if (const auto* tables = tree.find("tables")) reader.read_tables(*tables);
  for (const std::string& file : files) reader.read_file(file, "own.toml");
  own.tables = Tables(std::move(library), groups);
  return own;
}

std::string fault_of(const std::string& text) { return told(read(text).issues); }

const std::string row = "[tables.materials.M]\nsource = \"certificate\"\n";

const std::string file = R"(table = "mine/steels"
group = "material"
units = { E = "GPa", R_e = "MPa", size_max = "mm" }
[[row]]
name = "M"
E = 205
by_size = [{ size_max = 20, R_e = 300 }]
sources = ["certificate"]
[sources]
certificate = "Mill certificate 4711"
)";

}  // namespace

TEST_SUITE("own tables") {
  TEST_CASE("a row of a project has its values in any unit, by size, under its name and its aliases") {
    const Own own = read(R"([tables.materials.P265]
aliases = ["H-II"]
kind = "pressure vessel steel"
E = "30458 ksi"
nu = 0.3
by_size = [{ size_max = "16 mm", R_e = "265 MPa" }, { size_max = "4 cm", R_e = "255 MPa" }]
source = "EN 10028-2"
)");
    CHECK(told(own.issues).empty());
    for (const char* name : {"P265", "p 265", "HII"}) {
      const auto entry = own.tables.find_row("material", name);
      REQUIRE_MESSAGE(entry, name);
      CHECK(value_of(*entry, "E") == doctest::Approx(210e9).epsilon(1e-4));
      CHECK(value_of(*entry, "nu") == 0.3);
      CHECK(value_of(*entry, "R_e", 17 * mm) == 255 * MPa);
      CHECK(std::isnan(value_of(*entry, "R_e", 41 * mm)));
      const auto property = table::property(*entry, "E");
      CHECK(property->own);
      CHECK_FALSE(property->recalled);
      CHECK(named_source("P265", *property).text() == "P265, own table of the project: EN 10028-2");
    }
    CHECK(own.tables.find_row("material", "S235")->row->own == false);
  }

  TEST_CASE("a row of a project replaces a built-in one, in this project only") {
    const Own own = read("[tables.materials.S235]\nE = \"200 GPa\"\nsource = \"test report\"\n");
    CHECK(told(own.issues).empty());
    CHECK(value_of(*own.tables.find_row("material", "S235"), "E") == 200e9);
    CHECK(value_of(*Tables().find_row("material", "S235"), "E") == 210e9);
    CHECK(value_of(*read("").tables.find_row("material", "S235"), "E") == 210e9);
  }

  TEST_CASE("errors in a row are reported with their place") {
    CHECK(fault_of("[tables.materials.M]\nE = \"200 GPa\"\n") ==
          "1:19: 'tables.materials.M' has no source | state the origin of its values: source = \"certificate 4711 of "
          "2026-03-02\"");
    CHECK(fault_of(row + "Re = \"300 MPa\"\nE = \"1 GPa\"") ==
          "3:1: the material tables have no column 'Re' | did you mean 'R_e'?");
    CHECK(fault_of(row + "R_e = \"300 mm\"\nE = \"1 GPa\"").starts_with("3:8: "));
    CHECK(fault_of(row + "R_e = 300\nE = \"1 GPa\"").starts_with("3:7: "));
    CHECK(fault_of(row + "R_e = \"0 MPa\"") == "3:8: R_e = 0 MPa: must be > 0");
    CHECK(fault_of(row + "R_e = true\nE = \"1 GPa\"") ==
          "3:7: a quantity is expected, not true, false or a date | write a text with a unit, \"30 MPa\"");
    CHECK(fault_of(row + "E = \"1 GPa\"\nkind = \"structural stel\"") ==
          "4:9: no other row is of the kind 'structural stel' | did you mean 'structural steel'?");
    CHECK(fault_of("[tables.materials.M]\nsource = \"\"\nE = \"1 GPa\"") == "2:11: 'source' is a text of one line");
    CHECK(fault_of("[tables.materials.\" \"]\nsource = \"x\"\nE = \"1 GPa\"") == "1:19: the name of a row is one line");
    CHECK(fault_of("[tables.materials.M]\nsource = \"x\"").starts_with("1:19: 'M' has no value | available: "));
    CHECK(fault_of("[tables.materials]\nE = \"1 GPa\"") ==
          "2:1: 'E' is outside a row | a row is [tables.materials.NAME]");
    CHECK(fault_of("tables = 3") ==
          "1:1: 'tables' is a table of tables, not a number | a row is [tables.materials.NAME]");
  }

  TEST_CASE("sizes ascend, and only groups that have sizes take them") {
    CHECK(
        fault_of(row +
                 "by_size = [{ size_max = \"20 mm\", R_e = \"2 MPa\" }, { size_max = \"20 mm\", R_e = \"1 MPa\" }]") ==
        "3:65: sizes must be positive and ascending");
    CHECK(fault_of(row + "by_size = [{ R_e = \"2 MPa\" }]\nE = \"1 GPa\"") ==
          "3:12: 'size_max' is missing | values hold up to a size: size_max = \"16 mm\"");
    CHECK(fault_of("[tables.sections.S]\nsource = \"x\"\nA = \"1 cm^2\"\nby_size = []") ==
          "4:11: values of a section do not depend on a size");
  }

  TEST_CASE("tables in which nothing is looked up are refused") {
    CHECK(fault_of("[tables.material_s.M]\nE = \"1 GPa\"") ==
          "1:9: a project can have no tables 'material_s' of its own | did you mean 'materials'?");
    CHECK(fault_of("[tables.v_belts.M]\nh = \"1 mm\"")
              .starts_with("1:9: a project can have no tables 'v_belts' of its own | available: series, chains"));
  }

  TEST_CASE("two rows of a project never have the same name") {
    CHECK(fault_of(row + "E = \"1 GPa\"\n[tables.materials.N]\nE = \"1 GPa\"\nsource = \"x\"\naliases = [\"m\"]") ==
          "4:19: two rows of the project match the name 'm': 'M' and 'N' | take it out of one of them");
    CHECK(told(read(row + "E = \"1 GPa\"", {file}).issues) ==
          "0:0: two rows of the project match the name 'M': 'M' and 'M' | take it out of one of them");
  }

  TEST_CASE("a series of a project is a stock like the others") {
    const Own own = read("[tables.series.bars]\nunit = \"mm\"\nsizes = [20, 32]\nsource = \"store list\"\n");
    CHECK(told(own.issues).empty());
    const auto series = own.tables.find_series("bars");
    REQUIRE(series);
    CHECK(members_in_si(**series) == std::vector<double>{0.02, 0.032});
    CHECK(named_source(say("smallest of bars"), **series).text() ==
          "smallest of bars, own table of the project: store list");
    CHECK(own.tables.find_series("R40"));
    CHECK(fault_of("[tables.series.bars]\nunit = \"kg\"\nsizes = [32, 20]\nsource = \"x\"\nsize = 1") ==
          "2:9: sizes are lengths, not a mass | write a unit like mm or in\n"
          "3:9: sizes must be positive and ascending\n5:1: unknown key 'size' | did you mean 'sizes'?");
  }

  TEST_CASE("a file has the form of the built-in tables, and its sources go with its rows") {
    const Own own = read("", {file});
    CHECK(told(own.issues).empty());
    const auto entry = own.tables.find_row("material", "M");
    REQUIRE(entry);
    CHECK(named_source("M", *property(*entry, "R_e", 20 * mm)).text() ==
          "M, own table of the project: Mill certificate 4711");
    const auto with = [](std::string from, const std::string& to) {
      std::string text = file;
      return told(read("", {text.replace(text.find(from), from.size(), to)}).issues);
    };
    CHECK(with("E = \"GPa\"", "E_mod = \"GPa\"").find("E has no unit") == std::string::npos);
    CHECK(with("R_e = \"MPa\"", "R_e = \"mm\"") ==
          "3:29: R_e of 'material' is a stress, not a length | write a unit like MPa");
    CHECK(with("\"material\"", "\"v_belt\"").starts_with("2:10: a project can have no tables 'v_belt' of its own"));
    CHECK(with("E = 205", "E = nan").starts_with("6:5: E must be a number"));
    CHECK(with("R_e = 300", "R_e = -300").ends_with("R_e = -300 MPa: must be > 0"));
    CHECK(with("certificate = ", "certificat = ").starts_with("8:13: unknown source 'certificate'"));
    CHECK(told(read("", {"title = \"empty\"\n"}).issues).find("the file has no rows") != std::string::npos);
  }

  TEST_CASE("an expression names a value by table, row and column") {
    const Own own = read(row + "E = \"1 GPa\"");
    const auto value = [&](const char* path) { return own.tables.value_at(path); };
    CHECK(value("tables.materials.M.E")->value.si == 1e9);
    CHECK(value("tables.sections.\"IPE 330\".I_y")->value.si == doctest::Approx(11770e-8).epsilon(1e-3));
    CHECK(value("tables.materials.\"EN AW-6082-T6\".E")->dimension == value("tables.materials.S235JR.E")->dimension);
    const auto fault = [&](const char* path) {
      const Fault f = value(path).fault();
      return f.message.text() + " | " + f.hint.text();
    };
    CHECK(fault("tables.materials.S235") ==
          "'tables.materials.S235' is not a value of a table | write table, row and column, a row's name in quotes: "
          "tables.sections.\"IPE 330\".I_y");
    CHECK(fault("tables.section_s.M.E") == "unknown tables 'section_s' | did you mean 'sections'?");
    CHECK(fault("tables.sections.\"HEA 155\".A") ==
          "no section 'HEA 155' in the tables | did you mean 'HEA 140' or 'HEA 160'?");
    CHECK(fault("tables.materials.S235.e") == "the material 'S235' has no value 'e' | did you mean 'E'?");
    CHECK(fault("tables.materials.S235.R_e") ==
          "R_e of 'S235' depends on the size, which is not given | name the row in a step, which knows its size: "
          "material = \"S235\"");
  }
}
