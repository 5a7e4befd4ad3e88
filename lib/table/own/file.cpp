#include "lib/quantity/literal.hpp"
#include "lib/table/library.hpp"
#include "lib/table/names.hpp"
#include "lib/table/own/own.hpp"
#include "lib/table/reader.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>

namespace loadpath::table {

namespace {

/// The sources of a row as texts: its keys have no meaning outside the file.
void name_sources(const Library& library, std::vector<std::string>& sources) {
  for (std::string& source : sources) {
    const auto found = library.citations.find(source);
    source = found != library.citations.end() ? found->second.text : citation(source);
  }
}

void name_sources(const Library& library, Row& row) {
  for (Value& value : row.values) name_sources(library, value.sources);
  for (Step& step : row.by_size) {
    for (Value& value : step.values) name_sources(library, value.sources);
  }
}

}  // namespace

void OwnReader::read_file(std::string_view text, const std::string& file) {
  const std::size_t before = issues_.size();
  Library library;
  Reader reader(library, issues_);
  reader.read(text, file);
  if (issues_.size() != before) return;
  reader.check_citations([](const std::string& key) { return !citation(key).empty(); });
  if (check_file(toml::read_toml(text, file, issues_)) && issues_.size() == before) take_file(std::move(library), file);
}

/// Whether the file has rows of a group that a step can name, or series; its columns are those of the group.
bool OwnReader::check_file(const Tree& file) {
  const auto* group = file.find("group");
  if (group == nullptr) {
    const bool series = file.find("series") != nullptr;
    if (!series)
      complain(file.place, "", say("the file has no rows"),
               say("its form is that of `loadpath tables`: group = \"material\", [[row]]"));
    return series;
  }
  if (std::find(groups_.begin(), groups_.end(), group->value.text) == groups_.end()) {
    complain(group->value.place, "group", say("a project can have no tables '{1}' of its own", group->value.text),
             did_you_mean(group->value.text, groups_, there_is(groups_)));
    return false;
  }
  const Table known = columns_of(group->value.text);
  if (const auto* units = file.find("units")) {
    for (const Tree::Entry& unit : units->value.entries) check_unit(unit, known);
  }
  return true;
}

void OwnReader::check_unit(const Tree::Entry& unit, const Table& known) {
  const Column* column = unit.key == known.size.key ? &known.size : known.column(unit.key);
  if (column == nullptr) {
    std::vector<std::string> keys;
    for (const Column& c : known.columns) keys.push_back(c.key);
    return complain(unit.place, "units." + unit.key, say("the {1} tables have no column '{2}'", known.group, unit.key),
                    did_you_mean(unit.key, keys, there_is(keys)));
  }
  const auto given = parse_unit(unit.value.text);
  if (given && given->dimension == column->dimension) return;
  complain(unit.value.place, "units." + unit.key,
           say("{1} of '{2}' is a {3}, not a {4}", unit.key, known.group, name_of(column->dimension),
               given ? name_of(given->dimension) : unit.value.text),
           say("write a unit like {1}", column->unit));
}

void OwnReader::take_file(Library&& read, const std::string& file) {
  const Place place{file, 0, 0, 1};
  for (Table& table : read.tables) {
    for (Row& row : table.rows) {
      row.own = true;
      name_sources(read, row);
      check_signs(row, table, place);
      check_bounds(row, table, place, row.name);
      is_new(row, table.group, place, row.name);
    }
    own_.tables.push_back(std::move(table));
  }
  for (Series& series : read.series) {
    name_sources(read, series.sources);
    add_series(std::move(series), place, "");
  }
}

void OwnReader::check_signs(const Row& row, const Table& table, const Place& place) {
  for (const Value& value : row.values) check_sign(value, *table.column(value.key), table.group, place);
  for (const Step& step : row.by_size) {
    for (const Value& value : step.values) check_sign(value, *table.column(value.key), table.group, place);
  }
}

bool OwnReader::is_new(const Row& row, const std::string& group, const Place& place, const std::string& key) {
  std::map<std::u32string, std::string> names{{folded(row.name), row.name}};
  for (const std::string& alias : row.aliases) names.emplace(folded(alias), alias);
  for (const auto& [name, written] : names) {
    const auto [known, inserted] = names_.emplace(std::pair(group, name), row.name);
    if (inserted) continue;
    complain(place, key,
             say("two rows of the project match the name '{1}': '{2}' and '{3}'", written, known->second, row.name),
             say("take it out of one of them"));
    return false;
  }
  return true;
}

void OwnReader::add_series(Series&& series, const Place& place, const std::string& key) {
  const auto same = [&](const Series& s) { return s.name == series.name; };
  if (std::any_of(own_.series.begin(), own_.series.end(), same))
    return complain(place, key, say("there are two series '{1}'", series.name), say("take one of them out"));
  series.own = true;
  own_.series.push_back(std::move(series));
}

}  // namespace loadpath::table
