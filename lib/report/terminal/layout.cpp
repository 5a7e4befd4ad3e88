#include "lib/report/terminal/layout.hpp"

#include <algorithm>
#include <numeric>
#include <sys/ioctl.h>
#include <unistd.h>

namespace loadpath::terminal {

namespace {

constexpr std::size_t gap = 2;  // between columns

using Row = std::vector<std::string>;
using Lines = std::vector<std::string>;

std::size_t width_of(const std::string& text) {  // code points; an escape sequence has none
  std::size_t width = 0;
  bool escape = false;
  for (const char c : text) {
    if (c == '\033') escape = true;
    if (!escape && (static_cast<unsigned char>(c) & 0xC0U) != 0x80U) ++width;
    if (escape && c == 'm') escape = false;
  }
  return width;
}

std::size_t indent_of(const std::string& text) { return std::min(text.find_first_not_of(' '), text.size()); }

/// Whether a text is a number and its unit: "90 mm", "-4.5 kN·m".
bool is_quantity(const std::string& text) {
  const std::size_t from = indent_of(text), digit = from + (text.compare(from, 1, "-") == 0 ? 1 : 0);
  const std::size_t space = text.find(' ', from);
  return digit < text.size() && '0' <= text[digit] && text[digit] <= '9' && space != std::string::npos &&
         text.find(' ', space + 1) == std::string::npos;
}

/// Words between spaces; a coloured text is one word, and so is a quantity.
Lines words_of(const std::string& text) {
  if (text.find('\033') != std::string::npos) return {text};
  if (is_quantity(text)) return {text.substr(indent_of(text))};
  Lines words;
  for (std::size_t at = indent_of(text); at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    words.push_back(text.substr(at, end - at));
    at = std::min(text.find_first_not_of(' ', end), text.size());
  }
  return words;
}

/// The text in lines of a width; those behind the first are indented as it is, and by `hang` more.
Lines broken(const std::string& text, std::size_t width, std::size_t hang) {
  if (width_of(text) <= width) return {text};
  const std::string first(indent_of(text), ' '), next(indent_of(text) + hang, ' ');
  Lines lines;
  std::string line = first;
  bool empty = true;
  for (const std::string& word : words_of(text)) {
    if (!empty && width_of(line) + 1 + width_of(word) > width) {
      lines.push_back(line);
      line = next, empty = true;
    }
    line += (empty ? "" : " ") + word;
    empty = false;
  }
  lines.push_back(line);
  return lines;
}

/// The minimum width of a cell: its longest word, after the indent of its later lines.
std::size_t least_width(const std::string& cell, std::size_t hang) {
  std::size_t least = 0;
  for (const std::string& word : words_of(cell)) least = std::max(least, width_of(word));
  return least + indent_of(cell) + hang;
}

std::size_t hang_of(const std::string& cell) { return indent_of(cell) > 0 ? gap : 0; }

/// Narrows the widest column that has words to break, until the line fits or no word can be broken.
void fit(std::vector<std::size_t>& widths, const std::vector<std::size_t>& least, std::size_t width) {
  const std::size_t gaps = gap * (widths.empty() ? 0 : widths.size() - 1);
  while (std::accumulate(widths.begin(), widths.end(), gaps) > width) {
    std::size_t widest = widths.size();
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const bool gives = widths[i] > least[i];
      if (gives && (widest == widths.size() || widths[i] > widths[widest])) widest = i;
    }
    if (widest == widths.size()) return;
    --widths[widest];
  }
}

std::vector<std::size_t> widths_of(const std::vector<Row>& rows, std::size_t width) {
  std::vector<std::size_t> widths, least;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0), least.resize(widths.size(), 0);
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], width_of(row[i]));
      least[i] = std::max(least[i], std::min(width_of(row[i]), least_width(row[i], hang_of(row[i]))));
    }
  }
  fit(widths, least, width);
  return widths;
}

void add_row(const Row& row, const std::vector<std::size_t>& widths, std::string& text) {
  std::vector<Lines> cells;
  std::size_t height = 1;
  for (std::size_t i = 0; i < row.size(); ++i) {
    cells.push_back(broken(row[i], widths[i], hang_of(row[i])));
    height = std::max(height, cells.back().size());
  }
  for (std::size_t line = 0; line < height; ++line) {
    std::string all;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string cell = line < cells[i].size() ? cells[i][line] : std::string();
      all += cell;
      if (i + 1 < cells.size()) all += std::string(std::max(widths[i], width_of(cell)) - width_of(cell) + gap, ' ');
    }
    if (line > 0) all.resize(all.find_last_not_of(' ') + 1);
    text += all + "\n";
  }
}

}  // namespace

std::size_t line_width() {
  constexpr std::size_t least = 80, most = 120, usual = 100;
  winsize size{};
  if (isatty(STDOUT_FILENO) == 0 || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual;
  return std::clamp<std::size_t>(size.ws_col, least, most);
}

std::string columns(const std::vector<Row>& rows, std::size_t width) {
  const auto widths = widths_of(rows, width);
  std::string text;
  for (const Row& row : rows) add_row(row, widths, text);
  return text;
}

std::string paragraph(const std::string& text, std::size_t hang, std::size_t width) {
  std::string all;
  for (const std::string& line : broken(text, width, hang)) all += line + "\n";
  return all;
}

}  // namespace loadpath::terminal
