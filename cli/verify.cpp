#include "lib/project/verify.hpp"

#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "cli/inputs/missing_file.hpp"
#include "lib/export/json_writer.hpp"
#include "lib/export/unit_name.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/terminal/terminal.hpp"
#include "lib/text/embedded.hpp"
#include "lib/toml/tree.hpp"

#include <cmath>
#include <iostream>

namespace loadpath::cli {

namespace {

struct Count {
  int holds = 0;
  int misses = 0;
};

/// Whether the result is the published value but for rounding.
bool is_same(const project::Comparison& c) { return std::abs(c.deviation) <= 1e-12; }

/// A part of the value; where it is zero, or has a tolerance in its own unit, the difference.
std::string deviation_of(const project::Comparison& c) {
  const project::Expectation& e = *c.expectation;
  if (std::isnan(c.deviation)) return "not available";
  const bool absolute = e.within_si || e.is.si == 0.0;
  if (is_same(c)) return format_quantity(0.0, absolute ? e.unit : "%", 2);
  return absolute ? format_quantity(c.ours - e.is.si, e.unit, 2) : format_quantity(c.deviation, "%", 2);
}

/// The lines of one case; in brief, its name and count, and of its values those that miss.
void show(const project::Project& project, const std::vector<project::Comparison>& values, bool in_full) {
  std::vector<project::Comparison> all = values;
  if (!in_full) {
    std::erase_if(all, [](const project::Comparison& c) { return c.holds; });
    const std::string count = std::to_string(values.size() - all.size()) + " of " + std::to_string(values.size());
    std::cout << terminal::columns({{all.empty() ? "ok" : "MISS", count, project.file, project.title}});
    if (all.empty()) return;
  }
  std::cout << project.file << (project.title.empty() ? "" : ": " + project.title) << "\n";
  std::vector<std::vector<std::string>> rows{{"  ", "quantity", "published", "ours", "deviation", "source"}};
  for (const project::Comparison& c : all) {
    const project::Expectation& e = *c.expectation;
    const int digits = e.digits ? std::max(*e.digits, 6) : 6;
    rows.push_back({c.holds ? "  ok" : "  MISS", e.text, e.is_text,
                    format_quantity(is_same(c) ? e.is.si : c.ours, e.unit, digits), deviation_of(c),
                    e.source + (e.note.empty() ? "" : "; " + e.note)});
  }
  std::cout << terminal::columns(rows) << "\n";
}

void write(const project::Project& project, const std::vector<project::Comparison>& all, exports::JsonWriter& out) {
  for (const project::Comparison& c : all) {
    const project::Expectation& e = *c.expectation;
    out.open_object();
    out.member("file", project.file);
    out.member("quantity", e.text);
    out.member("holds", c.holds);
    out.member("unit", exports::unit_name(e.is.dimension));
    out.member("published", e.is.si);
    out.member("ours", c.ours);
    out.member("as_printed", e.is_text);
    out.member("source", e.source);
    if (!e.note.empty()) out.member("note", e.note);
    out.close_object();
  }
}

/// One case: its lines, or its objects where JSON is written, and how many hold. False where it cannot be run, or
/// expects nothing though it was asked for.
bool verify_one(const std::string& file, std::string_view text, bool asked_for, bool in_full, Count& count,
                exports::JsonWriter* out) {
  std::vector<Issue> issues;
  project::Project project = project::read_project(text, file, catalogue(), issues);
  if (!has_errors(issues)) project::solve(project, issues, {.pictures = false, .formulas = false, .unused = false});
  if (has_errors(issues)) {
    terminal::show_issues(issues, {{file, std::string(text)}});
    return false;
  }
  if (project.expectations.empty()) {
    if (asked_for) std::cerr << "loadpath: '" << file << "' has no [[expect]] entry\n";
    return !asked_for;
  }
  const auto all = project::compare(project);
  for (const project::Comparison& c : all) ++(c.holds ? count.holds : count.misses);
  out != nullptr ? write(project, all, *out) : show(project, all, in_full);
  return true;
}

}  // namespace

int verify(const VerifyOptions& options) {
  Count count;
  bool ran = true;
  exports::JsonWriter writer;
  exports::JsonWriter* const out = options.json ? &writer : nullptr;
  if (out != nullptr) {
    out->open_object();
    out->key("cases").open_array();
  }
  if (options.files.empty()) {
    for (const embedded::File& file : embedded::reference()) {
      // The others may need further files, which are not built in.
      if (file.text.find("[[expect]]") == std::string_view::npos) continue;
      ran = verify_one(std::string(file.name), file.text, false, options.full, count, out) && ran;
    }
  }
  for (const std::string& path : options.files) {
    std::string text;
    if (!toml::read_file(path, text)) {
      std::cerr << "loadpath: cannot read '" << path << "'\n  = help: " << help_for_file(path)
                << "; without a file all published cases are verified\n";
      return wrong_input;
    }
    ran = verify_one(path, text, true, true, count, out) && ran;
  }
  if (!ran) return wrong_input;
  if (out != nullptr) {
    out->close_array();
    out->member("hold", count.holds);
    out->member("miss", count.misses);
    out->close_object();
    std::cout << out->take();
    return count.misses == 0 ? passed : not_passed;
  }
  std::cout << count.holds << " hold, " << count.misses << " miss\n";
  return count.misses == 0 ? passed : not_passed;
}

}  // namespace loadpath::cli
