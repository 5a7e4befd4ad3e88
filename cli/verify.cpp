#include "lib/project/verify.hpp"

#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "cli/inputs/missing_file.hpp"
#include "cli/output.hpp"
#include "cli/version.hpp"
#include "lib/export/json_writer.hpp"
#include "lib/export/unit_name.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/report/terminal/terminal.hpp"
#include "lib/report/verification.hpp"
#include "lib/text/embedded.hpp"
#include "lib/toml/tree.hpp"

#include <iostream>
#include <utility>

namespace loadpath::cli {

namespace {

struct Count {
  int holds = 0;
  int misses = 0;
};

/// The lines of one case; in brief, its name and count, and of its values those that miss.
void show(const report::VerifiedFile& file, bool in_full) {
  const project::Project& project = file.project;
  const std::vector<project::Comparison>& values = file.values;
  std::vector<project::Comparison> all = values;
  if (!in_full) {
    std::erase_if(all, [](const project::Comparison& c) { return c.holds; });
    const std::string count = std::to_string(values.size() - all.size()) + " of " + std::to_string(values.size());
    std::cout << terminal::columns({{all.empty() ? "ok" : "MISS", count, project.file, project.title}});
    if (all.empty()) return;
  }
  std::cout << project.file << (project.title.empty() ? "" : ": " + project.title) << "\n";
  std::vector<std::vector<std::string>> rows{{"  ", "quantity", "published", "computed", "deviation", "source"}};
  for (const project::Comparison& c : all) {
    rows.push_back({c.holds ? "  ok" : "  MISS", c.expectation->text, c.expectation->is_text, report::computed_text(c),
                    report::deviation_text(c), report::source_text(c)});
  }
  std::cout << terminal::columns(rows) << "\n";
}

void write(const report::VerifiedFile& file, exports::JsonWriter& out) {
  for (const project::Comparison& c : file.values) {
    const project::Expectation& e = *c.expectation;
    out.open_object();
    out.member("file", file.project.file);
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

/// Runs the cases, shows each as it comes, and keeps what a report is made of.
class Verification {
 public:
  /// `is_streamed`: a report goes to standard output, where no lines are shown then.
  Verification(const VerifyOptions& options, bool is_streamed) : options_(options), is_streamed_(is_streamed) {
    if (!options.json) return;
    writer_.open_object();
    writer_.key("cases").open_array();
  }

  /// False where it cannot be run, or expects nothing though it was asked for.
  bool run(const std::string& file, std::string_view text, bool asked_for) {
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
    report::VerifiedFile verified{std::move(project), {}};
    verified.values = project::compare(verified.project);
    for (const project::Comparison& c : verified.values) ++(c.holds ? count_.holds : count_.misses);
    if (options_.json)
      write(verified, writer_);
    else if (!is_streamed_)
      show(verified, asked_for || options_.full);
    if (!options_.reports.empty()) files_.push_back(std::move(verified));
    return true;
  }

  /// The counts, and the reports; the exit code.
  int finish() {
    const int code = count_.misses == 0 ? passed : not_passed;
    if (options_.json) {
      writer_.close_array();
      writer_.member("hold", count_.holds);
      writer_.member("miss", count_.misses);
      writer_.close_object();
      std::cout << writer_.take();
    } else if (!is_streamed_) {
      std::cout << count_.holds << " hold, " << count_.misses << " miss\n";
    }
    if (options_.reports.empty()) return code;
    const bool is_written =
        write_reports(report::verification(files_, program()), options_.reports, project::Project(), false);
    return is_written ? code : wrong_input;
  }

 private:
  const VerifyOptions& options_;
  bool is_streamed_;
  Count count_;
  exports::JsonWriter writer_;
  std::vector<report::VerifiedFile> files_;
};

}  // namespace

int verify(const VerifyOptions& options) {
  OutputOptions output;
  output.reports = options.reports;
  output.json = options.json;
  if (!can_write(output)) return wrong_input;
  Verification verification(options, takes_standard_output(output));
  bool ran = true;
  if (options.files.empty()) {
    for (const embedded::File& file : embedded::reference()) {
      // The others may need further files, which are not built in.
      if (file.text.find("[[expect]]") == std::string_view::npos) continue;
      ran = verification.run(std::string(file.name), file.text, false) && ran;
    }
  }
  for (const std::string& path : options.files) {
    std::string text;
    if (!toml::read_file(path, text)) {
      std::cerr << "loadpath: cannot read '" << path << "'\n  = help: " << help_for_file(path)
                << "; without a file all published cases are verified\n";
      return wrong_input;
    }
    ran = verification.run(path, text, true) && ran;
  }
  return ran ? verification.finish() : wrong_input;
}

}  // namespace loadpath::cli
