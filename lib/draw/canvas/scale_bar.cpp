#include "lib/draw/canvas/scale_bar.hpp"

#include "lib/draw/canvas/ticks.hpp"
#include "lib/quantity/format.hpp"

namespace loadpath::draw {

std::string force_text(double newton) {
  return newton >= 1e6 ? format_quantity(newton, "MN", 4) : format_quantity(newton, newton >= 1e3 ? "kN" : "N", 4);
}
std::string length_text(double metre) { return format_quantity(metre, metre >= 1.0 ? "m" : "mm", 4); }

double scale_bar(Canvas& canvas, Point from, double view_per_si, std::string (*written)(double)) {
  constexpr double longest = 80.0;
  const double value = round_below(longest / view_per_si);
  const Point to{from.x + value * view_per_si, from.y}, tick{0.0, 3.5};
  canvas.strokes("thin", {{from, to}, {from - tick, from + tick}, {to - tick, to + tick}});
  const Text text = typeset(written(value));
  canvas.text("quiet", to + Point{7.0, 4.0}, text);
  return to.x + 7.0 + width(text, text_size) + 26.0;
}

}  // namespace loadpath::draw
