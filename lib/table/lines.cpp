#include "lib/table/lines.hpp"

#include <algorithm>
#include <charconv>

namespace loadpath::table {

namespace {

bool is_digit(char c) { return '0' <= c && c <= '9'; }

/// Characters that need no escape in a text of TOML, whatever the encoding.
bool is_plain(char c) { return ' ' <= c && c <= '~' && c != '"' && c != '\\'; }

/// Reads from the front of a text.
struct Scanner {
  std::string_view rest;

  void skip_blanks() { rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size())); }
  bool take(char c) {
    skip_blanks();
    if (!rest.starts_with(c)) return false;
    rest.remove_prefix(1);
    return true;
  }
  std::string_view take(std::size_t length) {
    const std::string_view taken = rest.substr(0, length);
    rest.remove_prefix(length);
    return taken;
  }
};

bool read_text(Scanner& in, Cell& cell) {
  in.rest.remove_prefix(1);
  const auto end = std::find_if_not(in.rest.begin(), in.rest.end(), is_plain);
  if (end == in.rest.end() || *end != '"') return false;
  cell = {Cell::Type::text, in.take(static_cast<std::size_t>(end - in.rest.begin())), 0.0};
  in.rest.remove_prefix(1);
  return true;
}

bool read_nested(Scanner& in, Cell& cell) {
  const std::size_t end = in.rest.find(']');
  if (end == std::string_view::npos) return false;
  cell = {Cell::Type::texts, in.take(end + 1), 0.0};
  return true;
}

/// A decimal number as TOML and C++ write it alike: 12, -0.5, 1e-6.
bool read_number(Scanner& in, Cell& cell) {
  cell.type = Cell::Type::number;
  const char *const first = in.rest.data(), *const last = first + in.rest.size();
  const char* const digit = first + (*first == '-' ? 1 : 0);
  if (digit == last || !is_digit(*digit) || (*digit == '0' && digit + 1 != last && is_digit(digit[1]))) return false;
  const auto [end, error] = std::from_chars(first, last, cell.number);
  if (error != std::errc{} || !is_digit(end[-1])) return false;
  in.rest.remove_prefix(static_cast<std::size_t>(end - first));
  return true;
}

bool read_cell(Scanner& in, Cell& cell) {
  in.skip_blanks();
  if (in.rest.starts_with('"')) return read_text(in, cell);
  if (in.rest.starts_with('[')) return read_nested(in, cell);
  return !in.rest.empty() && read_number(in, cell);
}

/// Cells between brackets, a comma after the last allowed.
bool read_array(Scanner& in, std::vector<Cell>& cells) {
  cells.clear();
  if (!in.take('[')) return false;
  while (!in.take(']')) {
    Cell cell;
    if (!read_cell(in, cell)) return false;
    cells.push_back(cell);
    if (in.take(',')) continue;
    if (!in.take(']')) return false;
    break;
  }
  return true;
}

}  // namespace

std::optional<Lines> cut_lines(std::string_view text) {
  constexpr std::string_view head = "\nrows = [\n", foot = "\n]\n";
  const std::size_t start = text.find(head);
  if (start == std::string_view::npos || text.substr(0, start).find("\n[") != std::string_view::npos)
    return std::nullopt;
  const std::size_t first = start + head.size(), end = text.find(foot, first);
  if (end == std::string_view::npos) return std::nullopt;
  Lines found;
  for (std::string_view block = text.substr(first, end + 1 - first); !block.empty();) {
    const std::size_t length = block.find('\n');
    found.lines.push_back(block.substr(0, length));
    block.remove_prefix(length + 1);
  }
  found.rest.assign(text.substr(0, start));
  found.rest.append(found.lines.size() + 3, '\n');
  found.rest.append(text.substr(end + foot.size()));
  return found;
}

bool read_line(std::string_view line, std::vector<Cell>& cells) {
  Scanner in{line};
  if (!read_array(in, cells)) return false;
  in.take(',');
  in.skip_blanks();
  return in.rest.empty();
}

bool read_texts(const Cell& cell, std::vector<std::string>& texts) {
  Scanner in{cell.text};
  std::vector<Cell> cells;
  if (cell.type != Cell::Type::texts || !read_array(in, cells)) return false;
  for (const Cell& c : cells) {
    if (c.type != Cell::Type::text) return false;
    texts.emplace_back(c.text);
  }
  return true;
}

std::optional<std::string_view> plain_text(std::string_view file, std::string_view key) {
  const std::string bare(key);
  for (const std::string& head : {"\n" + bare + " = \"", "\n\"" + bare + "\" = \""}) {
    const std::size_t found = file.find(head);
    if (found == std::string_view::npos) continue;
    const std::string_view value = file.substr(found + head.size());
    const std::size_t end = value.find_first_of("\"\\\n");
    if (end != std::string_view::npos && value.substr(end).starts_with("\"\n")) return value.substr(0, end);
  }
  return std::nullopt;
}

}  // namespace loadpath::table
