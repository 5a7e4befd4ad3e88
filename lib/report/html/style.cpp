#include "lib/draw/canvas/style.hpp"

#include "lib/report/html/base64.hpp"
#include "lib/report/html/html.hpp"
#include "lib/text/embedded.hpp"

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
         base64(embedded::asset(file)) + ") format(\"woff2\")" + more + "}\n";
}

std::string fonts() {
  return font("Loadpath Math", "fonts/loadpath-math.woff2", "") +
         font("Loadpath Sans", "fonts/loadpath-sans.woff2", ";font-weight:400") +
         font("Loadpath Sans", "fonts/loadpath-sans-semibold.woff2", ";font-weight:600 700") +
         font("Loadpath Sans", "fonts/loadpath-sans-italic.woff2", ";font-style:italic");
}

}  // namespace

std::string style(const Running& running, std::string_view paper) {
  return fonts() + draw::style_sheet() + "\n" + std::string(embedded::asset("report.css")) + page_rules(running, paper);
}

}  // namespace loadpath::report::page
