// One step of a belt calculator from its text: read, solved, and what was said about it.
#pragma once

#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"

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
  [[nodiscard]] report::State worst() const { return report::worst(project::verdicts(project)); }
};

/// The text with another value of one key, or without it where the value is empty.
inline std::string with(std::string text, const std::string& key, const std::string& value) {
  const std::size_t at = text.find("\n" + key + " = ");
  const std::string line = value.empty() ? "" : "\n" + key + " = " + value;
  if (at == std::string::npos) return text + (value.empty() ? "" : key + " = " + value + "\n");
  return text.replace(at, text.find('\n', at + 1) - at, line);
}

}  // namespace loadpath::test
