#include "cli/commands.hpp"
#include "lib/export/json_catalogue.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/terminal/terminal.hpp"
#include "lib/table/library.hpp"
#include "lib/table/names.hpp"
#include "lib/table/search.hpp"
#include "lib/table/table.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace loadpath::cli {

namespace {

using table::Library;
using table::Row;
using table::Table;
using Rows = std::vector<std::vector<std::string>>;

/// A row of values is never broken: it is searched for and compared.
constexpr std::size_t any_width = std::numeric_limits<std::size_t>::max();

/// "also: 1.0038, St 37-2"; empty if there are none.
std::string listed(const char* what, const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? std::string(what) + ": " : ", ") + name;
  return all.empty() ? all : terminal::paragraph(all, 2);
}

/// "materials/steel_heat_treatable" of "C45E"; empty if no table has a row that answers to the word.
std::string table_of_row(const Library& library, const std::string& word) {
  for (const Table& t : library.tables) {
    const auto entry = table::find_row(Library{{t}, {}, {}}, t.group, word);
    if (entry) return t.name;
  }
  return "";
}

/// Tables whose name begins with the word behind its folder: "sections/hea" of "HEA".
std::vector<std::string> tables_beginning(const Library& library, const std::string& word) {
  std::vector<std::string> names;
  const std::u32string wanted = table::folded(word);
  for (const Table& t : library.tables) {
    const std::u32string last = table::folded(t.name.substr(t.name.find('/') + 1));
    if (last == wanted) return {t.name};
    if (last.starts_with(wanted)) names.push_back(t.name);
  }
  return names;
}

int unknown_table(const std::string& word) {
  const Library& library = table::built_in();
  std::vector<std::string> names;
  for (const Table& t : library.tables) {
    names.push_back(t.name);
    names.push_back(t.name.substr(0, t.name.find('/')));
  }
  for (const table::Series& s : library.series) names.push_back(s.name);
  Message hint = did_you_mean(word, names);
  if (hint.empty()) {
    const std::string row = table_of_row(library, word);
    const auto begun = tables_beginning(library, word);
    const auto of_group =
        std::find_if(library.tables.begin(), library.tables.end(), [&](const Table& t) { return t.group == word; });
    hint = of_group != library.tables.end() ? say("its rows are in `loadpath tables {1}`", of_group->name)
           : !row.empty()                   ? say("'{1}' is a row: `loadpath tables {2} \"{1}\"`", word, row)
           : !begun.empty()                 ? there_is(begun)
                                            : say("`loadpath tables` shows all");
  }
  std::cerr << "loadpath: unknown table '" << word << "'\n  = help: " << hint.text() << "\n";
  return wrong_input;
}

/// All tables and series; `of`: those of this folder, and the series of this name.
int show_index(const Library& library, const std::string& of = "") {
  Rows rows;
  for (const Table& t : library.tables) {
    if (of.empty() || t.name.starts_with(of + "/"))
      rows.push_back({t.name, std::to_string(t.rows.size()) + " rows", t.title});
  }
  for (const table::Series& s : library.series) {
    if (of.empty() || s.name == of)
      rows.push_back({s.table + " " + s.name, std::to_string(s.members.size()) + " sizes", s.title});
  }
  std::cout << terminal::columns(rows);
  return passed;
}

std::string shown(const Table& t, const std::vector<table::Value>& values, const std::string& key) {
  const auto value = std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.key == key; });
  if (value == values.end()) return "";
  return format_number(in_unit(value->si, t.column(key)->unit), 5) + (value->sources.empty() ? " *" : "");
}

void add_row(const Table& t, const Row& row, Rows& rows) {
  const std::size_t steps = std::max<std::size_t>(1, row.by_size.size());
  for (std::size_t i = 0; i < steps; ++i) {
    std::vector<std::string> cells{
        i == 0 ? row.name : "",
        i < row.by_size.size() ? format_number(in_unit(row.by_size[i].size_max, t.size.unit), 5) : ""};
    for (const auto& column : t.columns) {
      std::string cell = i == 0 ? shown(t, row.values, column.key) : "";
      if (cell.empty() && i < row.by_size.size()) cell = shown(t, row.by_size[i].values, column.key);
      cells.push_back(std::move(cell));
    }
    rows.push_back(std::move(cells));
  }
}

