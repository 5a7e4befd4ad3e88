#include "lib/draw/canvas/style.hpp"

#include "lib/report/html/base64.hpp"
#include "lib/report/html/html.hpp"
#include "lib/text/embedded.hpp"

namespace loadpath::report::page {
namespace {

/// A CSS string: all characters but letters and digits are written as codes, so that nothing ends the string or the
/// sheet.
std::string quoted(std::string_view words) {
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

std::string page_rules(std::string_view header, std::string_view footer, std::string_view paper) {
  const std::string face =
      "font:9pt Cambria,\"STIX Two Text\",STIX,\"Liberation Serif\",\"Times New Roman\",serif;color:#5b626b;";
  return "@page{size:" + std::string(paper) + ";margin:18mm 18mm 17mm;@top-left{" + face + "content:" + quoted(header) +
         "}@bottom-left{" + face + "content:" + quoted(footer) + "}@bottom-right{" + face +
         "content:counter(page) \" / \" counter(pages)}}\n@page:first{@top-left{content:none}}\n";
}

std::string math_font() {
  return "@font-face{font-family:\"Loadpath Math\";src:url(data:font/woff2;base64," +
         base64(embedded::asset("fonts/loadpath-math.woff2")) + ") format(\"woff2\")}\n";
}

}  // namespace

std::string style(std::string_view header, std::string_view footer, std::string_view paper) {
  return math_font() + std::string(embedded::asset("report.css")) + draw::style_sheet() + "\n" +
         page_rules(header, footer, paper);
}

}  // namespace loadpath::report::page
