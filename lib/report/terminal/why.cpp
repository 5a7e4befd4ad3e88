#include "lib/report/terminal/why.hpp"

#include "lib/report/terminal/look.hpp"
#include "lib/report/terminal/rows.hpp"
#include "lib/report/terminal/short.hpp"
#include "lib/report/terminal/terminal.hpp"
#include "lib/report/why.hpp"

#include <algorithm>
#include <iostream>

namespace loadpath::terminal {

namespace {

using account::Entry;
using account::Mode;
using project::Step;

void show_entries(const std::vector<const Entry*>& entries) {
  std::vector<Row> rows;
  rows.reserve(entries.size());
  for (const Entry* e : entries) rows.push_back({"  " + e->path, value_text(*e), e->origin.text.text()});
  std::cout << columns(rows);
}

void show_lines(const std::vector<account::Derived>& lines) {
  std::vector<Row> rows;
  rows.reserve(lines.size());
  for (const account::Derived& line : lines) rows.push_back(line_row(line, true));
  std::cout << columns(rows);
}

/// The entries of a path: the input, and the result of the same name if its value differs.
std::vector<const Entry*> entries_at(const Step& step, const std::string& path) {
  std::vector<const Entry*> found;
  for (const auto* entries : {&step.account().inputs, &step.account().results}) {
    for (const Entry& entry : *entries) {
      if (entry.path != path) continue;
      if (found.empty() || value_text(*found.back()) != value_text(entry)) found.push_back(&entry);
    }
  }
  return found;
}

const Mode* find_mode(const Step& step, const std::string& id) {
  const auto& modes = step.account().modes;
  const auto found = std::find_if(modes.begin(), modes.end(), [&](const Mode& m) { return m.id == id; });
  return found == modes.end() ? nullptr : &*found;
}

/// A failure mode, a value, or a mode of the calculator that does not concern this part; none if there is no
/// such.
std::vector<Row> rows_about(const Step& step, const std::string& name) {
  if (const Mode* const mode = find_mode(step, name)) return {mode_row(*mode, mode->id)};
  std::vector<Row> rows;
  for (const Entry* e : entries_at(step, name)) {
    const std::string from = e->origin.text.empty() ? std::string() : "; " + e->origin.text.text();
    rows.push_back({"  " + e->path, value_text(*e), e->doc + from});
  }
  if (!rows.empty()) return rows;
  for (const ModeInfo& mode : step.input().calculator->modes) {
    if (mode.id == name) rows.push_back({"  does not apply here", mode.id, mode.title});
  }
  return rows;
}

void show_reasons(const Step& step, const std::string& path) {
  const report::Reasons reasons = report::reasons_of(step.account(), path);
  if (!step.account().governing.empty() && !reasons.lines.empty())
    std::cout << "  calculated " << step.account().governing.text() << ":\n";
  show_lines(reasons.lines);
  if (reasons.inputs.empty()) return;
  std::cout << "from\n";
  show_entries(reasons.inputs);
}

/// Suggests similar names if there is no such result or mode.
void refuse(const Step& step, const std::string& path) {
  std::vector<std::string> known;
  for (const Mode& mode : step.account().modes) known.push_back(mode.id);
  for (const auto* entries : {&step.account().results, &step.account().inputs}) {
    for (const Entry& entry : *entries) known.push_back(entry.path);
  }
  std::cerr << "loadpath: '" << step.name() << "' has no result and no failure mode '" << path << "'\n";
  const std::string near =
      did_you_mean(path, known, say("`loadpath run FILE --full` lists them"), step.name() + ".").text();
  std::cerr << "  = help: " << near << "\n";
}

void show_head(const Step& step) {
  std::cout << step.name() << ": " << step.input().calculator->title << " (" << step.input().calculator->id << ")\n";
}

/// The mode that keeps the step from passing, if another was requested.
void show_obstacle(const Step& step, const std::string& asked) {
  const auto mode = report::deciding(step.account().modes);
  if (!mode || mode->id == asked || rank(mode->state) <= rank(account::State::open)) return;
  std::cout << "governs " << step.name() << "\n" << columns({mode_row(*mode, mode->id)});
}

}  // namespace

bool show_why(const project::Project& project, const Step& step, const std::string& of) {
  if (of.empty()) {
    std::cout << why_answer(report::summarise(project, step), step, look_of_output());
    return true;
  }
  const std::vector<Row> rows = rows_about(step, of);
  if (rows.empty()) {
    refuse(step, of);
    return false;
  }
  show_head(step);
  std::cout << columns(rows);
  const Mode* const mode = find_mode(step, of);
  show_reasons(step, mode != nullptr ? mode->governs : of);
  show_obstacle(step, of);
  return true;
}

}  // namespace loadpath::terminal
