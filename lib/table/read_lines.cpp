#include "lib/table/reader.hpp"

#include <algorithm>
#include <utility>

namespace loadpath::table {

namespace {

/// The member for a text of a row; null for any other key.
std::string* place_for(Row& row, std::string_view key) {
  const std::pair<std::string_view, std::string*> words[] = {
      {"name", &row.name}, {"standard", &row.standard}, {"kind", &row.kind}, {"note", &row.note}};
  const auto* const word =
      std::find_if(std::begin(words), std::end(words), [&](const auto& w) { return w.first == key; });
  return word == std::end(words) ? nullptr : word->second;
}

}  // namespace

bool Reader::rows_of_lines(const Lines& lines, const Texts& columns, const Frame& frame, std::vector<Row>& rows) {
  std::vector<LineColumn> heads;
  for (const std::string& key : columns) {
    const auto unit = std::find_if(frame.units.begin(), frame.units.end(),
                                   [&](const ReadColumn& read) { return read.column.key == key; });
    heads.push_back({key, unit == frame.units.end() ? nullptr : &*unit});
  }
  std::vector<Cell> cells;
  rows.reserve(lines.lines.size());
  return std::all_of(lines.lines.begin(), lines.lines.end(), [&](std::string_view line) {
    return read_line(line, cells) && row_of_cells(cells, heads, frame, rows.emplace_back());
  });
}

bool Reader::row_of_cells(const std::vector<Cell>& cells, const std::vector<LineColumn>& columns, const Frame& frame,
                          Row& row) {
  if (cells.size() != columns.size() || frame.credit.sources.empty()) return false;
  row.values.reserve(cells.size() + frame.defaults.values.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!add_cell(cells[i], columns[i], frame, row)) return false;
  }
  let_defaults(frame, row);
  return !row.name.empty();
}

bool Reader::add_cell(const Cell& cell, const LineColumn& column, const Frame& frame, Row& row) {
  if (cell.type == Cell::Type::texts) return column.key == "aliases" && read_texts(cell, row.aliases);
  if (cell.type == Cell::Type::text) {
    if (cell.text.empty()) return true;  // no value
    std::string* const text = place_for(row, column.key);
    if (text != nullptr) *text = cell.text;
    return text != nullptr;
  }
  if (column.unit == nullptr) return false;
  const bool recalled = frame.credit.recalled.count(column.key) != 0;
  row.values.push_back({column.key, column.unit->unit.to_si(cell.number), recalled ? Texts() : frame.credit.sources});
  return true;
}

}  // namespace loadpath::table
