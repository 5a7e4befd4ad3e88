#include "lib/table/own/own.hpp"

#include "lib/quantity/format.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/table/library.hpp"
#include "lib/table/names.hpp"
#include "lib/table/search.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::table {

namespace {

constexpr std::string_view words[] = {"standard", "kind", "note", "aliases", "by_size", "source", "because"};

bool is_word(std::string_view key) { return std::find(std::begin(words), std::end(words), key) != std::end(words); }

/// One line with words in it.
bool is_line(const std::string& text) {
  return text.find('\n') == std::string::npos && text.find_first_not_of(" \t") != std::string::npos;
}

std::vector<std::string> keys_of(const Table& table) {
  std::vector<std::string> keys;
  for (const Column& column : table.columns) keys.push_back(column.key);
  return keys;
}

/// Columns and words: the possible keys of a row.
std::vector<std::string> all_keys(const Table& table) {
  std::vector<std::string> keys = keys_of(table);
  keys.insert(keys.end(), std::begin(words), std::end(words));
  return keys;
}

std::vector<std::string> kinds_of(std::string_view group) {
  std::vector<std::string> kinds;
  for (const Table* table : tables_of(group)) {
    for (const Row& row : table->rows) {
      if (std::find(kinds.begin(), kinds.end(), row.kind) == kinds.end()) kinds.push_back(row.kind);
    }
  }
  return kinds;
}

/// Whether every value of the built-in rows is above zero: then a project's is, too.
bool is_positive(std::string_view group, std::string_view key) {
  for (const Table* table : tables_of(group)) {
    for (const Row& row : table->rows) {
      if (searched_value(row, key) <= 0.0) return false;
    }
  }
  return true;
}

}  // namespace

void OwnReader::complain(const Place& place, std::string key, Message message, Message hint) {
  issues_.push_back({place, std::move(key), std::move(message), std::move(hint), Severity::error});
}

std::string OwnReader::text_of(const Tree::Entry& entry, const std::string& key) {
  const std::string& text = entry.value.text;
  if (entry.value.type != Tree::Type::text) {
    complain(entry.value.place, key, say("'{1}' takes a text, not {2}", entry.key, toml::word_for(entry.value.type)));
  } else if (is_line(text)) {
    return text;
  } else {
    complain(entry.value.place, key, say("'{1}' is a text of one line", entry.key));
  }
  return {};
}

void OwnReader::read_tables(const Tree::Entry& tables) {
  if (tables.value.type != Tree::Type::table) {
    return complain(tables.place, "tables",
                    say("'{1}' is a table of tables, not {2}", "tables", toml::word_for(tables.value.type)),
                    say("a row is [tables.materials.NAME]"));
  }
  for (const Tree::Entry& entry : tables.value.entries) read_group(entry);
}

void OwnReader::read_group(const Tree::Entry& entry) {
  const bool series = entry.key == "series";
  const std::string group = group_of(entry.key, groups_), key = "tables." + entry.key;
  if (!series && group.empty()) {
    std::vector<std::string> known{"series"};
    for (const std::string& g : groups_) known.push_back(g + "s");
    return complain(entry.place, key, say("a project can have no tables '{1}' of its own", entry.key),
                    did_you_mean(entry.key, known, there_is(known)));
  }
  if (entry.value.type != Tree::Type::table) {
    return complain(entry.value.place, key,
                    say("'{1}' is a table of rows, not {2}", entry.key, toml::word_for(entry.value.type)));
  }
  for (const Tree::Entry& row : entry.value.entries) {
    if (!is_line(row.key)) {
      complain(row.place, key, say("the name of a row is one line"));
    } else if (row.value.type != Tree::Type::table) {
      complain(row.place, key + "." + row.key, say("'{1}' is outside a row", row.key), say("a row is [{1}.NAME]", key));
    } else if (series) {
      read_series(row);
    } else {
      read_row(row, table_of(group));
    }
  }
}

