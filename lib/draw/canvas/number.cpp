#include "lib/draw/canvas/number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace loadpath::draw {

void append_number(std::string& out, double value, double limit) {
  const double kept = std::isfinite(value) ? std::clamp(value, -limit, limit) : 0.0;
  const long hundredths = std::lround(100.0 * kept);
  if (hundredths < 0) out += '-';
  const long whole = std::labs(hundredths) / 100, part = std::labs(hundredths) % 100;
  char digits[24];
  if (whole > 0 || part == 0) out.append(digits, std::to_chars(digits, digits + sizeof digits, whole).ptr);
  if (part == 0) return;
  out += '.';
  out += static_cast<char>('0' + part / 10);
  if (part % 10 != 0) out += static_cast<char>('0' + part % 10);
}

}  // namespace loadpath::draw
