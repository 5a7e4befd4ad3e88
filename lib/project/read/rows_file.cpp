#include "lib/project/read/rows_file.hpp"

#include "lib/project/read/history.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>
#include <vector>

namespace loadpath::project {

namespace {

using toml::Tree;

constexpr std::uintmax_t largest_file = 16'000'000;  // bytes

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const std::size_t first = text.find_first_not_of(blank);
  return first == std::string_view::npos ? std::string_view{}
                                         : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

/// The mark that parts the cells of the file: the first of these in its heading.
char separator_of(std::string_view heading) {
  for (const char mark : {'\t', ';', ','}) {
    if (heading.find(mark) != std::string_view::npos) return mark;
  }
  return ',';
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t end = line.find(separator);
    cells.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

struct Column {
  std::string key, unit;
};

/// "t [s]" or "t (s)".
Column column_of(std::string_view heading) {
  const std::size_t open = heading.find_first_of("[("), close = heading.find_last_of("])");
  if (open == std::string_view::npos || close == std::string_view::npos || close < open)
    return {std::string(heading), ""};
  const std::string unit(trimmed(heading.substr(open + 1, close - open - 1)));
  return {std::string(trimmed(heading.substr(0, open))), unit == "-" || unit == "1" ? "" : unit};
}

/// "1,5" as "1.5", where the comma does not part cells; anything else as it is.
std::string with_point(std::string_view cell) {
  std::string text(cell);
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || text.find_first_not_of("0123456789+-eE,") != std::string::npos) return text;
  text[comma] = '.';
  return text;
}

/// As the number or the text would stand in the project file.
Tree value_of(std::string_view cell, const Column& column, const Place& place) {
  Tree value;
  value.place = place;
  value.text = column.unit.empty() ? std::string(cell) : std::string(cell) + " " + column.unit;
  char* end = nullptr;
  const std::string text(cell);
  value.number = std::strtod(text.c_str(), &end);
  const bool number = column.unit.empty() && !text.empty() && *end == '\0';
  value.type = number ? Tree::Type::number : Tree::Type::text;
  return value;
}

Fault fault(Message message, Message hint) { return {0, 1, std::move(message), std::move(hint)}; }

class Rows {
 public:
  Rows(const std::string& name, const Place& place, std::span<const FieldInfo> fields)
      : name_(name), place_(place), fields_(fields) {
    rows_.type = Tree::Type::array;
    rows_.place = place;
  }

  Outcome<Tree> read(const std::string& text) {
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      const std::string_view kept = trimmed(std::string_view(line).substr(0, line.find('#')));
      if (kept.empty()) continue;
      if (columns_.empty()) {
        take_heading(kept);
        if (auto wrong = fault_of_heading(number)) return *std::move(wrong);
      } else if (rows_.items.empty() && lacks_unit(kept)) {
        return missing_unit(kept);
      } else if (!take_row(kept)) {
        return fault(say("line {1} of '{2}' has not as many cells as its heading, {3}", std::to_string(number), name_,
                         std::to_string(columns_.size())),
                     say("write a cell for each column, parted as in the heading"));
      }
    }
    if (rows_.items.empty())
      return fault(say("'{1}' has no rows", name_), say("a heading with the fields, t [s], share; then a row a line"));
    return std::move(rows_);
  }

 private:
  void take_heading(std::string_view line) {
    separator_ = separator_of(line);
    for (const std::string_view cell : cells_of(line, separator_)) columns_.push_back(column_of(cell));
  }

  /// Every column is a field of the rows.
  [[nodiscard]] std::optional<Fault> fault_of_heading(int number) const {
    std::string keys;
    for (const FieldInfo& field : fields_) keys += (keys.empty() ? "" : ", ") + std::string(field.key);
    for (const Column& column : columns_) {
      if (find_field(fields_, column.key) != nullptr) continue;
      return fault(
          say("line {1} of '{2}': the heading '{3}' is not a field here", std::to_string(number), name_, column.key),
          say("the fields are {1}; cells are parted by commas, semicolons or tabs", keys));
    }
    return std::nullopt;
  }

  /// The first column whose cells are numbers without a unit that its field has; null where there is none.
  [[nodiscard]] const Column* without_unit(std::string_view line) const {
    const auto cells = cells_of(line, separator_);
    for (std::size_t k = 0; k < std::min(cells.size(), columns_.size()); ++k) {
      const FieldInfo* const field = find_field(fields_, columns_[k].key);
      const bool has_unit =
          field != nullptr && field->type == FieldInfo::Type::quantity && std::string_view(field->unit) != "-";
      const std::string cell = separator_ == ',' ? std::string(cells[k]) : with_point(cells[k]);
      const bool bare = !cell.empty() && cell.find_first_not_of("0123456789+-eE.") == std::string::npos;
      if (has_unit && bare && columns_[k].unit.empty()) return &columns_[k];
    }
    return nullptr;
  }
  [[nodiscard]] bool lacks_unit(std::string_view line) const { return without_unit(line) != nullptr; }
  [[nodiscard]] Fault missing_unit(std::string_view line) const {
    const std::string& key = without_unit(line)->key;
    return fault(say("the heading '{1}' of '{2}' has no unit", key, name_),
                 say("name the unit in the heading: {1} [{2}]", key, find_field(fields_, key)->unit));
  }

  bool take_row(std::string_view line) {
    const auto cells = cells_of(line, separator_);
    if (cells.size() != columns_.size()) return false;
    Tree& row = rows_.items.emplace_back();
    row.place = place_;
    for (std::size_t k = 0; k < cells.size(); ++k)
      row.entries.push_back(
          {columns_[k].key, place_,
           value_of(separator_ == ',' ? std::string(cells[k]) : with_point(cells[k]), columns_[k], place_)});
    return true;
  }

  const std::string& name_;
  const Place& place_;
  std::span<const FieldInfo> fields_;
  Tree rows_;
  std::vector<Column> columns_;
  char separator_ = ',';
};

/// Taken from the folder of the project that names it.
std::filesystem::path path_of(const Tree& named) {
  return std::filesystem::path(named.place.file).parent_path() / named.text;
}

}  // namespace

bool names_rows_file(const Tree& tree) {
  return tree.type == Tree::Type::table && tree.entries.size() == 1 && tree.entries[0].key == "file" &&
         tree.entries[0].value.type == Tree::Type::text;
}

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

Outcome<Tree> read_rows_file(const Tree& tree, std::span<const FieldInfo> fields) {
  const Tree& named = tree.entries[0].value;
  const std::filesystem::path path = path_of(named);
  std::error_code error;
  std::string text;
  const bool there = std::filesystem::is_regular_file(path, error);
  if (there && std::filesystem::file_size(path, error) > largest_file)
    return fault(say("'{1}' is not a list of rows", named.text), say("at most 16 MB"));
  if (!there || !toml::read_file(path.string(), text))
    return fault(say("file '{1}' does not exist or cannot be read", path.string()),
                 say("its path goes from the folder of the project file"));
  return Rows(named.text, named.place, fields).read(text);
}

}  // namespace loadpath::project
