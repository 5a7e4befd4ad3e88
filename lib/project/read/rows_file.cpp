#include "lib/project/read/rows_file.hpp"

#include "lib/project/read/history.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/rainflow/series/cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <utility>

namespace loadpath::project {

namespace {

using toml::Tree;

constexpr std::uintmax_t largest_file = 16'000'000;  // bytes

/// The heading of a column, and the field that it fills; null where it is left out.
struct Column {
  rainflow::Heading heading;
  const FieldInfo* field = nullptr;
};

/// The cells of a heading; where blanks part them, a unit in brackets belongs to the name before it.
std::vector<std::string> headings_of(std::string_view line, char separator) {
  std::vector<std::string> cells;
  bool is_within = false;
  for (std::string& cell : rainflow::fields_of(line, separator)) {
    const bool opens = separator == rainflow::blanks && (cell.starts_with('[') || cell.starts_with('('));
    const bool goes_on = is_within || (opens && !cells.empty());
    if (goes_on)
      cells.back() += " " + cell;
    else
      cells.push_back(cell);
    if (separator == rainflow::blanks && (opens || is_within))
      is_within = cell.find_first_of("])") == std::string::npos;
  }
  return cells;
}

/// "1,5" as "1.5", where the comma does not part cells; anything else as it is.
std::string with_point(std::string text, char separator) {
  const std::size_t comma = text.find(',');
  const bool is_number = text.find_first_not_of("0123456789+-eE,") == std::string::npos;
  if (separator != ',' && comma != std::string::npos && is_number) text[comma] = '.';
  return text;
}

/// As the number or the text would be written in the project file.
Tree value_of(const std::string& cell, const Column& column, const Place& place) {
  const std::string& unit = column.heading.unit;
  Tree value;
  value.place = place;
  value.text = unit.empty() ? cell : cell + " " + unit;
  char* end = nullptr;
  value.number = std::strtod(cell.c_str(), &end);
  const bool is_number = unit.empty() && !cell.empty() && *end == '\0';
  value.type = is_number ? Tree::Type::number : Tree::Type::text;
  return value;
}

bool has_unit(const FieldInfo& field) {
  return field.type == FieldInfo::Type::quantity && std::string_view(field.unit) != "-";
}

class Rows {
 public:
  Rows(const Tree& tree, std::string path, std::span<const FieldInfo> fields)
      : tree_(tree), path_(std::move(path)), fields_(fields) {
    rows_.type = Tree::Type::array;
    rows_.place = tree.place;
  }

  /// None, and an issue, where something is wrong.
  std::optional<Tree> read(const std::string& text, Issue& wrong);

 private:
  [[nodiscard]] Place at(std::string_view part = {}) const;
  bool refuse(const Place& place, Message message, Message hint = {}) {
    wrong_ = {place, "", std::move(message), std::move(hint), Severity::error};
    return false;
  }
  bool take_line();
  bool take_heading();
  bool choose(const std::vector<std::string>& cells);
  bool choose_named(const Tree::Entry& named, const std::vector<std::string>& cells);
  bool unit_fits(const Column& column, const std::string& cell);
  bool has_all_units(const std::vector<std::string>& cells);
  bool take_row();
  [[nodiscard]] std::string keys() const;
  [[nodiscard]] const std::string& name() const { return tree_.find("file")->value.text; }

