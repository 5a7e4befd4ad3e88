// An input that was given is used, or the step says that it was not.
#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/contract/held.hpp"
#include "tests/parts.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

namespace {

using namespace loadpath;

/// "reference/columns.toml: e_y" of all inputs of a project that are said to have no effect.
std::set<std::string> told(const test::Known& known) {
  std::set<std::string> all;
  std::vector<Issue> issues;
  project::Project project = project::read_project(known.text, known.file, catalogue(), issues);
  project::solve(project, issues, {.pictures = false, .formulas = false});
  for (const Issue& issue : issues) {
    if (issue.message.text().find("has no effect") != std::string::npos) all.insert(known.name + ": " + issue.key);
  }
  return all;
}

/// Inputs of the reference cases that are rightly reported: the book gives them, but they have no effect.
const std::set<std::string> right{
    "reference/bearing-kinds.toml: opposed_first.F_a",     // the induced axial load of the bearing itself governs
    "reference/columns-validated.toml: hss.b",             // buckling about the other axis governs, no wall is slender
    "reference/drives-khurmi.toml: half_path.shortening",  // the profile shifts make up for one another
    "reference/histories.toml: astm.counting",             // four points close the same loops
    "reference/histories.toml: astm_short.counting",
    "reference/histories.toml: pypi.counting",
};

std::set<std::string> right_for(const test::Known& known) {
  std::set<std::string> all;
  for (const std::string& input : right) {
    if (input.starts_with(known.name + ": ")) all.insert(input);
  }
  return all;
}

}  // namespace

TEST_SUITE("contract" * test::by_element) {
  TEST_CASE("examples and reference cases have no input without effect, except for the known ones") {
    std::size_t seen = 0;
    for (const test::Known& known : test::known_projects()) {
      if (!test::takes(test::elements_of_project(known.text).front())) continue;
      for (const std::string& input : told(known)) CHECK_MESSAGE(right_for(known).contains(input), input);
      for (const std::string& input : right_for(known)) CHECK_MESSAGE(told(known).contains(input), input);
      seen += right_for(known).size();
    }
    if (!test::is_part()) CHECK(seen == right.size());
  }
}
