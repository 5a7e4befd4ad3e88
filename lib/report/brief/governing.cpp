#include "lib/report/brief/governing.hpp"

#include "lib/formula/formula.hpp"
#include "lib/numerics/magnitude.hpp"
#include "lib/report/brief/names.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/why.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::report {

namespace {

using account::Entry;
using account::Mode;
using account::State;
using project::Project;

bool is_shown(const Mode& mode) {
  return is_told(mode) && (mode.state == State::fail || (mode.state == State::pass && mode.utilisation));
}

bool is_before(const Governing& a, const Governing& b) {
  const bool fails = a.mode.state == State::fail, other = b.mode.state == State::fail;
  if (fails != other) return fails;
  return numerics::exceeds(a.mode.utilisation.value_or(-1.0), b.mode.utilisation.value_or(-1.0));
}

bool is_same(const Mode& a, const Mode& b) { return a.step == b.step && a.id == b.id; }

std::string name_in(const Project& project, const std::string& step) {
  const project::Step* const found = project.find(step);
  return found == nullptr ? spoken(step) : component_name(*found);
}

/// Whether the last line of the reasons contains an input.
bool is_in_last_line(const Reasons& reasons, const Entry& entry) {
  if (reasons.lines.empty()) return false;
  const std::string name = entry.path.substr(entry.path.rfind('.') + 1);
  return std::ranges::any_of(reasons.lines.back().step.given, [&](const auto& given) { return given.name == name; });
}

/// The required safety factor that the last line of a check contains; null if there is none.
const Entry* required_safety(const Reasons& reasons) {
  for (const Entry* const entry : reasons.inputs) {
    const bool is_safety = entry->is_factor && entry->doc.find("safety factor") != std::string::npos;
    if (is_safety && !entry->values().si.empty() && is_in_last_line(reasons, *entry)) return entry;
  }
  return nullptr;
}

/// The allowable value that the last line compares with: a symbol that ends with "_adm".
std::string allowable_of(const Reasons& reasons) {
  if (reasons.lines.empty()) return {};
  for (const account::Step::Given& given : reasons.lines.back().step.given) {
    const bool is_allowable = given.name.find("_adm") != std::string::npos;
    if (is_allowable) return formula::symbol_plain(given.name);
  }
  return {};
}

/// The actual and the required safety factor of a mode; nothing if its check contains none.
struct Safety {
  double actual, required;
};
std::optional<Safety> safety_of(const Reasons& reasons, const Mode& mode) {
  const Entry* const required = required_safety(reasons);
  if (required == nullptr) return std::nullopt;
  const double factor = required->values().si.front();
  return Safety{factor / *mode.utilisation, factor};
}

/// "2, passes up to 1": the value of a limit that is not kept, with its bounds; else why the mode fails.
std::string bounded_text(const std::vector<account::Verdict>& rows, const Mode& mode) {
  const auto row = std::ranges::find(rows, mode.governs, &account::Verdict::symbol);
  const auto* const value = row == rows.end() ? nullptr : std::get_if<account::Quantity>(&row->value);
  if (value == nullptr || !std::isfinite(value->si)) return account::reason(mode).text();
  return say("{1}, {2}", short_quantity(value->si, value->unit), row->bound).text();
}

/// The values that the check compares; of safety factors the required one, and the actual one.
std::string compared_text(const Project& project, const Mode& mode) {
  if (mode.compared) return unbroken(short_pair(mode.compared->demand, mode.compared->capacity));
  const project::Step* const step = project.find(mode.step);
  if (!mode.utilisation && step != nullptr) return bounded_text(step->account().verdicts, mode);
  if (!mode.utilisation || !(*mode.utilisation > 0.0) || step == nullptr)
    return mode.utilisation ? std::string() : account::reason(mode).text();
  const auto safety = safety_of(reasons_of(step->account(), mode.governs), mode);
  return safety ? unbroken(short_number(safety->required) + " / " + safety_number(safety->actual)) : std::string();
}

/// "gear 1" is not broken between lines.
std::string numbers_kept(std::string text) {
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1)) {
    if (at + 1 < text.size() && '0' <= text[at + 1] && text[at + 1] <= '9') text.replace(at, 1, "\u00A0");
  }
  return text;
}

}  // namespace

std::string mode_name(const Mode& mode) {
  const std::string location = location_of(mode), title = plain_title(mode);
  const bool says_so = location.empty() || title.find(location) != std::string::npos;
  return numbers_kept(says_so ? title : title + ", " + location);
}

std::vector<Governing> governing_modes(const Project& project, const Summary& summary, std::size_t most) {
  std::vector<Governing> rows, rest;
  for (const Component& component : summary.components) {
    if (component.governing && is_shown(*component.governing)) rows.push_back({component.name, *component.governing});
  }
  for (const Mode& mode : summary.modes) {
    const bool known = std::ranges::any_of(rows, [&](const Governing& row) { return is_same(row.mode, mode); });
    if (!known && is_shown(mode)) rest.push_back({name_in(project, mode.step), mode});
  }
  std::ranges::stable_sort(rest, is_before);
  const auto failing = std::ranges::find_if(rest, [](const Governing& row) { return row.mode.state != State::fail; });
  rows.insert(rows.end(), rest.begin(), failing);
  std::ranges::stable_sort(rows, is_before);
  rows.insert(rows.end(), failing, rest.end());
  rows.resize(std::min(rows.size(), most));
  std::ranges::stable_sort(rows, is_before);
  return rows;
}

Message share_shown(const Summary& summary, std::size_t shown) {
  const auto assessed = static_cast<std::size_t>(std::ranges::count_if(
      summary.modes, [](const Mode& mode) { return account::is_counted(mode) && mode.utilisation.has_value(); }));
  const std::string some = std::to_string(shown), all = std::to_string(assessed);
  return assessed == shown ? say("{1} of {2} with a utilisation", some, all)
                           : say("{1} of {2} with a utilisation, rest: appendix", some, all);
}

std::string safety_text(const Project& project, const Mode& mode) {
  const project::Step* const step = project.find(mode.step);
  if (step == nullptr || !mode.utilisation || !(*mode.utilisation > 0.0)) return {};
  const Reasons reasons = reasons_of(step->account(), mode.governs);
  if (const auto safety = safety_of(reasons, mode))
    return unbroken(safety_number(safety->actual) + " / " + short_number(safety->required));
  if (const std::string allowable = allowable_of(reasons); !allowable.empty())
    return unbroken(say("in {1}", allowable).text());
  return unbroken(safety_number(1.0 / *mode.utilisation) + " / 1");
}

Table governing_table(const Project& project, const std::vector<Governing>& rows, bool has_titles) {
  constexpr double most_letters = 18.0;
  Table table{
      {},
      {say("Component"), say("Failure mode"), say("Demand / capacity"), say("Safety / required"), say("Utilisation")},
      {}};
  for (const Governing& row : rows) {
    const Cell used = row.mode.utilisation ? Cell(Utilisation{*row.mode.utilisation}) : Cell(row.mode.state);
    std::string name = has_titles ? titled(project, row.component, most_letters) : row.component;
    table.rows.push_back(
        {std::move(name), mode_name(row.mode), compared_text(project, row.mode), safety_text(project, row.mode), used});
  }
  return table;
}

}  // namespace loadpath::report
