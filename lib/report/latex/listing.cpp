#include "lib/report/latex/tex.hpp"
#include "lib/text/latex.hpp"
#include "lib/text/utf8.hpp"

#include <algorithm>

namespace loadpath::report::tex {
namespace {

constexpr std::string_view begin = "\\begin{verbatim}\n", end = "\\end{verbatim}";

/// Tabs, which TeX takes for one blank, are two; other control characters are left out.
std::string without_control(std::string_view line) {
  std::u32string out;
  for (const char32_t c : code_points(line)) {
    const bool is_control = c < 0x20 || (c >= 0x7F && c < 0xA0);
    if (c == U'\t') out += U"  ";
    if (!is_control) out += c;
  }
  return utf8(out);
}

}  // namespace

std::string listing(std::string_view text) {
  std::string out = "{\\scriptsize\\lpbreaklines\n" + std::string(begin);
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    const std::string line = without_control(text.substr(0, length));
    // A line that would end the environment is written outside.
    out += line.find(end) == std::string::npos
               ? line + "\n"
               : std::string(end) + "\n\\texttt{" + latex_text(line) + "}\n" + std::string(begin);
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return out + std::string(end) + "\n}\n\n";
}

}  // namespace loadpath::report::tex
