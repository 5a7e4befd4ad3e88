#include "lib/table/reader.hpp"

#include <algorithm>

namespace loadpath::table {

namespace {

template <class Named>
void replace_or_add(std::vector<Named>& all, Named one) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Named& n) { return n.name == one.name; });
  if (found == all.end()) {
    all.push_back(std::move(one));
  } else {
    *found = std::move(one);
  }
}

/// A key has the same meaning in all tables of a group.
const Column* column_of_group(const Library& library, const Table& table, std::string_view key) {
  if (const Column* own = table.column(key)) return own;
  for (const Table& other : library.tables) {
    if (other.group != table.group) continue;
    if (const Column* column = other.column(key)) return column;
  }
  return nullptr;
}

}  // namespace

void Reader::read(std::string_view text, const std::string& file) {
  const std::size_t issues = issues_.size(), cited = cited_.size();
  if (const auto lines = cut_lines(text)) {
    const bool whole = read_tree(toml::read_toml(lines->rest, file, issues_), &*lines);
    if (whole && issues_.size() == issues) return;
    issues_.erase(issues_.begin() + static_cast<std::ptrdiff_t>(issues), issues_.end());
    cited_.erase(cited_.begin() + static_cast<std::ptrdiff_t>(cited), cited_.end());
  }
  read_tree(toml::read_toml(text, file, issues_), nullptr);
}

bool Reader::read_tree(const Tree& tree, const Lines* lines) {
  check_keys(tree,
             {"table", "group", "title", "units", "unit", "defaults", "row", "columns", "rows", "series", "sources",
              "methods", "recalled_columns"},
             "");
  if (const auto* sources = tree.find("sources")) read_citations(sources->value, false);
  if (const auto* methods = tree.find("methods")) read_citations(methods->value, true);
  const bool has_rows = lines != nullptr || tree.find("row") != nullptr || tree.find("rows") != nullptr;
  if (has_rows && !read_rows(tree, lines)) return false;
  if (tree.find("series") != nullptr) read_series_list(tree);
  return true;
}

void Reader::read_citations(const Tree& table, bool of_method) {
  for (const auto& entry : table.entries) {
    library_.citations[entry.key] = {text_of(table, entry.key, "sources"), of_method};
  }
}

Table& Reader::table_of(const Tree& file) {
  Table head;
  head.name = text_of(file, "table", "", true);
  head.group = text_of(file, "group", "", true);
  head.title = text_of(file, "title", "");
  const auto same = [&](const Table& t) { return t.name == head.name; };
  const auto found = std::find_if(library_.tables.begin(), library_.tables.end(), same);
  return found != library_.tables.end() ? *found : library_.tables.emplace_back(std::move(head));
}

bool Reader::read_rows(const Tree& file, const Lines* lines) {
  Table& table = table_of(file);
  const Frame frame = read_frame(file, table);
  add_columns(table, frame.units);
  std::set<std::string> seen;
  const auto add = [&](Row&& row, const Place& place) {
    if (!seen.insert(row.name).second) complain(place, row.name, say("there are two rows '{1}'", row.name));
    replace_or_add(table.rows, std::move(row));
  };
  if (lines != nullptr) {
    const auto* head = file.find("columns");
    std::vector<Row> rows;
    if (head == nullptr || !rows_of_lines(*lines, texts(head->value, "columns"), frame, rows)) return false;
    for (Row& row : rows) add(std::move(row), head->place);
  }
  for (const Tree& tree : row_trees(file)) {
    Row row;
    if (read_row(tree, frame, row)) add(std::move(row), tree.place);
  }
  return true;
}

/// The rows of a file, those that are written as lines first.
std::vector<Reader::Tree> Reader::row_trees(const Tree& file) {
  std::vector<Tree> trees;
  if (const auto* rows = file.find("rows")) {
    const auto* head = file.find("columns");
    if (head == nullptr) complain(rows->place, "rows", say("'{1}' is missing", "columns"));
    const Texts columns = head != nullptr ? texts(head->value, "columns") : Texts{};
    for (const Tree& line : rows->value.items) trees.push_back(row_of_line(line, columns));
  }
  if (const auto* row = file.find("row")) trees.insert(trees.end(), row->value.items.begin(), row->value.items.end());
  return trees;
}

