#include "lib/draw/motion/numbers.hpp"

#include "lib/quantity/format.hpp"

#include <cmath>

namespace loadpath::draw {

std::string number_text(const figure::Motion::Number& number, std::size_t frame) {
  const double si = number.si[frame];
  return std::isfinite(si) ? format_number(in_unit(si, number.unit), 5) : "–";
}

std::string printed(std::string number) {
  if (number.starts_with('-')) number.replace(0, 1, "−");
  return number;
}

}  // namespace loadpath::draw
