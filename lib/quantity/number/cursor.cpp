#include "lib/quantity/number/cursor.hpp"

#include <algorithm>

namespace loadpath {
namespace {

constexpr std::array<std::string_view, 3> signs = {"-", "\u2212", "+"};

}  // namespace

std::string Cursor::signed_integer() {
  Cursor ahead = *this;
  const std::string_view sign = ahead.take_any(signs), number = ahead.digits();
  if (number.empty()) return {};
  *this = ahead;
  return (sign.empty() || sign == "+" ? "" : "-") + std::string(number);
}

std::string Cursor::superscript() {
  if (peek() != '\xC2' && peek() != '\xE2') return {};
  Cursor ahead = *this;
  std::string number = ahead.take("⁻") ? "-" : "";
  const std::size_t sign = number.size();
  for (auto found = ahead.take_any(superscripts); !found.empty(); found = ahead.take_any(superscripts))
    number +=
        static_cast<char>('0' + (std::find(superscripts.begin(), superscripts.end(), found) - superscripts.begin()));
  if (number.size() == sign) return {};
  *this = ahead;
  return number;
}

}  // namespace loadpath
