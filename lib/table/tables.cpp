#include "lib/table/tables.hpp"

#include "lib/table/library.hpp"
#include "lib/table/rows.hpp"
#include "lib/table/search.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace loadpath::table {

namespace {

/// The parts of a path between its dots; those in quotes are names with dots and spaces of their own.
std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> parts(1);
  bool quoted = false;
  for (const char c : path) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == '.' && !quoted) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

Fault fault(Message message, Message hint) { return {0, 1, std::move(message), std::move(hint)}; }

Fault no_path(std::string_view path) {
  return fault(say("'{1}' is not a value of a table", path),
               say("write table, row and column, a row's name in quotes: tables.sections.\"IPE 330\".I_y"));
}

std::vector<std::string> plurals(const std::vector<std::string>& groups) {
  std::vector<std::string> words;
  words.reserve(groups.size());
  for (const std::string& group : groups) words.push_back(group + "s");
  return words;
}

/// The reason why a row's value is not available without a step; other errors have been reported.
Fault of_size(const Entry& entry, std::string_view key, Fault fault) {
  const bool sized = covered_size(entry, key) > 0.0;
  if (sized)
    fault.hint =
        say("name the row in a step, which knows its size: {1} = \"{2}\"", entry.table->group, entry.row->name);
  return fault;
}

Fault no_column(const Entry& entry, std::string_view key) {
  std::vector<std::string> keys;
  for (const Column& column : entry.table->columns) {
    if (covered_size(entry, column.key) > 0.0) keys.push_back(column.key);
  }
  return fault(say("the {1} '{2}' has no value '{3}'", entry.table->group, entry.row->name, key),
               did_you_mean(key, keys, there_is(keys)));
}

/// "own table of the project: EN 10028-2, table 4"
Message own_table(const std::vector<std::string>& sources) {
  std::string all;
  for (const std::string& source : sources) all += (all.empty() ? "" : "; ") + source;
  return all.empty() ? say("own table of the project") : say("own table of the project: {1}", all);
}

}  // namespace

Outcome<Entry> Tables::find_row(std::string_view group, std::string_view name) const {
  if (!has_own_rows()) return table::find_row(group, name);
  if (auto own = table::find_row(own_, group, name)) return own;
  auto found = table::find_row(group, name);
  if (found) return found;
  return no_row(group, name, {&own_, &built_in()});
}

bool Tables::is_own(std::string_view group, std::string_view name) const {
  return has_own_rows() && static_cast<bool>(table::find_row(own_, group, name));
}

Outcome<const Series*> Tables::find_series(std::string_view name) const {
  if (const auto own = table::find_series(own_, name)) return own;
  return table::find_series(name);
}

std::vector<std::string> Tables::series_names() const {
  std::vector<std::string> names;
  for (const Library* library : {&own_, &built_in()}) {
    for (const Series& series : library->series) names.push_back(series.name);
  }
  return names;
}

std::vector<const Table*> Tables::all_of(std::string_view group) const {
  std::vector<const Table*> all = tables_of(group);
  for (const Table& table : own_.tables) {
    if (table.group == group) all.push_back(&table);
  }
  return all;
}

std::vector<std::string> Tables::names_of(std::string_view group) const {
  const auto all = all_of(group);
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Table* table : all) names.push_back(table->name);
  return names;
}

std::vector<Entry> Tables::ordered_rows(std::string_view group, std::string_view within) const {
  std::vector<std::pair<double, Entry>> sized;
  for (const Entry& entry : entries_of(all_of(group))) {
    const auto size = property(entry, order_of(group));
    const bool inside = within.empty() || entry.table->name == within || entry.row->kind == within;
    if (inside && size) sized.emplace_back(size->si, entry);
  }
  std::stable_sort(sized.begin(), sized.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Entry> rows;
  std::transform(sized.begin(), sized.end(), std::back_inserter(rows), [](const auto& row) { return row.second; });
  return rows;
}

Outcome<std::vector<Entry>> Tables::ordered_rows(std::string_view group, std::string_view within,
                                                 std::string_view where) const {
  std::vector<Entry> rows = ordered_rows(group, within);
  if (where.empty()) return rows;
  const auto condition = read_condition(where, all_of(group));
  if (!condition) return condition.fault();
  std::erase_if(rows, [&](const Entry& entry) {
    return !std::all_of(condition->begin(), condition->end(), [&](const Comparison& comparison) {
      return comparison.holds(searched_value(*entry.row, comparison.key));
    });
  });
  return rows;
}

/// Ribbed belts have none: their rows rate no rib, so that nothing would decide between them.
std::string_view order_of(std::string_view group) {
  using Pair = std::pair<std::string_view, std::string_view>;
  constexpr std::array orders{
      Pair{"bearing", "m"}, Pair{"chain", "p"},       Pair{"circlip", "d_1"}, Pair{"key", "b"},
      Pair{"section", "A"}, Pair{"set_screw", "d_s"}, Pair{"spline", "d_2"},  Pair{"synchronous_belt", "p_b"},
      Pair{"v_belt", "w_d"}};
  const auto found =
      std::find_if(orders.begin(), orders.end(), [&](const auto& order) { return order.first == group; });
  return found == orders.end() ? std::string_view() : found->second;
}

Outcome<Tables::Referred> Tables::value_at(std::string_view path) const {
  const std::vector<std::string> parts = parts_of(path);
  if (parts.size() != 4) return no_path(path);
  const std::string group = group_of(parts[1], groups_);
  if (group.empty()) {
    const auto known = plurals(groups_);
    return fault(say("unknown tables '{1}'", parts[1]), did_you_mean(parts[1], known, there_is(known)));
  }
  const auto entry = find_row(group, parts[2]);
  if (!entry) return entry.fault();
  const Column* column = entry->table->column(parts[3]);
  if (column == nullptr || covered_size(*entry, parts[3]) == 0.0) return no_column(*entry, parts[3]);
  auto value = property(*entry, parts[3]);
  if (!value) return of_size(*entry, parts[3], value.fault());
  return Referred{std::move(*value), column->dimension};
}

std::string group_of(std::string_view word, const std::vector<std::string>& groups) {
  const auto found =
      std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return word == g || word == g + "s"; });
  return found == groups.end() ? std::string() : *found;
}

Table columns_of(std::string_view group) {
  Table all;
  all.name = all.group = group;
  for (const Table* table : tables_of(group)) {
    if (all.size.key.empty()) all.size = table->size;
    for (const Column& column : table->columns) {
      if (all.column(column.key) == nullptr) all.columns.push_back(column);
    }
  }
  return all;
}

Message named_source(const std::string& row, const Property& property) {
  if (!property.own) return say("{1}", row);
  return say("{1}, {2}", row, own_table(property.sources));
}

Message named_source(Message chosen, const Series& series) {
  if (!series.own) return chosen;
  return say("{1}, {2}", std::move(chosen), own_table(series.sources));
}

}  // namespace loadpath::table
