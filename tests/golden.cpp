// Reports of the examples, compared as text. A change of them is a decision: write the new text over the old with
//   loadpath run examples/NAME/project.toml --report tests/golden/NAME.md
#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/report/build/build.hpp"
#include "lib/toml/tree.hpp"
#include "tests/parts.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

using namespace loadpath;

std::string text_of(const std::string& path) {
  std::string text;
  REQUIRE(toml::read_file(std::string(LOADPATH_ROOT) + "/" + path, text));
  return text;
}

constexpr const char* examples[] = {"slotted-lever",    "line-shaft", "toggle-press",   "geared-press",  "cam-valve",
                                    "compressor",       "press-link", "conveyor-drive", "air-receiver",  "fan-belt",
                                    "shouldered-shaft", "gear-stage", "lift",           "gearbox-shaft", "load-history",
                                    "frame-column",     "gearbox"};

report::Document report_of(const std::string& name) {
  const std::string file = "examples/" + name + "/project.toml";
  std::vector<Issue> issues;
  project::Project project =
      project::read_project(text_of(file), std::string(LOADPATH_ROOT) + "/" + file, catalogue(), issues);
  project.file = file;  // as it is approved, wherever the repository lies
  project::solve(project, issues);
  REQUIRE(issues.empty());
  return report::build(project, "loadpath " LOADPATH_VERSION, report::Detail::normal, text_of(file));
}

}  // namespace

TEST_SUITE("golden" * test::by_case) {
  TEST_CASE("the reports of the examples are as they were approved") {
    for (const std::string name : examples) {
      CAPTURE(name);
      CHECK(report::markdown(report_of(name), name).text == text_of("tests/golden/" + name + ".md"));
    }
  }

  TEST_CASE("the page of a report is self-contained: no address to fetch, motion scripts only for moving parts") {
    for (const std::string name : examples) {
      const std::string page = report::html(report_of(name));
      const bool moves =
          text_of("examples/" + name + "/project.toml").find("\"mechanism.planar\"") != std::string::npos;
      CHECK((page.find("querySelectorAll(\".motion\")") != std::string::npos) == moves);
      CHECK(page.find("<script src") == std::string::npos);
      CHECK(page.find("src=\"http") == std::string::npos);
      CHECK(page.find("href=\"http") == std::string::npos);
      CHECK(page.find("url(http") == std::string::npos);
      for (const char* number : {">nan", " nan", "-nan", "\u2212nan"}) CHECK(page.find(number) == std::string::npos);
    }
  }

  TEST_CASE("a report is the same to the byte every time") {
    CHECK(report::html(report_of("slotted-lever")) == report::html(report_of("slotted-lever")));
  }
}
