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

  TEST_CASE("what does not exist is told with the nearest one") {
    const Ran table = loadpath_with({"tables", "matterials"}), row = loadpath_with({"tables", "materials", "C54E"});
    CHECK(table.code == 2);
    CHECK(table.error == "loadpath: there is no table 'matterials'\n  = help: did you mean 'materials'?\n");
    CHECK(row.code == 2);
    CHECK(row.error == "loadpath: there is no material 'C54E' in the tables\n  = help: did you mean 'C45E'?\n");
  }
}
