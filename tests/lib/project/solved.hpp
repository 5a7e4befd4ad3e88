// A project as its text, solved if permitted: its issues and results.
#pragma once

#include "calculators/catalogue.hpp"
#include "lib/project/modes.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace loadpath::test {

struct Solved {
  explicit Solved(const std::string& text) {
    project = project::read_project(text, "part.toml", catalogue(), issues);
    if (!has_errors(issues)) project::solve(project, issues);
    all = project::modes(project);
  }
  /// "gears.z_1: must be > 0 = a hint", a line each.
  [[nodiscard]] std::string messages(Severity least = Severity::warning) const {
    std::string text;
    for (const Issue& issue : issues) {
      if (least == Severity::warning || issue.severity == Severity::error)
        text += issue.key + ": " + issue.message.text() + " = " + issue.hint.text() + "\n";
    }
    return text;
  }
  [[nodiscard]] std::string errors() const { return messages(Severity::error); }
  /// The first value of a series.
  [[nodiscard]] double value(const std::string& path) const {
    const Value* const found = project.value(path);
    REQUIRE_MESSAGE(found != nullptr, path, "\n", messages());
    return found->si[0];
  }
  [[nodiscard]] std::string word(const std::string& path) const {
    const std::size_t dot = path.find('.');
    return project.find(path.substr(0, dot))->word(path.substr(dot + 1));
  }
  [[nodiscard]] std::string origin(const std::string& step, const std::string& path) const {
    for (const account::Entry& entry : project.find(step)->account().inputs) {
      if (entry.path == path) return entry.origin.text.text();
    }
    return "none";
  }
  /// "gears.root_1"; nullptr if it does not concern the part.
  [[nodiscard]] const account::Mode* find_mode(const std::string& name) const {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const account::Mode& m) { return m.step + "." + m.id == name; });
    return found == all.end() ? nullptr : &*found;
  }
  [[nodiscard]] bool has(const std::string& name) const { return find_mode(name) != nullptr; }
  [[nodiscard]] const account::Mode& mode(const std::string& name) const {
    const account::Mode* const found = find_mode(name);
    REQUIRE_MESSAGE(found != nullptr, name, "\n", messages());
    return *found;
  }
  project::Project project;
  std::vector<Issue> issues;
  account::Modes all;
};

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace loadpath::test
