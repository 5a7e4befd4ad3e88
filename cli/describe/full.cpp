#include "cli/describe/full.hpp"

#include "cli/describe/rows.hpp"
#include "cli/describe/templates.hpp"
#include "lib/project/parts/heading.hpp"
#include "lib/report/appendix.hpp"
#include "lib/report/terminal/terminal.hpp"
#include "lib/table/library.hpp"
#include "lib/table/table.hpp"

#include <algorithm>
#include <array>
#include <iostream>

namespace loadpath::cli {

std::string assessor_of(const ModeInfo& mode) {
  if (*mode.checks != '\0') return mode.checks;
  if (*mode.judge != '\0') return std::string("add a step of ") + mode.judge;
  if (*mode.wants != '\0') return std::string("give ") + mode.wants;
  if (*mode.use != '\0') return std::string("use ") + mode.use;
  if (*mode.add != '\0') return std::string("add a step of ") + mode.add;
  return "no calculator assesses it";
}

namespace {

using report::keys_in;

/// The inputs that a row of a table fills: "E, R_e at the size of t".
std::string filled_by(const Calculator& calculator, std::string_view group) {
  std::string all;
  for (const FieldInfo& field : calculator.input->fields) {
    const Provider& from = field.provider;
    if (from.kind != Provider::Kind::table || from.table != group) continue;
    all += (all.empty() ? "" : ", ") + std::string(field.key);
    if (*from.size != '\0') all += std::string(" (at the size ") + from.size + ")";
  }
  return all;
}

/// The keys of a step other than the fields of its calculator.
void show_keys(const Calculator& calculator) {
  Rows rows{{"  calculator", "word", "required", std::string(calculator.id)}};
  if (!calculator.templates.empty())
    rows.push_back({"  template", "word", "optional", "a standard mechanism, by its parameters: see below"});
  for (const std::string& group : table_groups(calculator)) {
    rows.push_back({"  " + group, "name", "optional",
                    "a row of `loadpath tables`, or of [tables." + group +
                        "s] in the file; fills in, if not given: " + filled_by(calculator, group)});
  }
  rows.push_back({"  title, note", "text", "optional", "for the report"});
  if (calculator.result != nullptr)
    rows.push_back({"  display", "table", "optional", "units of results: display = { KEY = \"in\" }"});
  if (!calculator.modes.empty())
    rows.push_back({"  accept", "table", "optional",
                    "failure modes accepted by the user: accept.MODE = \"reason\" (modes listed below)"});
  if (calculator.result != nullptr)
    rows.push_back({"  because", "table", "optional",
                    "reason why a typed value is more favourable than its row or record: because.KEY = \"reason\""});
  std::cout << "Further keys of the step\n"
            << terminal::columns(rows)
            << terminal::paragraph("  The file itself may have [project] with " + joined(project::heading_names()) +
                                       ", and [[expect]] with reference values.",
                                   2)
            << "\n";
}

/// Results whose paths come from the names in a project file.
void show_patterns(std::span<const ResultPattern> patterns) {
  Rows rows;
  for (const ResultPattern& p : patterns) {
    const std::string where = *p.where == '\0' ? "" : std::string(" (") + p.where + ")";
    rows.push_back({std::string("  ") + p.path, p.unit, p.doc + where});
  }
  std::cout << "Results, NAME as in the project file\n" << terminal::columns(rows) << "\n";
}

/// The failure modes of the part, and what assesses each.
void show_modes(const Calculator& calculator) {
  Rows rows;
  for (const ModeInfo& mode : calculator.modes) {
    rows.push_back({std::string("  ") + mode.id, mode.title, assessor_of(mode)});
  }
  if (rows.empty()) return;
  std::cout << "Failure modes and their checks; accept.MODE = \"reason\" accepts one that is not assessed\n"
            << terminal::columns(rows) << "\n";
}

void show_sources(const Calculator& calculator) {
  for (const std::string& key : keys_in(calculator.source))
    std::cout << terminal::paragraph("[" + key + "] " + table::citation(key), 2);
  for (const std::string& key : calculator.used_sources())
    std::cout << terminal::paragraph("[" + key + "] where it is used: " + table::citation(key), 2);
  std::cout << "\n";
}

void show_rules(const Calculator& calculator) {
  for (const RuleInfo& rule : calculator.rules)
    std::cout << terminal::paragraph("  rule (" + std::string(rule.fields) + "): " + rule.text, 2);
  if (!calculator.rules.empty()) std::cout << "\n";
}

void show_inputs(const Calculator& c) { show_type("Inputs", *c.input); }

void show_results(const Calculator& c) {
  if (c.result != nullptr) show_type("Results", *c.result);
  if (const auto patterns = c.patterns(); !patterns.empty()) show_patterns(patterns);
}

void show_example(const Calculator& c) { std::cout << "Example, a project file that runs:\n\n" << c.example; }

struct Part {
  const char* name;
  void (*show)(const Calculator&);
};
constexpr std::array parts{Part{"inputs", show_inputs},       Part{"keys", show_keys},
                           Part{"templates", show_templates}, Part{"rules", show_rules},
                           Part{"results", show_results},     Part{"modes", show_modes},
                           Part{"sources", show_sources},     Part{"example", show_example}};

}  // namespace

void show_in_full(const Calculator& c) {
  std::cout << c.id << ": " << c.title << "\n\n" << terminal::paragraph(c.scope) << "\n";
  show_sources(c);
  show_inputs(c);
  show_keys(c);
  if (!c.templates.empty()) show_templates(c);
  show_rules(c);
  show_results(c);
  show_modes(c);
  show_example(c);
}

std::vector<std::string> part_names() {
  std::vector<std::string> names;
  names.reserve(parts.size());
  for (const Part& part : parts) names.emplace_back(part.name);
  return names;
}

bool show_part(const Calculator& calculator, std::string_view name) {
  const auto part = std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return name == p.name; });
  if (part == parts.end()) return false;
  std::cout << calculator.id << ": " << calculator.title << "\n\n";
  part->show(calculator);
  return true;
}

}  // namespace loadpath::cli