void show_table(const Table& t, const Row* only) {
  Rows rows{{"name", "up to [" + pretty_unit(t.size.unit) + "]"}};
  for (const auto& column : t.columns)
    rows[0].push_back(column.key + (column.unit == "-" ? "" : " [" + pretty_unit(column.unit) + "]"));
  for (const Row& row : t.rows) {
    if (only == nullptr || only == &row) add_row(t, row, rows);
  }
  std::cout << t.title << " (" << t.name << ")\n"
            << terminal::columns(rows, any_width) << "* not checked against the source\n";
}

void show_details(const Row& row) {
  const std::string kind = row.kind.empty() ? "" : ", " + row.kind, note = row.note.empty() ? "" : "; " + row.note;
  std::cout << "\n"
            << terminal::paragraph(row.standard + kind + note) << listed("also called", row.aliases)
            << listed("close to, and not the same as", row.near);
  std::vector<std::string> keys;
  const auto collect = [&](const std::vector<table::Value>& values) {
    for (const auto& v : values) {
      for (const auto& key : v.sources) {
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
      }
    }
  };
  collect(row.values);
  for (const auto& step : row.by_size) collect(step.values);
  for (const auto& key : keys) std::cout << terminal::paragraph("[" + key + "] " + table::citation(key), 2);
}

int show_series(const table::Series& series) {
  std::cout << series.title << " (" << series.table << " " << series.name << "), in " << series.unit << "\n";
  for (std::size_t i = 0; i < series.members.size(); ++i) {
    std::cout << format_number(series.members[i], 8)
              << ((i + 1) % 12 == 0 || i + 1 == series.members.size() ? "\n" : " ");
  }
  for (const auto& key : series.sources) std::cout << "[" << key << "] " << table::citation(key) << "\n";
  return passed;
}

int show_audit(const Library& library) {
  Rows rows{{"table", "row", "value", "", "up to"}};
  for (const table::Recalled& r : table::audit(library)) {
    rows.push_back({r.table, r.row, r.key, format_quantity(r.si, r.unit),
                    std::isinf(r.size_max) ? "" : format_quantity(r.size_max, "mm")});
  }
  std::cout << terminal::columns(rows, any_width) << rows.size() - 1 << " values without a seen source\n";
  return passed;
}

int print(const std::string& text) {
  std::cout << text;
  return passed;
}

int show_row(const std::string& group, const TablesOptions& options) {
  const auto entry = table::find_row(group, options.key);
  if (!entry) {
    std::cerr << "loadpath: " << entry.fault().message.text() << "\n";
    if (!entry.fault().hint.empty()) std::cerr << "  = help: " << entry.fault().hint.text() << "\n";
    return wrong_input;
  }
  if (options.json) return print(exports::json_of(std::vector<table::Entry>{*entry}));
  show_table(*entry->table, entry->row);
  show_details(*entry->row);
  return passed;
}

using Tables = std::vector<const Table*>;

/// The requested columns, then the first ones of the tables, as many as fit in a line.
std::vector<const table::Column*> columns_to_show(const Tables& chosen, const table::Condition& condition,
                                                  const table::Order& order) {
  constexpr std::size_t most = 10;
  std::vector<const table::Column*> shown;
  const auto add = [&](const std::string& key) {
    const auto known = [&](const table::Column* column) { return column->key == key; };
    if (shown.size() == most || std::any_of(shown.begin(), shown.end(), known)) return;
    if (const auto* const column = table::find_column(chosen, key)) shown.push_back(column);
  };
  if (!order.key.empty()) add(order.key);
  for (const auto& comparison : condition) add(comparison.key);
  for (const Table* t : chosen) {
    for (const auto& column : t->columns) add(column.key);
  }
  return shown;
}

