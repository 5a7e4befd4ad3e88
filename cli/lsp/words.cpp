#include "cli/lsp/words.hpp"

#include "lib/project/references/references.hpp"
#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/unit_table.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace loadpath::cli::lsp {

namespace {

/// Units that are not rows of the table of units, but products of them.
constexpr const char* composed[] = {
    "N*m",     "N*mm",      "kN*m",    "lbf*in", "lbf*ft", "N/mm",   "N/m",     "kN/m",      "mm^2",
    "cm^2",    "m^2",       "in^2",    "mm^3",   "cm^3",   "m^3",    "mm^4",    "cm^4",      "m^4",
    "kg/m",    "kg/m^3",    "g/cm^3",  "m/s",    "km/h",   "m/s^2",  "mm/s",    "rad/s",     "deg/s",
    "rad/s^2", "kg*m^2",    "kg*cm^2", "1/min",  "1/s",    "N*s/m",  "N*m/rad", "N*m*s/rad", "MPa*m/s",
    "W/(m*K)", "W/(m^2*K)", "1/K",     "deg/m",  "rad/m",  "mm^2/s", "m^3/s",   "l/min"};

bool fits(const std::string& unit, const Expected& expected) {
  const auto literal = parse_literal("1 " + unit, expected);
  return static_cast<bool>(literal) && literal->dimension == expected.dimension;
}

/// One value of a series or of a number, for its unit.
double size_of(const Value& value) {
  double size = 0.0;
  for (const double si : value.si) {
    if (std::isfinite(si)) size = std::max(size, std::abs(si));
  }
  return size;
}

const account::Entry* find_entry(const std::vector<account::Entry>& all, std::string_view path) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const account::Entry& e) { return e.path == path; });
  return found == all.end() ? nullptr : &*found;
}

std::string entry_text(const account::Entry& entry) {
  return entry.doc + ": " + (entry.word.empty() ? text_of(entry.value, entry.unit) : "\"" + entry.word + "\"");
}

std::string record_text(const project::Step& step, const std::string& path) {
  std::string all;
  for (const project::Member& member : step.members(path)) all += (all.empty() ? "record with " : ", ") + member.key;
  return all;
}

}  // namespace

std::string text_of(const Value& value, std::string_view unit) {
  const std::string shown = unit.empty() ? readable_unit(size_of(value), value.signature.dimension) : std::string(unit);
  const std::string name = shown.empty() ? "-" : shown;
  if (value.si.empty()) return "not available";
  constexpr int digits = 5;
  if (!value.is_series()) return format_quantity(value.si[0], name, digits);
  const auto [low, high] = std::minmax_element(value.si.begin(), value.si.end());
  return format_number(in_unit(*low, name), digits) + " to " + format_quantity(*high, name, digits) + " over " +
         value.signature.axis->quantity;
}

std::vector<std::string> units_for(const Expected& expected) {
  std::vector<std::string> units;
  const auto add = [&](const std::string& unit) {
    if (std::find(units.begin(), units.end(), unit) == units.end() && fits(unit, expected)) units.push_back(unit);
  };
  if (expected.dimension.is_number()) return {"%"};
  if (!expected.unit.empty()) add(std::string(expected.unit));
  for (const char* unit : composed) add(unit);
  std::set<std::pair<const UnitRow*, int>> taken;  // um equals µm
  for (const bool with_prefix : {false, true}) {
    for (const UnitName& name : all_unit_names(true)) {
      const bool alike = name.row->dimension.without_angle() == expected.dimension.without_angle();
      if (!alike || name.script != Script::latin || (name.ten != 0) != with_prefix) continue;
      if (taken.emplace(name.row, name.ten).second) add(name.text);
    }
  }
  return units;
}

std::string in_units(double si, const Expected& expected) {
  constexpr std::size_t most = 6;
  constexpr double least = 1e-3, largest = 1e6;
  std::string all;
  std::size_t count = 0;
  const auto add = [&](const std::string& unit) {
    all += (all.empty() ? "" : " = ") + format_quantity(si, unit);
    ++count;
  };
  const std::string in_si = si_unit(expected.dimension);
  if (in_si.empty()) return format_quantity(si, "-");
  add(in_si);
  for (const std::string& unit : units_for(expected)) {
    if (count == most) break;
    const double size = std::abs(in_unit(si, unit));
    if (unit != in_si && (si == 0.0 || (size >= least && size < largest))) add(unit);
  }
  return all;
}

std::string value_of(project::Project& project, std::string_view text, std::string_view unit) {
  const auto expression = Expression::parse(text);
  if (!expression) return {};
  const auto signature = expression->check([&](const std::string& path) { return project.signature(path); });
  if (signature) {
    const Value value =
        expression->evaluate([&](const std::string& path) -> const Value& { return value_in(project, path); });
    const auto parsed = unit.empty() ? Outcome<UnitValue>(Fault{}) : parse_unit(unit);
    const bool alike = parsed && parsed->dimension.without_angle() == signature->dimension.without_angle();
    return text_of(value, alike ? unit : std::string_view{});
  }
  if (!expression->is_reference()) return {};
  const auto [name, rest] = project::split_step(expression->references().front().path);
  const project::Step* const step = project.find(name);
  return step == nullptr ? "" : step->word(rest);
}

std::string meaning_of(project::Project& project, const std::string& path) {
  const auto [name, rest] = project::split_step(path);
  const project::Step* const step = project.find(name);
  if (step == nullptr) return value_of(project, path);
  for (const auto* entries : {&step->account().results, &step->account().inputs}) {
    if (const account::Entry* const entry = find_entry(*entries, rest)) return entry_text(*entry);
  }
  const FieldInfo* const field = step->field(rest);
  const std::string value = value_of(project, path, field == nullptr ? "" : field->unit);
  if (field != nullptr) return field->doc + (value.empty() ? "" : ": " + value);
  return value.empty() ? record_text(*step, rest) : value;
}

const table::Tables& tables_of(const OpenFile& file) {
  static const table::Tables built_in;
  if (file.project != nullptr && file.project->tables != nullptr) return *file.project->tables;
  return file.solved != nullptr && file.solved->tables != nullptr ? *file.solved->tables : built_in;
}

bool is_of_group(std::string_view word, const std::string& group) { return word == group || word == group + "s"; }

std::vector<std::string> own_rows(const OpenFile& file, const std::string& group) {
  std::vector<std::string> rows;
  const auto add = [&](const Path& path) {
    constexpr std::size_t deep = 3;  // tables, group, name
    if (path.size() < deep || path[0] != "tables" || !is_of_group(path[1], group)) return;
    if (std::find(rows.begin(), rows.end(), path[2]) == rows.end()) rows.push_back(path[2]);
  };
  for (const Header& header : file.outline.headers) add(header.path);
  for (const Item& item : file.outline.items) add(item.path);
  return rows;
}

}  // namespace loadpath::cli::lsp
