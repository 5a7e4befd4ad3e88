#include "lib/text/utf8.hpp"

#include <cstdint>
#include <cstring>

namespace loadpath {
namespace {

/// Length of the well-formed sequence at `at`, 0 if there is none (overlong forms, surrogates, beyond U+10FFFF).
std::size_t well_formed_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U; };
  const auto tail = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned lead = byte(0), second = byte(1);
  if (lead < 0x80) return 1;
  if (lead < 0xC2 || lead > 0xF4 || !tail(1)) return 0;
  if (lead < 0xE0) return 2;
  if (lead < 0xF0) {
    const bool overlong = lead == 0xE0 && second < 0xA0, surrogate = lead == 0xED && second > 0x9F;
    return tail(2) && !overlong && !surrogate ? 3 : 0;
  }
  const bool overlong = lead == 0xF0 && second < 0x90, beyond = lead == 0xF4 && second > 0x8F;
  return tail(2) && tail(3) && !overlong && !beyond ? 4 : 0;
}

char32_t decode(std::string_view bytes) {
  const auto byte = [&](std::size_t i) { return static_cast<char32_t>(static_cast<unsigned char>(bytes[i])); };
  if (bytes.size() == 1) return byte(0);
  char32_t point = byte(0) & (0xFFU >> (bytes.size() + 1));
  for (std::size_t i = 1; i < bytes.size(); ++i) point = point << 6U | (byte(i) & 0x3FU);
  return point;
}

/// Eight ASCII characters at a time: nearly all text is.
std::size_t ascii_prefix(std::string_view text) {
  std::size_t i = 0;
  for (std::uint64_t eight = 0; i + sizeof eight <= text.size(); i += sizeof eight) {
    std::memcpy(&eight, text.data() + i, sizeof eight);
    if ((eight & 0x8080808080808080U) != 0) break;
  }
  return i;
}

}  // namespace

std::size_t first_invalid_byte(std::string_view text) {
  for (std::size_t i = ascii_prefix(text); i < text.size();) {
    const std::size_t length = well_formed_length(text, i);
    if (length == 0) return i;
    i += length;
  }
  return std::string_view::npos;
}

std::size_t first_control(std::string_view text, std::string_view allowed) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool in_ascii = (byte < 0x20 && allowed.find(text[i]) == std::string_view::npos) || byte == 0x7F;
    const bool beyond = byte == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (in_ascii || beyond) return i;
  }
  return std::string_view::npos;
}

std::size_t character_length(std::string_view text, std::size_t at) {
  const std::size_t length = at < text.size() ? well_formed_length(text, at) : 1;
  return length == 0 ? 1 : length;
}

std::u32string code_points(std::string_view text) {
  std::u32string points;
  points.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    points += decode(text.substr(i, length));
    i += length;
  }
  return points;
}

std::string utf8(std::u32string_view points) {
  std::string text;
  const auto put = [&](char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  for (const char32_t p : points) {
    if (p < 0x80) {
      put(p);
    } else if (p < 0x800) {
      put(0xC0U | p >> 6U), put(0x80U | (p & 0x3FU));
    } else if (p < 0x10000) {
      put(0xE0U | p >> 12U), put(0x80U | (p >> 6U & 0x3FU)), put(0x80U | (p & 0x3FU));
    } else {
      put(0xF0U | p >> 18U), put(0x80U | (p >> 12U & 0x3FU)), put(0x80U | (p >> 6U & 0x3FU)), put(0x80U | (p & 0x3FU));
    }
  }
  return text;
}

char32_t lower_case(char32_t point) {
  if ((point >= U'A' && point <= U'Z') || (point >= 0x410 && point <= 0x42F)) return point + 0x20;
  if (point >= 0xC0 && point <= 0xDE && point != 0xD7) return point + 0x20;
  if (point >= 0x400 && point <= 0x40F) return point + 0x50;
  return point == 0x490 ? 0x491 : point;
}

}  // namespace loadpath
