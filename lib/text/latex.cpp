#include "lib/text/latex.hpp"

#include "lib/text/utf8.hpp"

#include <algorithm>
#include <array>

namespace loadpath {
namespace {

/// A character with a meaning in LaTeX, and its replacement.
struct Command {
  char32_t letter;
  std::u32string_view tex;
};
constexpr std::array commands = {Command{U'\\', U"\\textbackslash{}"},
                                 Command{U'^', U"\\textasciicircum{}"},
                                 Command{U'~', U"\\textasciitilde{}"},
                                 Command{U'`', U"\\textasciigrave{}"},
                                 Command{U'{', U"\\{"},
                                 Command{U'}', U"\\}"},
                                 Command{U'$', U"\\$"},
                                 Command{U'&', U"\\&"},
                                 Command{U'#', U"\\#"},
                                 Command{U'%', U"\\%"},
                                 Command{U'_', U"\\_"}};

/// Empty: the character itself.
std::u32string_view command(char32_t letter) {
  const auto* found = std::ranges::find(commands, letter, &Command::letter);
  return found == commands.end() ? std::u32string_view() : found->tex;
}

/// Two of them in a row would be set as another sign: -- as a dash.
bool is_doubled(char32_t c) { return c == U'-' || c == U'<' || c == U'>' || c == U',' || c == U'\''; }

/// Left out: control characters that no source may hold, and the mark of the byte order.
bool is_unwanted(char32_t c) { return (c >= 0x7F && c < 0xA0) || c == 0xFEFF; }
bool is_blank(char32_t c) { return c < 0x20 || c == 0x2028 || c == 0x2029; }

}  // namespace

std::string latex_text(std::string_view text) {
  std::u32string out;
  char32_t last = 0;
  for (const char32_t c : code_points(text)) {
    if (is_unwanted(c)) continue;
    const std::u32string_view other = command(c);
    if (out.empty() &&
        (c == U'[' || c == U'*')) {  // at the start of a row it would belong to the end of the previous one
      out += {U'{', c, U'}'};
    } else if (is_blank(c)) {
      out += U' ';
    } else {
      if (c == last && is_doubled(c)) out += U"{}";
      other.empty() ? out += c : out += other;
    }
    last = c;
  }
  return utf8(out);
}

}  // namespace loadpath
