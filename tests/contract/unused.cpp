// An input that was given is used, or the step says that it was not.
#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "tests/contract/held.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

namespace {

using namespace loadpath;

/// "reference/columns.toml: e_y" of all inputs that are said to have no effect.
std::set<std::string> told() {
  std::set<std::string> all;
  for (const test::Known& known : test::known_projects()) {
    std::vector<Issue> issues;
    project::Project project = project::read_project(known.text, known.file, catalogue(), issues);
    project::solve(project, issues, {.pictures = false, .formulas = false});
    for (const Issue& issue : issues) {
      if (issue.message.text().find("has no effect") != std::string::npos) all.insert(known.name + ": " + issue.key);
    }
  }
  return all;
}

/// Inputs of the reference cases that are right to be told: the book gives them, and nothing comes of them.
const std::set<std::string> known{
    "reference/drives-khurmi.toml: half_path.shortening",  // the profile shifts make up for one another
    "reference/histories.toml: astm.counting",             // four points close the same loops
};

}  // namespace

TEST_SUITE("contract") {
  TEST_CASE("examples and reference cases give nothing that has no effect, but for what is known") {
    CHECK(told() == known);
  }
}
