// Steps as text: the example of a calculator with other values of some keys, read and solved.
#pragma once

#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/report/build/build.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::test {

/// The text with another value of one key, or without it where the value is empty. A value of several lines ends before
/// the first that is neither indented nor a bracket.
inline std::string with(std::string text, const std::string& key, const std::string& value) {
  const std::size_t at = text.find("\n" + key + " = ");
  const std::string line = value.empty() ? "" : "\n" + key + " = " + value;
  if (at == std::string::npos) return text + (value.empty() ? "" : key + " = " + value + "\n");
  std::size_t end = text.find('\n', at + 1);
  while (end + 1 < text.size() && (text[end + 1] == ' ' || text[end + 1] == ']')) end = text.find('\n', end + 1);
  return text.replace(at, end - at, line);
}

/// The same for lines of "key = value"; "key =" takes the key out.
inline std::string with_lines(std::string text, const std::string& lines) {
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    const std::size_t equals = line.find(" =");
    REQUIRE_MESSAGE(equals != std::string::npos, line);
    text = with(std::move(text), line.substr(0, equals), line.substr(std::min(equals + 3, line.size())));
  }
  return text;
}

/// A calculator's example with other lines: its results, derivation and verdicts.
class ExampleStep {
 public:
  ExampleStep(std::string_view calculator, const std::string& lines)
      : project_(
            project::read_project(with_lines(find(calculator).example, lines), "part.toml", catalogue(), issues_)) {
    if (!has_errors(issues_)) project::solve(project_, issues_, {.pictures = false, .unused = false});
    for (const Issue& issue : issues_) {
      if (issue.severity == Severity::error) fault_ += issue.key + ": " + issue.message.text() + "\n";
    }
  }

  /// The error in the lines; empty if there is none.
  [[nodiscard]] const std::string& fault() const { return fault_; }
  /// The SI value of a result, or of a line of the derivation: "axes[1].sigma_max".
  [[nodiscard]] double operator()(const std::string& path) const {
    REQUIRE_MESSAGE(fault_.empty(), fault_);
    const Value* const value = project_.value(project_.steps[0]->name() + "." + path);
    if (value != nullptr) return value->si[0];
    for (const account::Derived& line : project_.steps[0]->account().derivation) {
      if ((line.scope.empty() ? "" : line.scope + ".") + line.step.symbol == path) return line.step.value.si;
    }
    FAIL(path, " is no result, nor a line of the derivation");
    return 0.0;
  }
  [[nodiscard]] const project::Project& project() const { return project_; }
  [[nodiscard]] account::State verdict(std::string_view symbol) const {
    REQUIRE_MESSAGE(fault_.empty(), fault_);
    for (const account::Verdict& verdict : project::verdicts(project_)) {
      if (verdict.symbol == symbol) return verdict.state;
    }
    return account::State::not_available;
  }

 private:
  static const Calculator& find(std::string_view id) {
    for (const Calculator* c : calculators()) {
      if (c->id == id) return *c;
    }
    FAIL(std::string(id), " is no calculator");
    return *calculators()[0];
  }

  std::vector<Issue> issues_;
  project::Project project_;
  std::string fault_;
};

}  // namespace loadpath::test
