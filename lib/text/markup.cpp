#include "lib/text/markup.hpp"

#include <optional>

namespace loadpath {
namespace {

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7f;
}

/// The entity of a character, empty for control characters; nothing for a character that is written as it is.
std::optional<std::string_view> entity(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return is_control(c) ? std::optional<std::string_view>("") : std::nullopt;
  }
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  std::size_t copied = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto other = entity(text[i]);
    if (!other) continue;
    out.append(text, copied, i - copied).append(*other);
    copied = i + 1;
  }
  return out.append(text, copied);
}

}  // namespace loadpath
