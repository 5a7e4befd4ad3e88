#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "cli/files/commands.hpp"
#include "cli/inputs/missing_file.hpp"
#include "cli/solving.hpp"
#include "lib/export/json_writer.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/difference.hpp"
#include "lib/toml/tree.hpp"

#include <iostream>
#include <optional>

namespace loadpath::cli {

namespace {

using report::Difference;
using report::StepDifference;
using Row = std::vector<std::string>;

std::string name_of(const std::string& file) { return file == "-" ? "standard input" : file; }

/// A solved project; nothing, with its issues printed, if there is none.
std::optional<project::Project> solved(const std::string& file) {
  std::string text;
  if (!toml::read_file(file, text)) {
    std::cerr << "loadpath: cannot read '" << file << "'\n  = help: " << help_for_file(file) << "\n";
    return std::nullopt;
  }
  std::vector<Issue> issues;
  project::Project project = project::read_project(text, name_of(file), catalogue(), issues);
  if (!has_errors(issues)) project::solve(project, issues, {.pictures = false, .formulas = false});
  if (!has_errors(issues)) return project;
  terminal::show_issues(issues, with_files_of(project, {{name_of(file), text}}));
  return std::nullopt;
}

/// "+12.5 %"
std::string percent(double relative) { return (relative > 0.0 ? "+" : "") + format_number(100.0 * relative, 3) + " %"; }

/// The kind in the terminal; JSON keeps its own words.
std::string shown_kind(Difference::Kind kind) {
  if (kind == Difference::Kind::taken) return "linked";
  return kind == Difference::Kind::decides ? "governs" : report::word(kind);
}

Row row_of(const Difference& d) {
  const auto shown = [](const std::string& text) { return text.empty() ? std::string("none") : text; };
  Row row{"  " + shown_kind(d.kind), d.name, shown(d.before), "->", shown(d.after)};
  if (d.relative) row.push_back(percent(*d.relative));
  return row;
}

std::string heading_of(const StepDifference& step) {
  const std::string head = step.name + ": " + step.title + " (" + step.calculator + ")";
  if (step.change == StepDifference::Change::changed) return head;
  return head + (step.change == StepDifference::Change::added ? ", added: " : ", removed: ") + step.state;
}

/// A block for each step that differs; of results those that `run` shows, and how many more there are.
void show(const report::ProjectDifference& found, const DiffOptions& options) {
  std::cout << name_of(options.before) << " -> " << name_of(options.after) << "\n";
  if (found.none()) {
    std::cout << "no difference\n";
    return;
  }
  std::vector<Row> head;
  if (found.before != found.after) head.push_back({"  verdict", "", found.before, "->", found.after});
  for (const Difference& d : found.heading) head.push_back(row_of(d));
  std::cout << terminal::columns(head);
  for (const StepDifference& step : found.steps) {
    std::cout << "\n" << terminal::paragraph(heading_of(step), 2);
    std::vector<Row> rows;
    std::size_t more = 0;
    for (const Difference& d : step.differences) {
      const bool hidden = !d.brief && d.kind == Difference::Kind::result;
      hidden ? void(++more) : rows.push_back(row_of(d));
    }
    std::cout << terminal::columns(rows);
    if (more != 0) std::cout << "  " << more << (more == 1 ? " more result: --json\n" : " more results: --json\n");
  }
}

void write(const std::vector<Difference>& differences, exports::JsonWriter& out) {
  out.key("differences").open_array();
  for (const Difference& d : differences) {
    out.open_object();
    out.member("kind", report::word(d.kind));
    out.member("name", d.name);
    const auto text = [&](const char* key, const std::string& value) {
      value.empty() ? out.key(key).write_null() : out.member(key, value);
    };
    text("before", d.before);
    text("after", d.after);
    d.relative ? out.member("relative", *d.relative) : out.key("relative").write_null();
    out.close_object();
  }
  out.close_array();
}

std::string json_of(const report::ProjectDifference& found, const DiffOptions& options) {
  constexpr int schema_version = 1;  // version of this object
  exports::JsonWriter out;
  out.open_object();
  out.member("schema", schema_version);
  out.member("program", program());
  out.member("before", name_of(options.before));
  out.member("after", name_of(options.after));
  out.member("differ", !found.none());
  out.key("verdict").open_object();
  out.member("before", found.before);
  out.member("after", found.after);
  out.close_object();
  out.key("project").open_object();
  write(found.heading, out);
  out.close_object();
  out.key("steps").open_array();
  for (const StepDifference& step : found.steps) {
    out.open_object();
    out.member("name", step.name);
    out.member("calculator", step.calculator);
    out.member("change", step.change == StepDifference::Change::changed ? "changed"
                         : step.change == StepDifference::Change::added ? "added"
                                                                        : "removed");
    write(step.differences, out);
    out.close_object();
  }
  out.close_array();
  out.close_object();
  return out.take();
}

}  // namespace

int diff(const DiffOptions& options) {
  if (options.before == "-" && options.after == "-") {
    std::cerr << "loadpath: '-' is standard input, and cannot be both\n  = help: name a file for one of them\n";
    return wrong_input;
  }
  const auto before = solved(options.before), after = solved(options.after);
  if (!before || !after) return wrong_input;
  const report::ProjectDifference found = report::difference_of(*before, *after);
  if (options.json)
    std::cout << json_of(found, options);
  else
    show(found, options);
  return found.none() ? passed : not_passed;
}

}  // namespace loadpath::cli