  const Tree& tree_;
  std::string path_;
  std::span<const FieldInfo> fields_;
  Tree rows_;
  std::vector<Column> columns_;
  std::string line_;
  int number_ = 0, heading_line_ = 0;
  char separator_ = ',';
  Issue wrong_;
};

/// The place of a part of the line that is read.
Place Rows::at(std::string_view part) const {
  const std::size_t found = part.empty() ? std::string::npos : line_.find(part);
  const auto column = found == std::string::npos ? 1 : static_cast<int>(found) + 1;
  return {path_, number_, column, std::max(1, static_cast<int>(part.size()))};
}

std::string Rows::keys() const {
  std::string all;
  for (const FieldInfo& field : fields_) all += (all.empty() ? "" : ", ") + std::string(field.key);
  return all;
}

std::optional<Tree> Rows::read(const std::string& text, Issue& wrong) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  std::istringstream lines(text.starts_with(mark) ? text.substr(mark.size()) : text);
  for (std::string line; std::getline(lines, line);) {
    ++number_;
    if (line.ends_with('\r')) line.pop_back();
    line_ = line.substr(0, line.find('#'));
    if (line_.find_first_not_of(" \t") == std::string::npos) continue;
    if (!take_line()) {
      wrong = std::move(wrong_);
      return std::nullopt;
    }
  }
  if (!rows_.items.empty()) return std::move(rows_);
  refuse({path_, std::max(1, number_), 1, 1}, say("'{1}' has no rows", name()),
         say("write a heading with the fields, t [s], share, then one row per line"));
  wrong = std::move(wrong_);
  return std::nullopt;
}

bool Rows::take_line() {
  if (columns_.empty()) return take_heading();
  return take_row();
}

bool Rows::take_heading() {
  heading_line_ = number_;
  separator_ = rainflow::separator_of(line_);
  const auto cells = headings_of(line_, separator_);
  for (const std::string& cell : cells) columns_.push_back({rainflow::heading_of(cell)});
  if (columns_.size() == 1 && separator_ == rainflow::blanks) separator_ = ',';  // "5 mm" is one cell
  if (!choose(cells)) return false;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (!unit_fits(columns_[k], cells[k])) return false;
  }
  return true;
}

/// Every column is a field of the rows, but where `columns` says which are.
bool Rows::choose(const std::vector<std::string>& cells) {
  if (const auto* const named = tree_.find("columns")) {
    for (const Tree::Entry& entry : named->value.entries) {
      if (!choose_named(entry, cells)) return false;
    }
    return true;
  }
  for (std::size_t k = 0; k < cells.size(); ++k) {
    columns_[k].field = find_input(fields_, columns_[k].heading.name);
    if (columns_[k].field == nullptr)
      return refuse(
          at(cells[k]), say("the heading '{1}' is not a valid key here", columns_[k].heading.name),
          say("the fields are {1}; cells are separated by commas, semicolons, tabs or blanks; columns = {...} "
              "assigns columns to fields",
              keys()));
  }
  return true;
}

/// columns = { t = "time", p = 3 }.
bool Rows::choose_named(const Tree::Entry& named, const std::vector<std::string>& cells) {
  const FieldInfo* const field = find_input(fields_, named.key);
  if (field == nullptr)
    return refuse(named.place, say("'{1}' is not a valid key here", named.key), say("the fields are {1}", keys()));
  std::size_t found = cells.size();
  if (named.value.type == Tree::Type::number) {
    const double number = named.value.number;
    if (number >= 1.0 && number <= static_cast<double>(cells.size()) && number == std::floor(number))
      found = static_cast<std::size_t>(number) - 1;
  } else {
    for (std::size_t k = cells.size(); k-- > 0;) {
      if (cells[k] == named.value.text || columns_[k].heading.name == named.value.text) found = k;
    }
  }
  if (found < cells.size()) {
    columns_[found].field = field;
    return true;
  }
  const std::string wanted =
      named.value.type == Tree::Type::number ? format_number(named.value.number) : named.value.text;
  return refuse(named.value.place,
                say("'{1}' has {2} columns, and no column '{3}'", name(), std::to_string(cells.size()), wanted),
                did_you_mean(wanted, cells, there_is(cells)));
}

/// A unit over a column is one of its field.
bool Rows::unit_fits(const Column& column, const std::string& cell) {
  const FieldInfo* const field = column.field;
  if (field == nullptr || field->type != FieldInfo::Type::quantity || column.heading.unit.empty()) return true;
  const auto one =
      parse_literal("1 " + column.heading.unit, Expected{field->dimension, field->kind, field->unit, field->key});
  if (one) return true;
  return refuse(at(cell), say("the heading '{1}': {2}", cell, one.fault().message),
                has_unit(*field) ? say("name the unit in the header: {1} [{2}]", column.heading.name, field->unit)
                                 : say("it has no unit: {1}", column.heading.name));
}

