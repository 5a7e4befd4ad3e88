// Rules that compare a step with the rest of its project, as tables: a row for each condition of a rule.
#pragma once

#include "lib/project/step.hpp"
#include "tests/calculators/step_text.hpp"
#include "tests/lib/project/texts.hpp"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::test {

/// A calculator's example with other lines, "key =" without one, as a part of a project.
inline std::string example_of(std::string_view calculator, const std::string& lines = "") {
  const project::CatalogueEntry* const entry = project::find_entry(catalogue(), calculator);
  REQUIRE(entry != nullptr);
  const std::string text = with_lines(entry->calculator->example, lines);
  return text.substr(text.find("\n[", 1) + 1) + "\n";
}

using Rule = std::vector<project::ReducedLoad> (*)(const project::Step&, const project::Project&);

/// The inputs of a step, the first one if no other is named, that a rule asks a reason for: "P", "T_1, n_1"; empty if
/// for none. The project has no errors.
inline std::string inputs_found(Rule rule, const std::string& text, const std::string& step = "") {
  const Told t = told(text);
  for (const Issue& issue : t.issues) CHECK_MESSAGE(issue.severity != Severity::error, issue.message.text());
  const project::Step* const asked = step.empty() ? t.project.steps.front().get() : t.project.find(step);
  REQUIRE(asked != nullptr);
  std::string inputs;
  for (const project::ReducedLoad& one : rule(*asked, t.project))
    inputs += (inputs.empty() ? "" : ", ") + (one.path.empty() ? "?" : one.path);
  return inputs;
}

/// The messages of a rule for the first step, one on each line.
inline std::string messages_of(Rule rule, const std::string& text) {
  const Told t = told(text);
  std::string all;
  for (const project::ReducedLoad& one : rule(*t.project.steps.front(), t.project)) all += one.message.text() + "\n";
  return all;
}

/// Entries of [values], and the inputs that a rule then asks a reason for.
struct ValuesRow {
  std::string values, inputs;
};

inline void check_values(Rule rule, const std::string& steps, std::initializer_list<ValuesRow> rows) {
  for (const ValuesRow& row : rows) {
    INFO(row.values);
    CHECK(inputs_found(rule, "[values]\n" + row.values + "\n\n" + steps) == row.inputs);
  }
}

/// The same of names that have one value: "wind", "snow", each " = 3".
inline void check_names(Rule rule, const std::string& steps, std::initializer_list<const char*> names,
                        const std::string& value, const std::string& inputs) {
  for (const std::string name : names) check_values(rule, steps, {{name + " = " + value, inputs}});
}

}  // namespace loadpath::test
