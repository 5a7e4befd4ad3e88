#include "cli/lsp/diagnostics.hpp"

#include "lib/project/verify.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <tuple>

namespace loadpath::cli::lsp {

namespace {

using account::State;

/// "9:1: ..." for another file that the project is read from.
std::string text_of(const Issue& issue, bool elsewhere) {
  std::string text = issue.message.text();
  if (elsewhere)
    text = issue.place.file + ":" + std::to_string(issue.place.line) + ":" + std::to_string(issue.place.column) + ": " +
           text;
  const std::string hint = issue.hint.text();
  return hint.empty() ? text : text + "\nhelp: " + hint;
}

void add_issues(const OpenFile& file, std::vector<Diagnostic>& all) {
  for (const Issue& issue : file.issues) {
    const bool elsewhere = issue.place.file != file.name;
    all.push_back({elsewhere || issue.place.line < 1 ? Range{} : file.document.range_of(issue.place),
                   issue.severity == Severity::error ? Weight::error : Weight::warning, text_of(issue, elsewhere)});
  }
}

/// Whether an editor shows a failure mode: not if it passes, is accepted or is open.
bool is_told(State state) { return account::rank(state) > account::rank(State::open); }

std::string text_of(const account::Mode& mode) {
  std::string text = account::word(mode.state).text() + ": " + mode.id + ", " + mode.title.text();
  if (mode.utilisation) text += ", utilisation " + format_number(*mode.utilisation, 4);
  const std::string reason = account::reason(mode).text();
  return reason.empty() ? text : text + " (" + reason + ")";
}

/// Whether an issue has the same text; a step's warning may have no path in front of it.
bool is_issue(const std::string& warning, const std::vector<Issue>& issues) {
  return std::any_of(issues.begin(), issues.end(),
                     [&](const Issue& issue) { return warning.ends_with(issue.message.text()); });
}

void add_outcome(const OpenFile& file, const project::Step& step, std::vector<Diagnostic>& all) {
  const Range header = file.document.range_of(step.input().place);
  for (const account::Mode& mode : account::in_order(step.account().modes)) {
    if (!is_told(mode.state)) continue;
    all.push_back({header, mode.state == State::not_judged ? Weight::information : Weight::warning, text_of(mode)});
  }
  for (const Message& warning : step.account().warnings) {
    const std::string text = warning.text();
    if (!is_issue(text, file.issues)) all.push_back({header, Weight::warning, text});
  }
}

void add_misses(const OpenFile& file, std::vector<Diagnostic>& all) {
  for (const project::Comparison& c : project::compare(*file.project)) {
    if (c.holds) continue;
    const project::Expectation& e = *c.expectation;
    all.push_back({file.document.range_of(project::place_in(e.place, e.text, 0, e.text.size())), Weight::warning,
                   "expected " + e.is_text + ", found " + format_quantity(c.ours, e.unit)});
  }
}

}  // namespace

std::vector<Diagnostic> diagnostics_of(const OpenFile& file) {
  std::vector<Diagnostic> all;
  add_issues(file, all);
  if (file.is_solved) {
    for (const auto& step : file.project->steps) add_outcome(file, *step, all);
    add_misses(file, all);
  }
  std::stable_sort(all.begin(), all.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.range.start.line, a.range.start.character) <
           std::tie(b.range.start.line, b.range.start.character);
  });
  return all;
}

}  // namespace loadpath::cli::lsp
