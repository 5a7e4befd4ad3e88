// A step of one calculator, solved from the lines of a project file.
#pragma once

#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/report/build/build.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

namespace loadpath::test {

class SolvedStep {
 public:
  SolvedStep(const std::string& calculator, const std::string& lines)
      : project_(project::read_project("[part]\ncalculator = \"" + calculator + "\"\n" + lines, "part.toml",
                                       catalogue(), issues_)) {
    if (!has_errors(issues_)) project::solve(project_, issues_);
  }

  /// The SI value of a result or input.
  [[nodiscard]] double operator()(const std::string& path) const {
    REQUIRE(!has_errors(issues_));
    const Value* const value = project_.value("part." + path);
    return value == nullptr ? std::nan("") : value->si[0];
  }
  /// The word of a choice.
  [[nodiscard]] std::string word(const std::string& path) const {
    for (const account::Entry& entry : project_.steps[0]->account().results) {
      if (entry.path == path) return entry.word;
    }
    return {};
  }
  /// The first error, with its field: "v_B: ..."; empty if nothing is wrong.
  [[nodiscard]] std::string fault() const {
    for (const Issue& issue : issues_) {
      if (issue.severity == Severity::error) return issue.key + ": " + issue.message.text();
    }
    return "";
  }
  [[nodiscard]] account::State worst() const { return account::worst(project::verdicts(project_)); }

 private:
  std::vector<Issue> issues_;
  project::Project project_;
};

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
inline bool near(double value, double expected, double relative = 1e-9) {
  return std::abs(value - expected) <= relative * std::abs(expected);
}

/// Lines that a calculator refuses, and its message.
struct Refused {
  const char* lines;
  const char* says;
};

template <std::size_t count>
void check_refusals(const std::string& calculator, const Refused (&rows)[count]) {
  for (const Refused& row : rows) {
    CAPTURE(row.lines);
    const std::string fault = SolvedStep(calculator, row.lines).fault();
    CAPTURE(fault);
    CHECK(contains(fault, row.says));
  }
}

}  // namespace loadpath::test