Table& OwnReader::table_of(const std::string& group) {
  const auto same = [&](const Table& t) { return t.group == group && t.name == "own/" + group; };
  const auto found = std::find_if(own_.tables.begin(), own_.tables.end(), same);
  if (found != own_.tables.end()) return *found;
  Table table = columns_of(group);
  table.name = "own/" + group;
  table.title = "of the project";
  return own_.tables.emplace_back(std::move(table));
}

void OwnReader::read_row(const Tree::Entry& entry, Table& table) {
  const std::string key = "tables." + table.group + "s." + entry.key;
  Row row;
  row.own = true;
  row.name = entry.key;
  const std::size_t before = issues_.size();
  const std::string source = read_source(entry.value, entry.place, key);
  for (const Tree::Entry& e : entry.value.entries) {
    if (is_word(e.key))
      read_word(e, key, row);
    else
      read_value(e, table, key, row.values);
    if (e.key == "kind") check_kind(e, key, table.group);
    if (e.key == "by_size") read_sizes(e.value, table, key, row);
    if (e.key == "because") read_because(e, table, key, row);
  }
  const auto credit = [&](Value& value) {
    const auto reason = row.because.find(value.key);
    value.sources = {reason == row.because.end() ? source : source + "; " + reason->second};
  };
  std::for_each(row.values.begin(), row.values.end(), credit);
  for (Step& step : row.by_size) std::for_each(step.values.begin(), step.values.end(), credit);
  if (issues_.size() == before && row.values.empty() && row.by_size.empty()) {
    const auto keys = keys_of(table);
    complain(entry.place, key, say("'{1}' has no value", entry.key), there_is(keys));
  }
  if (issues_.size() == before) check_bounds(row, table, entry.place, key);
  if (is_new(row, table.group, entry.place, key)) table.rows.push_back(std::move(row));
}

/// because = { R_e = "certificate 4711" }: why a value is better than that of the built-in rows.
void OwnReader::read_because(const Tree::Entry& entry, const Table& table, const std::string& key, Row& row) {
  if (entry.value.type != Tree::Type::table)
    return complain(entry.value.place, key + ".because", say("'{1}' is a table of reasons", "because"),
                    say("name the columns: because = { R_e = \"certificate 4711\" }"));
  for (const Tree::Entry& reason : entry.value.entries) {
    const std::string path = key + ".because." + reason.key;
    if (table.column(reason.key) == nullptr) {
      const auto keys = keys_of(table);
      complain(reason.place, path, say("the {1} tables have no column '{2}'", table.group, reason.key),
               did_you_mean(reason.key, keys, there_is(keys)));
    } else {
      row.because[reason.key] = text_of(reason, path);
    }
  }
}

std::string OwnReader::read_source(const Tree& row, const Place& place, const std::string& key) {
  if (const auto* source = row.find("source")) return text_of(*source, key + ".source");
  complain(place, key, say("'{1}' has no source", key),
           say("state the origin of its values: source = \"certificate 4711 of 2026-03-02\""));
  return {};
}

void OwnReader::read_word(const Tree::Entry& entry, const std::string& key, Row& row) {
  if (entry.key == "standard") row.standard = text_of(entry, key + ".standard");
  if (entry.key == "kind") row.kind = text_of(entry, key + ".kind");
  if (entry.key == "note") row.note = text_of(entry, key + ".note");
  if (entry.key != "aliases") return;
  const auto is_text = [](const Tree& item) { return item.type == Tree::Type::text && !item.text.empty(); };
  if (entry.value.type != Tree::Type::array ||
      !std::all_of(entry.value.items.begin(), entry.value.items.end(), is_text)) {
    return complain(entry.value.place, key + ".aliases", say("'{1}' must be an array of texts", "aliases"));
  }
  for (const Tree& item : entry.value.items) row.aliases.push_back(item.text);
}

