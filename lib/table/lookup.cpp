#include "lib/quantity/format.hpp"
#include "lib/table/names.hpp"
#include "lib/table/table.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::table {

namespace {

bool is_among(const std::vector<std::string>& names, const std::u32string& wanted) {
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return folded(name) == wanted; });
}

/// The latest table wins: a user's tables follow the built-in ones.
template <class Holds>
Entry last_row(const Library& library, std::string_view group, Holds holds) {
  for (auto table = library.tables.rbegin(); table != library.tables.rend(); ++table) {
    if (table->group != group) continue;
    const auto row = std::find_if(table->rows.begin(), table->rows.end(), holds);
    if (row != table->rows.end()) return {&*table, &*row};
  }
  return {};
}

void add_names(const Library& library, std::string_view group, std::vector<std::string>& names) {
  for (const Table& table : library.tables) {
    if (table.group != group) continue;
    for (const Row& row : table.rows) {
      names.push_back(row.name);
      names.insert(names.end(), row.aliases.begin(), row.aliases.end());
    }
  }
}

Fault fault(Message message, Message hint = {}) { return {0, 1, std::move(message), std::move(hint)}; }

const Value* value_of(const std::vector<Value>& values, std::string_view key) {
  const auto found = std::find_if(values.begin(), values.end(), [&](const Value& v) { return v.key == key; });
  return found == values.end() ? nullptr : &*found;
}

Fault no_such_column(const Table& table, std::string_view key) {
  std::vector<std::string> keys;
  for (const Column& column : table.columns) keys.push_back(column.key);
  return fault(say("the table '{1}' has no property '{2}'", table.name, key), did_you_mean(key, keys));
}

Fault no_value_at(const Entry& entry, std::string_view key, double size) {
  const double covered = covered_size(entry, key);
  const std::string& name = entry.row->name;
  const auto text = [&](double x) { return format_quantity(x, entry.table->size.unit); };
  if (covered == 0.0) return fault(say("'{1}' has no value of {2}", name, key));
  if (std::isnan(size)) {
    return fault(say("{1} of '{2}' depends on the size, which is not given", key, name),
                 say("it is given up to {1}", text(covered)));
  }
  return fault(say("{1} of '{2}' is given up to {3}, not for {4}", key, name, text(covered), text(size)));
}

Property property_of(const Entry& entry, const Column& column, const Value& value) {
  return {value.si, column.unit, value.sources, value.sources.empty(), entry.row->own};
}

}  // namespace

const Column* Table::column(std::string_view key) const {
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.key == key; });
  return found == columns.end() ? nullptr : &*found;
}

namespace {

/// "6208" of "6208-2RS" or "SKF 6208", "St 52-3" for "St52": the name of a row among the parts of a name, or one that
/// begins with it.
std::string part_or_whole(std::string_view name, const std::vector<std::string>& names) {
  constexpr std::size_t shortest = 3;
  for (std::size_t from = 0; from < name.size();) {
    const std::size_t end = std::min(name.find_first_of(" -/+_,", from), name.size());
    const auto part = folded(name.substr(from, end - from));
    const auto is_it = [&](const std::string& candidate) { return folded(candidate) == part; };
    const auto found = part.size() < shortest ? names.end() : std::find_if(names.begin(), names.end(), is_it);
    if (found != names.end()) return *found;
    from = end + 1;
  }
  const auto begins = [wanted = folded(name)](const std::string& candidate) {
    return folded(candidate).starts_with(wanted);
  };
  if (name.size() < shortest || name.find_first_of("0123456789") == std::string_view::npos) return {};
  const auto found = std::find_if(names.begin(), names.end(), begins);
  return found == names.end() ? "" : *found;
}

/// "`loadpath tables materials` lists them"; empty if the library has no table of the group, or one without a folder.
Message listing(const Library& library, std::string_view group) {
  std::vector<std::string> tables;
  for (const Table& table : library.tables) {
    if (table.group == group && table.name.find('/') != std::string::npos) tables.push_back(table.name);
  }
  if (tables.empty()) return {};
  const std::string& first = tables.front();
  return say("`loadpath tables {1}` lists them", tables.size() == 1 ? first : first.substr(0, first.find('/')));
}

/// "IPE 80, IPE 100, IPE 120 and 15 more" for "ipe": the rows whose names begin with a word; empty if none does.
std::string begun_by(const std::u32string& word, const std::vector<std::string>& names) {
  constexpr std::size_t shown = 3;
  std::size_t count = 0;
  std::string rows;
  for (const std::string& name : names) {
    if (word.empty() || !folded(name).starts_with(word)) continue;
    if (++count <= shown) rows += (count == 1 ? "" : ", ") + name;
  }
  return count <= shown ? rows : rows + " and " + std::to_string(count - shown) + " more";
}

}  // namespace

