#include "lib/report/markdown/text.hpp"

#include "lib/report/numbers/numbers.hpp"
#include "lib/text/utf8.hpp"

#include <algorithm>

namespace loadpath::report::md {
namespace {

constexpr std::size_t widest_padding = 60;

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || (c & 0x80) != 0;
}

/// A line that begins like a list, a heading, a quotation or a rule would be read as one.
bool opens_block(std::string_view words) {
  if (words.empty()) return false;
  const std::size_t digits = std::min(words.find_first_not_of("0123456789"), words.size());
  if (digits > 0) {
    const std::string_view after = words.substr(digits);
    return after == "." || after == ")" || after.starts_with(". ") || after.starts_with(") ");
  }
  return std::string_view("#+-=>~").find(words.front()) != std::string_view::npos;
}

bool needs_escape(std::string_view words, std::size_t i) {
  const char c = words[i], before = i > 0 ? words[i - 1] : ' ', after = i + 1 < words.size() ? words[i + 1] : ' ';
  if (c == '_') return !is_word(before) || !is_word(after);
  if (c == '(' || c == ':') return before == ']';  // a link
  return std::string_view("\\`*$|~&").find(c) != std::string_view::npos;
}

std::string padded(const std::string& cell, std::size_t width, bool flush_right) {
  const std::size_t length = code_points(cell).size();
  const std::string blanks(width > length ? width - length : 0, ' ');
  return flush_right ? blanks + cell : cell + blanks;
}

std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                 const std::vector<bool>& flush_right) {
  std::string out = "|";
  for (std::size_t i = 0; i < widths.size(); ++i) {
    out += " " + padded(i < cells.size() ? cells[i] : "", widths[i], flush_right[i]) + " |";
  }
  return out + "\n";
}

std::vector<std::size_t> column_widths(const Grid& grid) {
  std::vector<std::size_t> widths;
  const auto add = [&](const std::vector<std::string>& cells) {
    widths.resize(std::max(widths.size(), cells.size()), 3);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      widths[i] = std::max(widths[i], std::min(code_points(cells[i]).size(), widest_padding));
    }
  };
  add(grid.head);
  for (const auto& row : grid.rows) add(row);
  return widths;
}

}  // namespace

std::string text(std::string_view words) {
  std::string out;
  if (opens_block(words)) {
    const std::size_t digits = words.find_first_not_of("0123456789");
    out = std::string(words.substr(0, digits)) + "\\";
    words.remove_prefix(digits);
    out += words.front();
    words.remove_prefix(1);
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    const char c = words[i];
    if (c == '<') {
      out += "&lt;";
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += ' ';
    } else {
      out += (needs_escape(words, i) ? "\\" : "") + std::string(1, c);
    }
  }
  return out;
}

std::string code(std::string_view words) {
  std::string fence = "`";
  while (words.find(fence) != std::string_view::npos) fence += '`';
  return fence + " " + std::string(words) + " " + fence;
}

std::string inline_math(std::string_view tex) { return "$" + std::string(tex) + "$"; }

std::string address(std::string_view file_name) {
  constexpr std::string_view hexadecimal = "0123456789ABCDEF", plain = "-._~";
  std::string out;
  for (const char c : file_name) {
    const auto byte = static_cast<unsigned char>(c);
    if ((is_word(c) && byte < 0x80) || plain.find(c) != std::string_view::npos) {
      out += c;
    } else {
      out += std::string("%") + hexadecimal[byte >> 4] + hexadecimal[byte & 15];
    }
  }
  return out;
}

std::string table(const Grid& grid) {
  const std::vector<std::size_t> widths = column_widths(grid);
  if (widths.empty()) return {};
  std::vector<bool> flush_right = grid.flush_right;
  flush_right.resize(widths.size());
  std::string out = line(grid.head, widths, flush_right) + "|";
  for (std::size_t i = 0; i < widths.size(); ++i) {
    out += (flush_right[i] ? " " : " :") + std::string(widths[i] - 1, '-') + (flush_right[i] ? ": |" : " |");
  }
  out += "\n";
  for (const auto& row : grid.rows) out += line(row, widths, flush_right);
  return out + "\n";
}

}  // namespace loadpath::report::md