/// A kind spelt nearly like one that calculators know may be a mistake, or the user's own.
void OwnReader::check_kind(const Tree::Entry& entry, const std::string& key, std::string_view group) {
  const auto kinds = kinds_of(group);
  const std::string near = nearest(entry.value.text, kinds);
  if (near.empty() || near == entry.value.text) return;
  issues_.push_back({entry.value.place, key + ".kind", say("no other row is of the kind '{1}'", entry.value.text),
                     say("did you mean '{1}'?", near), Severity::warning});
}

void OwnReader::read_value(const Tree::Entry& entry, const Table& table, const std::string& key,
                           std::vector<Value>& values) {
  const Column* column = table.column(entry.key);
  if (column == nullptr) {
    const auto keys = all_keys(table);
    return complain(entry.place, key + "." + entry.key,
                    say("the {1} tables have no column '{2}'", table.group, entry.key),
                    did_you_mean(entry.key, keys, there_is(keys)));
  }
  const double si = read_quantity(entry.value, *column, key + "." + entry.key);
  check_sign({entry.key, si, {}}, *column, table.group, entry.value.place);
  if (!std::isnan(si)) values.push_back({entry.key, si, {}});
}

void OwnReader::check_sign(const Value& value, const Column& column, std::string_view group, const Place& place) {
  if (value.si > 0.0 || std::isnan(value.si) || !is_positive(group, value.key)) return;
  complain(place, value.key, say("{1} = {2}: must be > 0", value.key, format_quantity(value.si, column.unit)));
}

/// The value in SI; NaN and an issue if it is none of the column.
double OwnReader::read_quantity(const Tree& tree, const Column& column, const std::string& key) {
  const bool number = tree.type == Tree::Type::number;
  if (!number && tree.type != Tree::Type::text) {
    complain(tree.place, key, say("a quantity is expected, not {1}", toml::word_for(tree.type)),
             say("write a text with a unit, \"30 {1}\"", column.unit));
    return no_size;
  }
  const std::string text = number ? format_exact(tree.number) : tree.text;
  const std::string_view unit = column.unit == "-" ? std::string_view() : std::string_view(column.unit);
  const auto literal = parse_literal(text, Expected{column.dimension, Kind::plain, unit});
  if (literal) return literal->si;
  Place place = tree.place;
  if (!number) place.length = static_cast<int>(std::max<std::size_t>(1, text.size()));
  complain(place, key, literal.fault().message, literal.fault().hint);
  return no_size;
}

void OwnReader::read_sizes(const Tree& tree, const Table& table, const std::string& key, Row& row) {
  if (table.size.key.empty())
    return complain(tree.place, key + ".by_size", say("values of a {1} do not depend on a size", table.group));
  if (tree.type != Tree::Type::array) {
    return complain(tree.place, key + ".by_size", say("'{1}' is an array of tables", "by_size"),
                    say("by_size = [{ size_max = \"16 mm\", R_e = \"265 MPa\" }]"));
  }
  for (const Tree& item : tree.items) read_size(item, table, key + ".by_size", row);
}

void OwnReader::read_size(const Tree& tree, const Table& table, const std::string& key, Row& row) {
  const auto* size = tree.find("size_max");
  if (size == nullptr) {
    return complain(tree.place, key, say("'{1}' is missing", "size_max"),
                    say("values hold up to a size: size_max = \"16 mm\""));
  }
  Step step{read_quantity(size->value, table.size, key + ".size_max"), {}};
  const double last = row.by_size.empty() ? 0.0 : row.by_size.back().size_max;
  if (step.size_max <= last) complain(size->value.place, key, say("sizes must be positive and ascending"));
  for (const Tree::Entry& entry : tree.entries) {
    if (entry.key != "size_max") read_value(entry, table, key, step.values);
  }
  if (!std::isnan(step.size_max)) row.by_size.push_back(std::move(step));
}

}  // namespace loadpath::table
