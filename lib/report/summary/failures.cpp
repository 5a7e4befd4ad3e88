#include "lib/quantity/format.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/summary/summary.hpp"
#include "lib/report/why.hpp"

#include <algorithm>

namespace loadpath::report {

namespace {

using account::Mode;
using account::Modes;

/// "width of the key / d (x_b = 0.45)": the meaning of the governing row, and its value where it is a single one.
std::string governing_row(const project::Step& step, const Mode& mode) {
  const auto& results = step.account().results;
  const auto row = std::ranges::find(results, mode.governs, &account::Entry::path);
  if (row == results.end()) return account::reason(mode).text();
  if (row->value.si.empty()) return row->doc;
  const std::string value = short_quantity(largest(row->value).value, row->unit);
  if (!mode.compared) return say("{1} ({2} = {3})", row->doc, row->path, value).text();
  return say("{1} ({2} = {3}: {4})", row->doc, row->path, value,
             short_pair(mode.compared->demand, mode.compared->capacity))
      .text();
}

/// What the calculator advises where the mode fails.
std::string advice_of(const project::Step& step, const Mode& mode) {
  const auto& modes = step.input().calculator->modes;
  const auto info = std::ranges::find_if(modes, [&](const ModeInfo& own) { return mode.id == own.id; });
  return info == modes.end() ? std::string() : std::string(info->advice);
}

}  // namespace

std::vector<std::string> failures_of(const project::Project& project, const Modes& modes) {
  std::vector<std::string> all;
  for (const Mode& mode : account::in_order(modes)) {
    const bool is_shown = mode.state == account::State::fail && mode.subject == account::Subject::mode;
    const project::Step* const step = project.find(mode.step);
    if (!is_shown || mode.utilisation || step == nullptr) continue;
    std::string text = spoken(mode.step) + ", " + plain_title(mode) + ": ";
    text += mode.note.empty() ? governing_row(*step, mode) : mode.note.text();
    if (const std::string advice = advice_of(*step, mode); !advice.empty()) text += "; " + advice;
    all.push_back(std::move(text));
  }
  return all;
}

}  // namespace loadpath::report
