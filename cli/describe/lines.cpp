#include "cli/describe/lines.hpp"

#include "lib/report/terminal/layout.hpp"

#include <algorithm>

namespace loadpath::cli {

namespace {

Lines split(const std::string& text) {
  Lines lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

std::string first_of(const std::vector<std::string>& items, std::size_t count, const std::string& separator) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += (i == 0 ? "" : separator) + items[i];
  return all;
}

/// Whether the comma is one of an enumeration, "loose, fixed or cantilevered", which ends with its clause.
bool enumerates(const std::string& meaning, std::size_t comma) {
  const std::string rest = meaning.substr(comma, meaning.find_first_of(";:(", comma) - comma);
  return rest.find(" and ") != std::string::npos || rest.find(" or ") != std::string::npos;
}

/// Where the meaning can end: at a byte before which the text is a complete phrase, of the first clause or of those
/// before a semicolon.
std::vector<std::size_t> ends_of(const std::string& meaning) {
  std::vector<std::size_t> ends;
  int depth = 0;
  bool in_first_clause = true;
  for (std::size_t i = 0; i < meaning.size(); ++i) {
    const char c = meaning[i];
    const bool is_mark = depth == 0 && i > 0 && i + 1 < meaning.size() && meaning[i + 1] == ' ';
    const bool divides = is_mark && (c == ':' || c == ';');
    if (divides && (c == ';' || in_first_clause)) ends.push_back(i);
    if (divides) in_first_clause = false;
    if (is_mark && c == ',' && in_first_clause && !enumerates(meaning, i)) ends.push_back(i);
    const bool opens = c == '(' || c == '[' || c == '{';
    if (depth == 0 && in_first_clause && c == '(' && i > 1 && meaning[i - 1] == ' ' && meaning[i - 2] != ',')
      ends.push_back(i - 1);
    depth += opens ? 1 : c == ')' || c == ']' || c == '}' ? -1 : 0;
  }
  return ends;
}

}  // namespace

std::size_t length_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

Lines labelled(const std::string& label, const std::string& text) {
  Lines lines = split(terminal::paragraph(text, 0, screen_width - label_width));
  for (std::string& line : lines) line.insert(0, label_width, ' ');
  if (!lines.empty()) lines[0].replace(0, label.size(), label);
  return lines;
}

Lines listed(const std::string& label, const std::vector<std::string>& items, const std::string& separator,
             std::size_t most, const std::string& where) {
  if (items.empty()) return {};
  for (std::size_t count = items.size(); count > 0; --count) {
    std::string text = first_of(items, count, separator);
    if (count < items.size())
      text.append(separator).append(std::to_string(items.size() - count)).append(" more").append(where);
    Lines lines = labelled(label, text);
    if (lines.size() <= most) return lines;
  }
  return labelled(label, std::to_string(items.size()) + where);
}

Lines sentences(std::string_view text, std::size_t most) {
  Lines kept;
  for (std::size_t end = 0; end < text.size();) {
    end = std::min(text.find(". ", end), text.size());
    if (end < text.size()) ++end;  // the full stop
    Lines lines = split(terminal::paragraph(std::string(text.substr(0, end)), 0, screen_width));
    if (!kept.empty() && lines.size() > most) break;
    kept = std::move(lines);
  }
  return kept;
}

std::string shortened(const std::string& meaning, std::size_t width) {
  if (length_of(meaning) <= width) return meaning;
  const auto ends = ends_of(meaning);
  for (auto end = ends.rbegin(); end != ends.rend(); ++end) {
    const std::string part = meaning.substr(0, *end);
    if (length_of(part) <= width) return part;
  }
  std::string words = meaning;
  while (length_of(words) + 4 > width && words.find(' ') != std::string::npos) words.resize(words.find_last_of(' '));
  return words + " ...";
}

}  // namespace loadpath::cli
