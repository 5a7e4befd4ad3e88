#include "lib/report/terminal/look.hpp"

#include "lib/report/terminal/layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace loadpath::terminal {

namespace {

/// Whether the locale that the environment names has UTF-8; where it names none, as on most servers, it is taken for
/// it.
bool has_utf8() {
  for (const char* variable : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const char* const set = std::getenv(variable);
    if (set == nullptr || *set == '\0') continue;
    const std::string_view value = set;
    return value.find("UTF-8") != std::string_view::npos || value.find("utf8") != std::string_view::npos ||
           value.find("UTF8") != std::string_view::npos || value.find("utf-8") != std::string_view::npos;
  }
  return true;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

bool is_within(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// The first `count` characters, and the rest.
std::pair<std::string, std::string> split_behind(const std::string& text, std::size_t count) {
  std::size_t at = 0;
  for (std::size_t seen = 0; at < text.size(); ++at) {
    if (is_within(text[at])) continue;
    if (seen++ == count) break;
  }
  return {text.substr(0, at), text.substr(at)};
}

}  // namespace

Look look_of_output() {
  constexpr std::size_t least = 60, most = 120;
  Look look{.utf8 = has_utf8()};
  winsize size{};
  if (isatty(STDOUT_FILENO) != 0 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col != 0)
    look.width = std::clamp<std::size_t>(size.ws_col, least, most);
  return look;
}

std::string bar(double utilisation, const Look& look) {
  constexpr int cells = 10, parts = 8;
  constexpr double rounding = 1e-9;
  constexpr std::array<const char*, parts> part_signs{"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};
  const bool beyond = utilisation > 1.0 + rounding;
  const int least = utilisation > 0.0 ? 1 : 0;
  const double filled = std::clamp(utilisation + rounding, 0.0, 1.0) * cells;
  std::string all;
  if (!look.utf8) {
    const int full = beyond ? cells - 1 : std::max(least, static_cast<int>(std::floor(filled)));
    return std::string(static_cast<std::size_t>(full), '#') + (beyond ? ">" : "") +
           std::string(static_cast<std::size_t>(cells - full - (beyond ? 1 : 0)), '.');
  }
  if (beyond) {
    for (int i = 1; i < cells; ++i) all += "█";
    return all + "▶";
  }
  const bool is_full = utilisation >= 1.0 - rounding;  // a value just below 1 does not look full
  const int most = cells * parts - (is_full ? 0 : 1);
  const int eighths = std::clamp(static_cast<int>(std::lround(filled * parts)), least, most);
  for (int i = 0; i < eighths / parts; ++i) all += "█";
  const int rest = eighths % parts;
  all += part_signs[static_cast<std::size_t>(rest)];
  for (int i = eighths / parts + (rest > 0 ? 1 : 0); i < cells; ++i) all += "░";
  return all;
}

std::string in_signs_of(std::string text, const Look& look) {
  replace_all(text, "\u00A0", " ");
  if (look.utf8) return text;
  constexpr std::array<std::pair<const char*, const char*>, 16> plain{{{"°", " deg"},
                                                                       {"·", "*"},
                                                                       {"µ", "u"},
                                                                       {"²", "^2"},
                                                                       {"³", "^3"},
                                                                       {"⁴", "^4"},
                                                                       {"⁻¹", "^-1"},
                                                                       {"√", "sqrt"},
                                                                       {"∛", "cbrt"},
                                                                       {"π", "pi"},
                                                                       {"−", "-"},
                                                                       {"–", "-"},
                                                                       {"…", "..."},
                                                                       {"≤", "<="},
                                                                       {"≥", ">="},
                                                                       {"×", "x"}}};
  for (const auto& [sign, word] : plain) replace_all(text, sign, word);
  return text;
}

std::size_t length_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return !is_within(c); }));
}

std::string padded(std::string text, std::size_t width) {
  const std::size_t length = length_of(text);
  return length >= width ? text : std::move(text) + std::string(width - length, ' ');
}

std::vector<std::string> lines_of(const std::string& text, std::size_t width, std::size_t hang) {
  std::vector<std::string> lines;
  const std::string all = paragraph(text, hang, width);
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t end = std::min(all.find('\n', at), all.size());
    std::string line = all.substr(at, end - at);
    while (length_of(line) > width) {
      auto [first, rest] = split_behind(line, width);
      lines.push_back(std::move(first));
      line = std::string(hang, ' ') + rest;
    }
    lines.push_back(std::move(line));
    at = end + 1;
  }
  return lines;
}

}  // namespace loadpath::terminal