/// Numbers without a unit, of a field that has one, need it in the heading.
bool Rows::has_all_units(const std::vector<std::string>& cells) {
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Column& column = columns_[k];
    if (column.field == nullptr || !has_unit(*column.field) || !column.heading.unit.empty()) continue;
    if (!rainflow::number_of(cells[k], separator_)) continue;
    return refuse({path_, heading_line_, 1, 1}, say("the heading '{1}' has no unit", column.heading.name),
                  say("name the unit in the header: {1} [{2}]", column.heading.name, column.field->unit));
  }
  return true;
}

bool Rows::take_row() {
  const auto cells = rainflow::fields_of(line_, separator_);
  if (cells.size() != columns_.size())
    return refuse(at(),
                  say("line {1} of '{2}' does not have as many cells as its heading, {3}", std::to_string(number_),
                      name(), std::to_string(columns_.size())),
                  say("write a cell for each column, separated as in the heading"));
  if (rows_.items.empty() && !has_all_units(cells)) return false;
  Tree& row = rows_.items.emplace_back();
  row.place = at();
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (columns_[k].field == nullptr) continue;
    const Place place = at(cells[k]);
    row.entries.push_back(
        {columns_[k].field->key, place, value_of(with_point(cells[k], separator_), columns_[k], place)});
  }
  return true;
}

/// Taken from the folder of the project that names it.
std::filesystem::path path_of(const Tree& named) {
  return std::filesystem::path(named.place.file).parent_path() / named.text;
}

Issue issue_at(const Place& place, Message message, Message hint) {
  return {place, "", std::move(message), std::move(hint), Severity::error};
}

/// What is wrong with the table that names the file.
std::optional<Issue> fault_of_keys(const Tree& tree) {
  for (const Tree::Entry& entry : tree.entries) {
    if (entry.key != "file" && entry.key != "columns")
      return issue_at(entry.place, say("'{1}' is not a valid key here", entry.key),
                      say("rows in a file: { file = \"rows.csv\" }, or with columns = { t = \"time\", p = 3 }"));
    if (entry.key == "columns" && entry.value.type != Tree::Type::table)
      return issue_at(entry.value.place,
                      say("'columns' is a table of fields, not {1}", toml::word_for(entry.value.type)),
                      say("assign columns to fields: columns = { t = \"time\", p = 3 }"));
  }
  return std::nullopt;
}

}  // namespace

bool names_rows_file(const Tree& tree) { return names_history_file(tree); }

std::vector<std::string> files_in(const Tree& table) {
  if (names_history_file(table) && table.find("file")->value.text != "-")
    return {path_of(table.find("file")->value).string()};
  std::vector<std::string> paths;
  const auto add = [&](const Tree& part) {
    for (std::string& path : files_in(part)) paths.push_back(std::move(path));
  };
  for (const Tree::Entry& entry : table.entries) add(entry.value);
  for (const Tree& item : table.items) add(item);
  return paths;
}

std::optional<Tree> read_rows_file(const Tree& tree, std::span<const FieldInfo> fields, Issue& wrong) {
  if (auto fault = fault_of_keys(tree)) {
    wrong = std::move(*fault);
    return std::nullopt;
  }
  const Tree& named = tree.find("file")->value;
  const std::filesystem::path path = path_of(named);
  std::error_code error;
  std::string text;
  const bool there = std::filesystem::is_regular_file(path, error);
  if (there && std::filesystem::file_size(path, error) > largest_file) {
    wrong = issue_at(named.place, say("'{1}' is not a list of rows", named.text), say("at most 16 MB"));
    return std::nullopt;
  }
  if (!there || !toml::read_file(path.string(), text)) {
    wrong = issue_at(named.place, say("file '{1}' does not exist or cannot be read", path.string()),
                     say("the path is relative to the project file"));
    return std::nullopt;
  }
  return Rows(tree, path.string(), fields).read(text, wrong);
}

}  // namespace loadpath::project
