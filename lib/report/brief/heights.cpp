#include "lib/report/brief/heights.hpp"

#include "lib/report/columns.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::report {

namespace {

constexpr double letters_in_mm = 0.68;  // of running text; of tables, whose columns leave gaps, fewer
constexpr double letters_in_mm_of_table = 0.5;

double letters_in(const Cell& cell) {
  if (const auto* const text = std::get_if<std::string>(&cell)) return letters_of(*text);
  if (const auto* const sized = std::get_if<Sized>(&cell)) return letters_of(sized->text + sized->behind()) + 1.0;
  constexpr double of_number = 9.0;
  return of_number;
}

double paragraph_height(const Paragraph& paragraph, double width) {
  constexpr double of_line = 3.6, gap = 1.0;  // mm
  return gap + of_line * std::ceil(letters_of(paragraph.text.text()) / (letters_in_mm * width));
}

/// Columns share the width as browsers divide it: by their longest cells.
double table_height(const Table& table, double width) {
  constexpr double of_line = 3.25, gap = 0.8, head = 7.5, least_letters = 7.0, most_letters = 26.0;  // mm
  std::vector<double> longest;
  for (const auto& row : table.rows) {
    longest.resize(std::max(longest.size(), row.size()), least_letters);
    for (std::size_t i = 0; i < row.size(); ++i)
      longest[i] = std::clamp(letters_in(row[i]), longest[i], std::max(longest[i], most_letters));
  }
  double all = 0.0;
  for (const double letters : longest) all += letters;
  double height = head;
  for (const auto& row : table.rows) {
    double lines = 1.0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const double room = std::max(least_letters, letters_in_mm_of_table * width * longest[i] / all);
      lines = std::max(lines, std::ceil(letters_in(row[i]) / std::max(room, std::min(longest[i], room * 1.25))));
    }
    height += gap + of_line * lines;
  }
  return height;
}

}  // namespace

double height_of(const Panel& panel, double width) {
  constexpr double heading = 8.0;
  double height = panel.title.empty() ? 0.0 : heading;
  for (const Block& block : panel.blocks) {
    if (const auto* const paragraph = std::get_if<Paragraph>(&block)) height += paragraph_height(*paragraph, width);
    if (const auto* const table = std::get_if<Table>(&block)) height += table_height(*table, width);
  }
  return height;
}

double height_of_table(const Panel& panel) {
  constexpr double of_row = 3.9, of_name_row = 6.2, heading = 15.0;  // mm; names in half a page's width may break
  const auto& table = std::get<Table>(panel.blocks.front());
  const double row = table.head.front().id == "Quantity" ? of_name_row : of_row;
  return heading + row * static_cast<double>(table.rows.size());
}

double height_of(const Band& band) {
  double highest = 0.0;
  for (const Stack& stack : band) {
    double height = 0.0;
    for (const Panel& panel : stack.panels) height += height_of(panel, stack.share);
    highest = std::max(highest, height);
  }
  return highest;
}

}  // namespace loadpath::report
