#include "lib/draw/canvas/style.hpp"

#include "lib/report/html/base64.hpp"
#include "lib/report/html/html.hpp"
#include "lib/report/html/used_rules.hpp"
#include "lib/text/embedded.hpp"

#include <cstdint>
#include <cstring>

namespace loadpath::report::page {
namespace {

/// A CSS string: all characters but letters and digits are written as codes, so that nothing ends the string or the
/// sheet.
std::string css_string(std::string_view words) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : words) {
    const auto byte = static_cast<unsigned char>(c);
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ';
    if (letter || byte >= 0x80) {
      out += c;
    } else if (byte >= 0x20 && byte != 0x7f) {
      out += std::string("\\") + digits[byte >> 4] + digits[byte & 15] + " ";
    }
  }
  return out + "\"";
}

std::string page_rules(const Running& running, std::string_view paper) {
  const std::string face = "font:7pt \"Loadpath Sans\",sans-serif;color:#555;vertical-align:top;padding-top:2mm;";
  const auto corner = [&](const char* place, const std::string& content) {
    return std::string("@") + place + "{" + face + "content:" + content + "}";
  };
  return "@page{size:" + std::string(paper) + ";margin:11mm 15mm 14mm 20mm;" +
         corner("bottom-left", css_string(running.title)) + corner("bottom-center", css_string(running.program)) +
         corner("bottom-right", "counter(page) \" / \" counter(pages)") + "}\n";
}

std::string font(const char* family, const char* file, const char* more) {
  return std::string("@font-face{font-family:\"") + family + "\";src:url(data:font/woff2;base64," +
         base64(embedded::asset(file)) + ") format(\"woff2\")" + more + "}";
}

/// Letters of scripts/subset-sans.sh, `more`: accents of Latin but for German ones, Cyrillic.
bool is_rare(char32_t letter) {
  constexpr std::u32string_view frequent = U"\u00A0°±²³µ·¹¼½¾ÄÖ×ØÜßäö÷ü";
  constexpr char32_t first = 0xA0, last_latin = 0x17F, first_cyrillic = 0x400, last_cyrillic = 0x45F;
  if (letter >= first_cyrillic) return letter <= last_cyrillic;
  return first <= letter && letter <= last_latin && frequent.find(letter) == std::u32string_view::npos;
}

/// Whether the next eight bytes are ASCII.
bool begins_with_ascii(std::string_view text) {
  std::uint64_t eight = 0;
  if (text.size() < sizeof eight) return false;
  std::memcpy(&eight, text.data(), sizeof eight);
  return (eight & 0x8080808080808080U) == 0;
}

/// Bytes that begin such a letter are looked for first, for pages are long.
bool has_rare_letters(std::string_view page) {
  for (std::size_t at = 0; at + 1 < page.size(); ++at) {
    while (begins_with_ascii(page.substr(at))) at += sizeof(std::uint64_t);
    if (at + 1 >= page.size()) return false;
    const auto byte = static_cast<unsigned char>(page[at]);
    const bool is_of_two = (byte & 0xE0U) == 0xC0U;
    if (!is_of_two) continue;
    const auto next = static_cast<unsigned char>(page[at + 1]);
    if (is_rare(static_cast<char32_t>((byte & 0x1FU) << 6U | (next & 0x3FU)))) return true;
  }
  return false;
}

std::string fonts(bool with_rare_letters) {
  constexpr const char* range =
      ";font-weight:400;unicode-range:U+A1-AF,U+B4,U+B6,U+B8,U+BA,U+BB,U+BF-C3,U+C5-D5,U+D9-DB,"
      "U+DD,U+DE,U+E0-E3,U+E5-F5,U+F8-FB,U+FD-17F,U+400-45F";
  const std::string rare =
      with_rare_letters ? font("Loadpath Sans", "fonts/loadpath-sans-more.woff2", range) : std::string();
  return font("Loadpath Math", "fonts/loadpath-math.woff2", "") +
         font("Loadpath Sans", "fonts/loadpath-sans.woff2", ";font-weight:400") + rare +
         font("Loadpath Sans", "fonts/loadpath-sans-semibold.woff2", ";font-weight:600 700") +
         font("Loadpath Sans", "fonts/loadpath-sans-italic.woff2", ";font-style:italic");
}

}  // namespace

std::string style(const Running& running, std::string_view paper, std::string_view page) {
  const bool with_rare_letters = has_rare_letters(page) || has_rare_letters(running.title);
  const std::string sheet = draw::style_sheet() + "\n" + std::string(embedded::asset("report.css"));
  return fonts(with_rare_letters) + used_rules(sheet, page) + page_rules(running, paper);
}

}  // namespace loadpath::report::page
