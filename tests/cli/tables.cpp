#include "tests/cli/process.hpp"

using namespace loadpath::test;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_SUITE("cli tables") {
  TEST_CASE("without a name there is an index, with a name its rows") {
    CHECK(contains(loadpath_with({"tables"}).out, "materials/steel_heat_treatable"));
    CHECK(contains(loadpath_with({"tables", "materials"}).out, "C45E"));
    CHECK(contains(loadpath_with({"tables", "R40"}).out, "42.5"));
  }

  TEST_CASE("a row shows its sources") {
    const Ran o = loadpath_with({"tables", "materials", "c45e"});
    CHECK(o.code == 0);
    CHECK(contains(o.out, "EN 10083"));
    CHECK(contains(o.out, "["));
  }

  TEST_CASE("the audit counts values without a seen source") {
    const Ran o = loadpath_with({"tables", "--audit"});
    CHECK(o.code == 0);
    CHECK(o.out.ends_with(" values without a seen source\n"));
  }

  TEST_CASE("a name that does not exist is reported with the nearest one") {
    const Ran table = loadpath_with({"tables", "matterials"}), row = loadpath_with({"tables", "materials", "C54E"});
    CHECK(table.code == 2);
    CHECK(table.error == "loadpath: unknown table 'matterials'\n  = help: did you mean 'materials'?\n");
    CHECK(row.code == 2);
    CHECK(row.error == "loadpath: no material 'C54E' in the tables\n  = help: did you mean 'C45E'?\n");
  }

  TEST_CASE("a row, a part of a name, and a folder that is also a series are distinguished") {
    CHECK(
        contains(loadpath_with({"tables", "C45E"}).error, "`loadpath tables materials/steel_heat_treatable \"C45E\"`"));
    CHECK(contains(loadpath_with({"tables", "ribbed_belt"}).error, "its rows are in `loadpath tables belt/"));
    CHECK(contains(loadpath_with({"tables", "HEA"}).error, "available: sections/hea\n"));
    CHECK(contains(loadpath_with({"tables", "steel"}).error, "materials/steel_structural"));
    const Ran both = loadpath_with({"tables", "bearing"});
    CHECK(contains(both.out, "bearing/62 "));
    CHECK(contains(both.out, "shaft/diameters bearing"));
    CHECK(contains(loadpath_with({"tables", "bearing", "6208"}).out, "bearing/62)"));
  }

  TEST_CASE("sections are searched by conditions and sorted") {
    const Ran o = loadpath_with({"tables", "sections/ipe", "--where", "I_min >= 300 cm^4", "--sort", "mass"});
    CHECK(o.code == 0);
    CHECK(contains(o.out, "name     m [kg/m]  I_min [cm⁴]"));
    CHECK(contains(o.out, "IPE 270"));
    CHECK_FALSE(contains(o.out, "IPE 240"));
    CHECK(contains(o.out, "9 of 18 rows"));
  }

  TEST_CASE("a search of metric and customary tables shows metric units") {
    const Ran o =
        loadpath_with({"tables", "sections", "--where", "I_min >= 300 cm^4 and h <= 200 mm", "--sort", "weight"});
    CHECK(o.code == 0);
    CHECK(contains(o.out, "m [kg/m]"));
    CHECK(contains(o.out, "h [mm]"));
    CHECK_FALSE(contains(o.out, "[in"));
  }

  TEST_CASE("a condition that cannot be read is marked at its word") {
    const Ran o = loadpath_with({"tables", "sections", "--where", "h > 100 mm and I_mni > 3 cm^4"});
    CHECK(o.code == 2);
    CHECK(contains(o.error, "--where:1:16: error: unknown column 'I_mni' in these tables"));
    CHECK(contains(o.error, "did you mean 'I_min'?"));
    CHECK(loadpath_with({"tables", "sections", "--sort", "mas"}).code == 2);
    CHECK(loadpath_with({"tables", "--where", "h > 1 mm"}).code == 2);
  }

  TEST_CASE("a search of one row, or of something that is not a table, is refused") {
    CHECK(loadpath_with({"tables", "sections", "hea", "--sort", "mass"}).error ==
          "loadpath: a search is over all rows, and 'hea' would be one of them\n"
          "  = help: search the part: loadpath tables sections/hea\n");
    CHECK(loadpath_with({"tables", "sections", "HEB 200", "--where", "h > 300 mm"}).code == 2);
    CHECK(contains(loadpath_with({"tables", "module", "--where", "m > 2 mm"}).error, "and 'module' is not a table"));
  }
}
