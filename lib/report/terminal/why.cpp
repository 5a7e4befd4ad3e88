#include "lib/report/terminal/why.hpp"

#include "lib/report/terminal/rows.hpp"
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

/// The results of a step whose formulas are not lines: what a mechanism's solver gives.
bool show_result(const Step& step, const std::string& path) {
  for (const auto* entries : {&step.account().results, &step.account().inputs}) {
    for (const Entry& entry : *entries) {
      if (entry.path != path) continue;
      const std::string from = entry.origin.text.empty() ? std::string() : "; " + entry.origin.text.text();
      std::cout << columns({{"  " + entry.path, value_text(entry), entry.doc + from}});
      return true;
    }
  }
  return false;
}

const Mode* find_mode(const Step& step, const std::string& id) {
  const auto& modes = step.account().modes;
  const auto found = std::find_if(modes.begin(), modes.end(), [&](const Mode& m) { return m.id == id; });
  return found == modes.end() ? nullptr : &*found;
}

void show_reasons(const Step& step, const std::string& path) {
  const report::Reasons reasons = report::reasons_of(step.account(), path);
  if (!step.account().governing.empty() && !reasons.lines.empty())
    std::cout << "  worked out " << step.account().governing.text() << ":\n";
  show_lines(reasons.lines);
  if (reasons.inputs.empty()) return;
  std::cout << "from\n";
  show_entries(reasons.inputs);
}

/// Where there is no such result or mode: what may have been meant.
void refuse(const Step& step, const std::string& path) {
  std::vector<std::string> known;
  for (const Mode& mode : step.account().modes) known.push_back(mode.id);
  for (const auto* entries : {&step.account().results, &step.account().inputs}) {
    for (const Entry& entry : *entries) known.push_back(entry.path);
  }
  std::cerr << "loadpath: '" << step.name() << "' has no result and no mode of failure '" << path << "'\n";
  const std::string near = did_you_mean(path, known, say("`loadpath run` shows them"), step.name() + ".").text();
  std::cerr << "  = help: " << near << "\n";
}

}  // namespace

void show_deciding(const project::Project& project) {
  std::vector<Row> rows;
  for (const auto& step : project.steps) {
    const auto mode = report::deciding(step->account());
    if (!mode) continue;
    rows.push_back(mode_row(*mode, step->name()));
  }
  std::cout << columns(rows);
}

bool show_why(const Step& step, const std::string& of) {
  const Mode* named = of.empty() ? nullptr : find_mode(step, of);
  const auto mode = named != nullptr ? std::optional(*named)
                    : of.empty()     ? report::deciding(step.account())
                                     : std::nullopt;
  std::string path = mode ? mode->governs : of;
  std::cout << step.name() << ": " << step.input().calculator->title << " (" << step.input().calculator->id << ")\n";
  if (mode) std::cout << columns({mode_row(*mode, mode->id)});
  const auto chosen = report::chosen(step.account());
  if (of.empty() && !chosen.empty()) {
    std::cout << "chosen\n";
    show_entries(chosen);
  }
  if (!mode && !show_result(step, path)) {
    refuse(step, path);
    return false;
  }
  if (!path.empty()) show_reasons(step, path);
  return true;
}

}  // namespace loadpath::terminal
