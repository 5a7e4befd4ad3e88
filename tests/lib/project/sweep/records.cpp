// Whole records in turn: at each point the machine is the one for which that record is typed.
#include "lib/project/solving/read_project.hpp"
#include "tests/lib/project/solved.hpp"
#include "tests/lib/project/sweep/swept.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace loadpath;
using test::contains;
using test::Swept;

namespace {

std::string press(const std::string& crank) {
  return "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"40 mm\"\nl = \"160 "
         "mm\"\nlinks.slider.mass = \"5 kg\"\n" +
         crank;
}

const std::string slow = R"({ speed = "600 rpm", positions = 24 })";
const std::string fast = R"({ speed = "900 rpm", positions = 36 })";
const std::vector<std::string> results{"F = peak(press.joints.B.F)", "M = peak(press.drive.M)"};

/// What one machine says of the first result.
double alone(const std::string& crank) {
  const Swept swept(press("crank = " + crank + "\n"), results);
  REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
  REQUIRE(swept.column("F").size() == 1);
  return swept.column("F")[0];
}

}  // namespace

TEST_SUITE("records in turn") {
  TEST_CASE("are one input; each point is the machine of its record") {
    const Swept swept(press("crank = { each = [" + slow + ", " + fast + "] }\n"), results);
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    REQUIRE(swept.plan.inputs.size() == 1);
    const project::SweptInput& crank = swept.plan.inputs[0];
    CHECK(crank.name == "press.crank");
    CHECK(crank.words ==
          std::vector<std::string>{"speed = 600 rpm, positions = 24", "speed = 900 rpm, positions = 36"});
    REQUIRE(swept.column("F").size() == 2);
    CHECK(swept.column("F")[0] == alone(slow));
    CHECK(swept.column("F")[1] == alone(fast));
    CHECK(swept.column("F")[0] != swept.column("F")[1]);
  }

  TEST_CASE("have names where a table gives them, are crossed with other inputs, and may be of [values]") {
    const std::string text = "[values]\ndrives = { each = { slow = " + slow + ", fast = " + fast + " } }\n" +
                             press("crank = \"=values.drives\"\n") + "[project.sweep]\n";
    std::string two = text;
    two.replace(two.find("\"160 mm\""), 8, "[\"160 mm\", \"200 mm\"]");
    const Swept swept(two, results);
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    REQUIRE(swept.plan.inputs.size() == 2);
    CHECK(swept.column("F").size() == 4);
    const auto drives = std::find_if(swept.plan.inputs.begin(), swept.plan.inputs.end(),
                                     [](const auto& input) { return input.name == "values.drives"; });
    REQUIRE(drives != swept.plan.inputs.end());
    CHECK(drives->words == std::vector<std::string>{"slow", "fast"});
    const auto& l = swept.input("press.l");
    const auto& which = swept.input("values.drives");
    for (std::size_t i = 0; i < 4; ++i) {
      if (l[i] == 0.16) CHECK(swept.column("F")[i] == alone(which[i] == 0.0 ? slow : fast));
    }
  }

  TEST_CASE("of an element of a list, with lists in them") {
    const std::string tests_a = R"([["450 MPa", 42000], ["420 MPa", 88000], ["390 MPa", 205000], ["360 MPa", 520000]])";
    const std::string tests_b = R"([["460 MPa", 42000], ["430 MPa", 98000], ["400 MPa", 215000], ["370 MPa", 540000]])";
    const auto bars = [](const std::string& tests) {
      return "[bars]\ncalculator = \"fatigue.wohler\"\nP_s = 0.9\ntests = " + tests + "\n";
    };
    const Swept both(bars("{ each = { first = " + tests_a + ", second = " + tests_b + " } }"), {"bars.k"});
    REQUIRE_MESSAGE(both.errors().empty(), both.errors());
    const Swept first(bars(tests_a), {"bars.k"}), second(bars(tests_b), {"bars.k"});
    REQUIRE_MESSAGE(second.errors().empty(), second.errors());
    CHECK(both.column("bars.k") == std::vector<double>{first.column("bars.k")[0], second.column("bars.k")[0]});
  }

  TEST_CASE("that contradict each other are reported") {
    const auto errors = [](const std::string& crank) {
      return Swept(press("crank = " + crank + "\n"), results).errors();
    };
    CHECK(contains(errors("{ each = [" + slow + R"(, { speed = "900 rpm" }] })"),
                   "press.crank: records taken in turn must have the same fields"));
    CHECK(contains(errors("{ each = [" + slow + ", " + slow + "] }"), "these records do not differ in any number"));
    CHECK(contains(errors("{ each = [" + slow + R"(, { speed = ["1 rpm", "2 rpm"], positions = 24, x = 1 }] })"),
                   "'x' is not a valid key here"));
    CHECK(contains(errors("{ each = [" + slow + R"(, { speed = "=2*other.n", positions = 24 }] })"),
                   "values of records taken in turn must be written out"));
    CHECK(contains(errors("{ each = [" + slow + R"(, { speed = { mean = "1 rpm", sd = "5 %" }, positions = 24 }] })"),
                   "values of records taken in turn must be written out"));
  }

  TEST_CASE("run takes one of them, and reports it once") {
    std::vector<Issue> issues;
    project::read_project(press("crank = { each = [" + slow + ", " + fast + "] }\n"), "part.toml", catalogue(), issues);
    REQUIRE(issues.size() == 1);
    CHECK(contains(issues[0].message.text(), "these are 2 values; a single value is required"));
  }
}
