// Reads from an SVG text what the figures' tests need.
#pragma once

#include "lib/draw/canvas/view.hpp"

#include <cctype>
#include <charconv>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::draw::test {

inline bool has(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

inline int count(std::string_view text, std::string_view part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// Every element is closed in its order, and a text or an attribute contains no markup.
inline bool well_formed(std::string_view svg) {
  std::vector<std::string_view> open;
  for (std::size_t at = svg.find('<'); at != std::string_view::npos; at = svg.find('<', at + 1)) {
    const std::size_t end = svg.find('>', at);
    if (end == std::string_view::npos) return false;
    const std::string_view tag = svg.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string_view::npos) return false;
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
    }
  }
  return open.empty();
}

/// The most decimals of any number outside of the style sheet and the texts.
inline int most_decimals(std::string_view svg) {
  int most = 0;
  bool in_tag = false;
  const std::size_t body = svg.find("</style>");
  for (std::size_t i = body; i < svg.size(); ++i) {
    if (svg[i] == '<') in_tag = true;
    if (svg[i] == '>') in_tag = false;
    if (!in_tag || svg[i] != '.') continue;
    int n = 0;
    while (std::isdigit(static_cast<unsigned char>(svg[i + 1 + static_cast<std::size_t>(n)])) != 0) ++n;
    most = std::max(most, n);
  }
  return most;
}

struct Element {
  std::string_view tag;   // with its attributes
  std::string_view text;  // with its markup
};

inline std::vector<Element> elements(std::string_view svg, std::string_view name) {
  std::vector<Element> found;
  const std::string start = "<" + std::string(name) + " ", close = "</" + std::string(name) + ">";
  for (std::size_t at = svg.find(start); at != std::string_view::npos; at = svg.find(start, at + 1)) {
    const std::size_t end = svg.find('>', at);
    const std::size_t stop = svg[end - 1] == '/' ? end + 1 : svg.find(close, end);
    found.push_back({svg.substr(at, end - at), svg.substr(end + 1, stop - end - 1)});
  }
  return found;
}

inline std::string_view attribute(std::string_view tag, std::string_view name) {
  const std::string key = " " + std::string(name) + "=\"";
  const std::size_t at = tag.find(key);
  if (at == std::string_view::npos) return {};
  const std::size_t begin = at + key.size();
  return tag.substr(begin, tag.find('"', begin) - begin);
}

inline double number(std::string_view tag, std::string_view name) {
  const std::string_view text = attribute(tag, name);
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// The words of a text without its markup.
inline std::string words(std::string_view marked) {
  std::string text;
  bool in_tag = false;
  for (const char c : marked) {
    if (c == '<') in_tag = true;
    if (!in_tag) text += c;
    if (c == '>') in_tag = false;
  }
  return text;
}

inline std::vector<std::string> texts(std::string_view svg) {
  std::vector<std::string> all;
  for (const Element& e : elements(svg, "text")) all.push_back(words(e.text));
  return all;
}

inline bool says(std::string_view svg, std::string_view text) {
  for (const std::string& t : texts(svg)) {
    if (t == text) return true;
  }
  return false;
}

/// About the box that a level text covers.
inline Box text_box(const Element& e) {
  double letters = 0.0;
  for (const char c : words(e.text)) letters += (static_cast<unsigned char>(c) & 0xC0) == 0x80 ? 0.0 : 1.0;
  const double wide = 0.5 * text_size * letters, x = number(e.tag, "x"), y = number(e.tag, "y");
  const std::string_view anchor = attribute(e.tag, "text-anchor");
  const double left = anchor == "middle" ? x - 0.5 * wide : anchor == "end" ? x - wide : x;
  return {left, y - 9.0, left + wide, y};
}

/// The first two texts that cover each other, or nothing.
inline std::string overlap(std::string_view svg) {
  const auto all = elements(svg, "text");
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const bool turned = has(all[i].tag, "rotate") || has(all[k].tag, "rotate");
      if (!turned && text_box(all[i]).meets(text_box(all[k]))) return words(all[k].text) + " / " + words(all[i].text);
    }
  }
  return {};
}

}  // namespace loadpath::draw::test
