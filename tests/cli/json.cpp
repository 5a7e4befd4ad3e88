// Program data for other programs: --json of list, describe, tables and verify; and describe by parts.
#include "tests/cli/process.hpp"
#include "tests/tries.hpp"

#include <boost/json.hpp>

#include <cmath>

using namespace loadpath::test;

namespace {

namespace json = boost::json;

json::value told(const std::vector<std::string>& words) {
  const Ran ran = loadpath_with(words);
  CHECK(ran.code == 0);
  return json::parse(ran.out);  // no NaN, no infinity: it would throw
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_SUITE("knowledge as json") {
  TEST_CASE("list, and describe for every calculator in it") {
    const json::value all = told({"list", "--json"});
    const auto& calculators = all.at("calculators").as_array();
    CHECK(calculators.size() >= 46);
    Share share(6);
    for (const json::value& c : calculators) {
      if (share.skips()) continue;
      CAPTURE(c.at("id").as_string());
      const json::value one = told({"describe", c.at("id").as_string().c_str(), "--json"});
      CHECK(one.at("title") == c.at("title"));
      CHECK_FALSE(one.at("inputs").as_array().empty());
    }
    CHECK(told({"list", "shaft", "--json"}).at("calculators").as_array().size() < 20);
  }

  TEST_CASE("a field has its unit in SI, its bounds and its choices") {
    const json::value torsion = told({"describe", "shaft.torsion", "--json"});
    for (const json::value& field : torsion.at("inputs").as_array()) {
      if (field.at("key") != "tau_adm") continue;
      CHECK(field.at("unit") == "Pa");
      CHECK(field.at("type") == "quantity");
    }
    CHECK_FALSE(torsion.at("modes").as_array().empty());
  }

  TEST_CASE("tables: all, one, a row, a search, sizes") {
    CHECK(told({"tables", "--json"}).at("tables").as_array().size() > 20);
    CHECK(told({"tables", "sections/ipe", "--json"}).at("rows").as_array().size() == 18);
    const json::value steel = told({"tables", "materials", "C45E", "--json"});
    const json::value& row = steel.at("rows").as_array().at(0);
    CHECK(row.at("name") == "C45E");
    CHECK(row.at("values").at("E").at("unit") == "Pa");
    CHECK(row.at("values").at("E").at("value").to_number<double>() == doctest::Approx(210e9).epsilon(0.01));
    const json::value found = told({"tables", "sections", "--where", "h <= 100 mm", "--sort", "mass", "--json"});
    CHECK_FALSE(found.at("rows").as_array().empty());
    CHECK(told({"tables", "R40", "--json"}).at("members").as_array().size() > 20);
    CHECK(told({"tables", "--audit", "--json"}).at("recalled").is_array());
  }

  TEST_CASE("verify: each case with both values in SI") {
    const json::value all = told({"verify", "--json", LOADPATH_ROOT "/examples/slotted-lever/project.toml"});
    CHECK(all.at("miss") == 0);
    const auto& cases = all.at("cases").as_array();
    CHECK(cases.size() == 3);
    CHECK(cases.at(0).at("unit") == "N*m");
    CHECK(cases.at(0).at("published").to_number<double>() == doctest::Approx(86.085));
    CHECK(cases.at(0).at("ours").to_number<double>() == doctest::Approx(86.085).epsilon(1e-4));
  }

  TEST_CASE("describe by part: one input, the failure modes, the example") {
    const Ran loads = loadpath_with({"describe", "mechanism.planar", "loads"});
    CHECK(loads.code == 0);
    CHECK(contains(loads.out, "loads[].at"));
    CHECK_FALSE(contains(loads.out, "joints"));
    CHECK(contains(loadpath_with({"describe", "shaft.torsion", "modes"}).out, "twist"));
    CHECK(contains(loadpath_with({"describe", "shaft", "torsion", "example"}).out, "calculator = \"shaft.torsion\""));
    const Ran wrong = loadpath_with({"describe", "shaft.torsion", "mdoes"});
    CHECK(wrong.code == 2);
    CHECK(contains(wrong.error, "did you mean 'modes'?"));
  }

  TEST_CASE("similar names lead to the right command") {
    CHECK(contains(loadpath_with({"describe", "shaft"}).error, "shaft.torsion"));
    const Ran id = loadpath_with({"list", "shaft.torsion"});
    CHECK(id.code == 0);
    CHECK(id.out.starts_with("shaft.torsion "));
    CHECK(contains(loadpath_with({"describe", "torsion"}).error, "shaft.torsion"));
  }
}
