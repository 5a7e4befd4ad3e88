// One step of a belt calculator from its text: read, solved, with its messages.
#pragma once

#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/calculators/step_text.hpp"

#include <string>
#include <vector>

namespace loadpath::test {

struct BeltStep {
  std::vector<Issue> issues;
  project::Project project;

  explicit BeltStep(const std::string& text)
      : project(project::read_project("[part]\n" + text, "part.toml", catalogue(), issues)) {
    if (!has_errors(issues)) project::solve(project, issues);
  }
  [[nodiscard]] double value(const std::string& key) const { return project.value("part." + key)->si[0]; }
  [[nodiscard]] bool says(const std::string& part) const {
    for (const Issue& issue : issues) {
      if ((issue.message.text() + " " + issue.hint.text()).find(part) != std::string::npos) return true;
    }
    return false;
  }
  [[nodiscard]] account::State worst() const { return account::worst(project::verdicts(project)); }
};

}  // namespace loadpath::test