Reader::Tree Reader::row_of_line(const Tree& line, const Texts& columns) {
  Tree row;
  row.place = line.place;
  if (line.type != Tree::Type::array || line.items.size() != columns.size()) {
    complain(line.place, "rows",
             say("a line of 'rows' is an array of {1} values, as listed in 'columns'", std::to_string(columns.size())));
    return row;
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Tree& value = line.items[i];
    const bool open = value.type == Tree::Type::text && value.text.empty();
    if (!open) row.entries.push_back({columns[i], value.place, value});
  }
  return row;
}

void Reader::read_series_list(const Tree& file) {
  Series head;
  head.table = text_of(file, "table", "", true);
  head.unit = text_of(file, "unit", "", true);
  const auto unit = file.find("unit");
  if (const auto read = read_unit(head.unit, 0); unit != nullptr && !read) {
    return complain(unit->value.place, "unit", read.fault().message, read.fault().hint);
  }
  for (const Tree& tree : file.find("series")->value.items) {
    Series series = head;
    if (read_series(tree, series)) replace_or_add(library_.series, std::move(series));
  }
}

std::vector<Reader::ReadColumn> Reader::read_units(const Tree& file, const Table& table) {
  std::vector<ReadColumn> units;
  const auto* head = file.find("units");
  if (head == nullptr) complain(file.place, "", say("'{1}' is missing", "units"));
  for (std::size_t i = 0; head != nullptr && i < head->value.entries.size(); ++i) {
    const auto& [key, place, value] = head->value.entries[i];
    ReadColumn read{{key, value.text, {}}, {}};
    if (value.text != "-") {
      const auto unit = read_unit(value.text, 0);
      if (!unit) complain(value.place, key, unit.fault().message, unit.fault().hint);
      read.unit = unit ? *unit : ParsedUnit{};
      read.column.dimension = read.unit.dimension;
    }
    const Column* known = key == table.size.key ? &table.size : column_of_group(library_, table, key);
    if (known != nullptr && !(known->dimension == read.column.dimension)) {
      complain(value.place, key,
               say("{1} of '{2}' is a {3}, not a {4}", key, table.name, name_of(known->dimension),
                   name_of(read.column.dimension)));
    }
    units.push_back(std::move(read));
  }
  return units;
}

Reader::Frame Reader::read_frame(const Tree& file, const Table& table) {
  Frame frame{read_units(file, table), {}, {}};
  if (const auto* defaults = file.find("defaults")) {
    read_values(defaults->value, frame, frame.defaults);
    frame.credit.sources = read_credit(defaults->value, "defaults").sources;
  }
  if (const auto* recalled = file.find("recalled_columns")) read_recalled_columns(recalled->value, table, frame);
  return frame;
}

void Reader::read_recalled_columns(const Tree& tree, const Table& table, Frame& frame) {
  for (const std::string& key : texts(tree, "recalled_columns")) {
    const auto named = [&](const ReadColumn& read) { return read.column.key == key; };
    if (std::none_of(frame.units.begin(), frame.units.end(), named))
      complain(tree.place, "recalled_columns", say("'{1}' is not a column of '{2}'", key, table.name));
    frame.credit.recalled.insert(key);
  }
}

void Reader::add_columns(Table& table, const std::vector<ReadColumn>& units) {
  for (const ReadColumn& read : units) {
    if (read.column.key == "size_max") {
      if (table.size.key.empty()) table.size = read.column;
    } else if (table.column(read.column.key) == nullptr) {
      table.columns.push_back(read.column);
    }
  }
}

void Reader::check_citations(const std::function<bool(const std::string&)>& known_elsewhere) {
  std::vector<std::string> keys;
  for (const auto& [key, citation] : library_.citations) keys.push_back(key);
  for (const Cited& cited : cited_) {
    if (library_.citations.count(cited.key) != 0 || (known_elsewhere && known_elsewhere(cited.key))) continue;
    complain(cited.place, "", say("unknown source '{1}'", cited.key),
             did_you_mean(cited.key, keys, say("name it in [sources]")));
  }
}

}  // namespace loadpath::table