int show_found(const Tables& chosen, const std::vector<table::Entry>& found,
               const std::vector<const table::Column*>& shown) {
  std::size_t all = 0;
  for (const Table* t : chosen) all += t->rows.size();
  Rows rows{{"name"}};
  for (const auto* column : shown)
    rows[0].push_back(column->key + (column->unit == "-" ? "" : " [" + pretty_unit(column->unit) + "]"));
  for (const table::Entry& entry : found) rows.push_back({entry.row->name});
  for (const auto* column : shown) {
    std::vector<double> values;
    values.reserve(found.size());
    for (const table::Entry& entry : found) values.push_back(table::searched_value(*entry.row, column->key));
    values = in_unit(std::move(values), column->unit);
    for (std::size_t i = 0; i < values.size(); ++i)
      rows[i + 1].push_back(std::isnan(values[i]) ? "" : format_number(values[i], 5));
  }
  std::cout << terminal::columns(rows, any_width) << found.size() << " of " << all << " rows\n";
  return passed;
}

int wrong_word(const char* option, const std::string& text, const Fault& fault) {
  const Place place{option, 1, static_cast<int>(fault.at) + 1, static_cast<int>(fault.length)};
  terminal::show_issues({{place, "", fault.message, fault.hint, Severity::error}}, {{option, text}});
  return wrong_input;
}

int show_search(const Tables& chosen, const TablesOptions& options) {
  table::Condition condition;
  if (!options.where.empty()) {
    auto read = table::read_condition(options.where, chosen);
    if (!read) return wrong_word("--where", options.where, read.fault());
    condition = std::move(*read);
  }
  const auto order = table::read_order(options.sort, chosen);
  if (!order) return wrong_word("--sort", options.sort, order.fault());
  if (options.json) return print(exports::json_of(table::search(chosen, condition, *order)));
  return show_found(chosen, table::search(chosen, condition, *order), columns_to_show(chosen, condition, *order));
}

int refuse_search(const std::string& what, const std::string& help) {
  std::cerr << "loadpath: " << what << "\n  = help: " << help << "\n";
  return wrong_input;
}

int search_tables(const TablesOptions& options) {
  if (options.table.empty())
    return refuse_search("--where and --sort search a table", "name it: loadpath tables sections --where ...");
  const Tables chosen = table::tables_in(options.table);
  if (chosen.empty())
    return refuse_search("--where and --sort search tables, and '" + options.table + "' is not a table",
                         "`loadpath tables` shows all");
  if (options.key.empty()) return show_search(chosen, options);
  const bool part = !table::tables_in(options.table + "/" + options.key).empty();
  return refuse_search("a search is over all rows, and '" + options.key + "' would be one of them",
                       part ? "search the part: loadpath tables " + options.table + "/" + options.key : "leave it out");
}

/// The series that is named by itself, or in its table; null if none is.
const table::Series* series_of(const TablesOptions& options) {
  if (const auto* series = options.key.empty() ? table::series_named(options.table) : nullptr) return series;
  const auto* series = table::series_named(options.key);
  return series != nullptr && series->table == options.table ? series : nullptr;
}

}  // namespace

namespace {

/// Every row of some tables.
std::vector<table::Entry> rows_of(const Tables& tables) {
  std::vector<table::Entry> rows;
  for (const Table* t : tables) {
    for (const Row& row : t->rows) rows.push_back({t, &row});
  }
  return rows;
}

}  // namespace

/// Tables are given by full name ("materials/steel_aisi"), by their folder ("materials"), or a series by its own name
/// ("R40").
int tables(const TablesOptions& options) {
  if (!options.where.empty() || !options.sort.empty()) return search_tables(options);
  const Library& library = table::built_in();
  if (options.audit) return options.json ? print(exports::json_of(table::audit(library))) : show_audit(library);
  if (options.table.empty()) return options.json ? print(exports::json_index(library)) : show_index(library);
  const bool is_both = options.key.empty() && !options.json && table::series_named(options.table) != nullptr &&
                       table::first_table_in(options.table) != nullptr;
  if (is_both) return show_index(library, options.table);  // "bearing": a folder and a series
  if (const auto* series = series_of(options))
    return options.json ? print(exports::json_of(*series)) : show_series(*series);
  const Table* const first = table::first_table_in(options.table);
  if (first == nullptr) return unknown_table(options.table);
  if (!options.key.empty()) return show_row(first->group, options);
  if (options.json) return print(exports::json_of(rows_of(table::tables_in(options.table))));
  for (const Table* t : table::tables_in(options.table)) show_table(*t, nullptr);
  return passed;
}

}  // namespace loadpath::cli