Fault no_row(std::string_view group, std::string_view name, const std::vector<const Library*>& libraries) {
  const std::u32string wanted = folded(name);
  const Message message = say("no {1} '{2}' in the tables", group, name);
  std::vector<std::string> names;
  for (const Library* library : libraries) {
    const Entry close = last_row(*library, group, [&](const Row& row) { return is_among(row.near, wanted); });
    if (close.row != nullptr)
      return fault(message, say("'{1}' is similar, but not the same: name it if it is suitable", close.row->name));
    add_names(*library, group, names);
  }
  auto near = near_names(name, names);
  if (std::string part = near.empty() ? part_or_whole(name, names) : ""; !part.empty()) near.push_back(std::move(part));
  if (near.empty()) {
    if (std::string rows = begun_by(wanted, names); !rows.empty())
      return fault(message, say("rows that begin with it: {1}", std::move(rows)));
    constexpr std::size_t few = 12;  // short lists are shown in full
    Message hint = listing(*libraries.back(), group);
    if (names.empty() || names.size() > few) return fault(message, std::move(hint));
    return fault(message, hint.empty() ? there_is(names) : say("{1}; {2}", there_is(names), std::move(hint)));
  }
  return fault(message, near.size() == 1 ? say("did you mean '{1}'?", near[0])
                                         : say("did you mean '{1}' or '{2}'?", near[0], near[1]));
}

Outcome<Entry> find_row(const Library& library, std::string_view group, std::string_view name) {
  const std::u32string wanted = folded(name);
  Entry entry = last_row(library, group, [&](const Row& row) { return folded(row.name) == wanted; });
  if (entry.row == nullptr)
    entry = last_row(library, group, [&](const Row& row) { return is_among(row.aliases, wanted); });
  if (entry.row != nullptr) return entry;
  return no_row(group, name, {&library});
}

Outcome<Property> property(const Entry& entry, std::string_view key, double size) {
  const Column* column = entry.table->column(key);
  if (column == nullptr) return no_such_column(*entry.table, key);
  const Value* value = value_of(entry.row->values, key);
  for (const Step& step : entry.row->by_size) {
    if (value == nullptr && size <= step.size_max) value = value_of(step.values, key);
  }
  if (value == nullptr) return no_value_at(entry, key, size);
  return property_of(entry, *column, *value);
}

std::vector<SizedProperty> values_by_size(const Entry& entry, std::string_view key) {
  std::vector<SizedProperty> all;
  const Column* column = entry.table->column(key);
  if (column == nullptr || value_of(entry.row->values, key) != nullptr) return all;
  for (const Step& step : entry.row->by_size) {
    const Value* value = value_of(step.values, key);
    if (value != nullptr) all.push_back({step.size_max, property_of(entry, *column, *value)});
  }
  return all;
}

double covered_size(const Entry& entry, std::string_view key) {
  if (value_of(entry.row->values, key) != nullptr) return std::numeric_limits<double>::infinity();
  double covered = 0.0;
  for (const Step& step : entry.row->by_size) {
    if (value_of(step.values, key) != nullptr) covered = step.size_max;
  }
  return covered;
}

Outcome<const Series*> find_series(const Library& library, std::string_view name) {
  std::vector<std::string> names;
  for (const Series& series : library.series) {
    if (series.name == name) return &series;
    names.push_back(series.name);
  }
  return fault(say("unknown series '{1}'", name), did_you_mean(name, names));
}

}  // namespace loadpath::table
