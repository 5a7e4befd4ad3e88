#include "lib/export/json.hpp"

#include "tests/lib/project/texts.hpp"

#include <boost/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

using namespace loadpath;
using namespace loadpath::test;
namespace json = boost::json;

namespace {

json::value json_of(const std::string& text) {
  return json::parse(exports::json_of(told(text).project, "loadpath test"));
}

const std::string plain = axle + "T = \"2700 N*m\"\ntau_adm = \"30 MPa\"\n";

/// The list of numbers that is opened at `from`, null as NaN; each the nearest double, which not every parser finds.
std::vector<double> numbers_in(const std::string& text, std::size_t from) {
  std::vector<double> numbers;
  for (; text[from] != ']'; from = text.find_first_of(",]", from)) {
    const char* const first = text.data() + text.find_first_not_of("[, ", from);
    numbers.push_back(NAN);
    from =
        static_cast<std::size_t>(std::from_chars(first, text.data() + text.size(), numbers.back()).ptr - text.data());
  }
  return numbers;
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// The same bar where the driven link can turn.
std::string turning() {
  const std::string long_end = R"("0 mm", "-100 mm"])", short_end = R"("0 mm", "-20 mm"])";
  return replaced(replaced(bar_that_cannot_turn(36), long_end, short_end), long_end, short_end);
}

/// Whether a null has its reason next to it, everywhere in a value.
bool nulls_have_reasons(const json::value& v) {
  if (const auto* array = v.if_array()) {
    for (const auto& item : *array) {
      if (!nulls_have_reasons(item)) return false;
    }
  }
  const auto* object = v.if_object();
  if (object == nullptr) return true;
  for (const auto& [key, item] : *object) {
    const auto* list = item.if_array();
    const bool holed =
        list != nullptr && std::any_of(list->begin(), list->end(), [](const auto& x) { return x.is_null(); });
    if ((item.is_null() || holed) && !object->contains("reason")) return false;
    if (!nulls_have_reasons(item)) return false;
  }
  return true;
}

}  // namespace

TEST_SUITE("json") {
  TEST_CASE("a solved project is one object with a schema number") {
    const json::value v = json_of("[project]\ntitle = \"Drive \\\"7\\\"\"\nnumber = \"7\"\n" + plain);
    CHECK(v.at("schema") == 2);
    CHECK(v.at("program") == "loadpath test");
    CHECK(v.at("project").at("title") == "Drive \"7\"");
    CHECK(v.at("project").at("number") == "7");
    CHECK(v.at("verdict").at("state") == "pass");
    CHECK(v.at("verdict").at("modes").at(0).at("mode") == "yield");
    CHECK(v.at("verdict").at("modes").at(0).at("state") == "pass");
    CHECK(v.at("steps").as_array().size() == 1);
  }

  TEST_CASE("numbers are SI, with their unit, equal to the results to the bit") {
    const auto project = solved(plain);
    const json::value v = json::parse(exports::json_of(project, ""));
    const auto& results = v.at("steps").at(0).at("results").as_object();
    CHECK(results.at("d_min").at("value").as_double() == value(project, "axle.d_min"));
    CHECK(results.at("d_min").at("unit") == "m");
    CHECK(results.at("tau_max").at("value").as_double() == value(project, "axle.tau_max"));
    CHECK(results.at("tau_max").at("unit") == "Pa");
    CHECK(results.at("M_max").at("unit") == "N*m");
    CHECK(results.at("segments[1].tau").at("value").as_double() == value(project, "axle.segments[1].tau"));
  }

  TEST_CASE("inputs state their origin") {
    const json::value v = json_of(axle + "T = \"90 N*m\"\nS = 2\nmaterial = \"C45E\"\n");
    const auto& inputs = v.at("steps").at(0).at("inputs").as_object();
    CHECK(inputs.at("T").at("from") == "given");
    CHECK(inputs.at("R_e").at("from") == "C45E");
    CHECK(inputs.at("K_A").at("from") == "default");
    CHECK(inputs.at("d").at("from") == "smallest of R40 with which no assessed mode fails; 14 mm fails: u_tau = 1.181");
  }

  TEST_CASE("a check has value, limit and verdict") {
    const json::value v = json_of(plain);
    const auto& check = v.at("steps").at(0).at("checks").at(0);
    CHECK(check.at("name") == "u_tau");
    CHECK(check.at("verdict") == "pass");
    CHECK(check.at("limit") == "passes at 1 or less");
    CHECK(check.at("value").as_double() < 1.0);
  }

  TEST_CASE("the derivation has formula, given values and result") {
    const json::value v = json_of(plain);
    const auto& lines = v.at("steps").at(0).at("derivation").as_array();
    const auto found = std::find_if(lines.begin(), lines.end(), [](const auto& l) { return l.at("symbol") == "M_t"; });
    REQUIRE(found != lines.end());
    CHECK(found->at("given").as_object().contains("K_A"));
    CHECK(found->at("value").to_number<double>() == doctest::Approx(2700.0));
  }

  TEST_CASE("a value that is not available is null with a reason") {
    const json::value v = json_of(axle + test::no_torque + "tau_adm = \"30 MPa\"\n" + test::relay);
    CHECK(v.at("verdict").at("state") == "not available");
    const auto& check = v.at("steps").at(0).at("checks").at(0);
    CHECK(check.at("value").is_null());
    CHECK(check.at("reason") == "'T' is not available: = 1 N*m/(0*relay.u_tau)");
    CHECK(nulls_have_reasons(v));
  }

  TEST_CASE("extreme numbers leave valid JSON") {
    for (const char* lines :
         {"T = \"1e300 N*m\"\nK_A = 1e300\ntau_adm = \"1e-300 MPa\"\n", "T = \"0 N*m\"\ntau_adm = \"30 MPa\"\n",
          "T = \"1 N*m\"\nd = \"1e-300 mm\"\ntau_adm = \"1e-300 MPa\"\ntheta_adm = \"1e-300 rad/m\"\nG = \"1e-300 "
          "GPa\"\nl = \"1e300 m\"\n"}) {
      CAPTURE(lines);
      json::value v;
      CHECK_NOTHROW(v = json_of(axle + lines));
      CHECK(nulls_have_reasons(v));
    }
  }

  TEST_CASE("series read back to the bit") {
    const auto project = told(bar_that_cannot_turn(90)).project;
    const std::string text = exports::json_of(project, "");
    for (const auto& e : project.steps[0]->account().results) {
      if (!e.value.is_series()) continue;
      CAPTURE(e.path);
      const std::size_t entry = text.find("\"" + e.path + "\": {");
      REQUIRE(entry != std::string::npos);
      CHECK(same(numbers_in(text, text.find("\"values\": [", entry) + 11), e.value.si));
    }
  }

  TEST_CASE("series that are not chosen are left out, single values stay as they are") {
    const auto project = solved(turning());
    const json::value all = json::parse(exports::json_of(project, ""));
    const json::value some = json::parse(exports::json_of(project, "", project::SeriesChoice({"*.M"})));
    const auto &results = some.at("steps").at(0).at("results"), &before = all.at("steps").at(0).at("results");
    CHECK(results.at("drive.M") == before.at("drive.M"));
    CHECK(results.at("links.c.swing") == before.at("links.c.swing"));
    CHECK(some.at("steps").at(0).at("axes") == all.at("steps").at(0).at("axes"));
    CHECK_FALSE(results.as_object().contains("joints.A.F"));
    CHECK_FALSE(results.as_object().contains("links.a.omega"));
  }

  TEST_CASE("issues are an object too") {
    const json::value v = json::parse(exports::json_of(told(axle + "T = \"9 N\"\n").issues));
    CHECK(v.at("schema") == 2);
    const auto& issue = v.at("issues").at(0);
    CHECK(issue.at("file") == "a.toml");
    CHECK(issue.at("line") == 3);
    CHECK(issue.at("column") == 6);
    CHECK(issue.at("key") == "axle.T");
    CHECK(issue.at("severity") == "error");
    CHECK(issue.at("message") == "'9 N' is a force; a moment is expected");
    CHECK(issue.at("help") == "write a unit such as N*m");
  }

  TEST_CASE("two runs write the same bytes") {
    CHECK(exports::json_of(told(plain).project, "") == exports::json_of(told(plain).project, ""));
  }
}
