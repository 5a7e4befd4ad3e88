#include "calculators/belt/geometry.hpp"

#include "lib/quantity/format.hpp"

#include <cmath>

namespace loadpath::belt {

namespace {

/// The length of a belt whose spans rise by `rise` over the centre distance, with arcs of `arcs` at equal wrap.
struct Shape {
  double rise;  // rise of a span, times two: difference of the diameters, or their sum where the belt is crossed
  double sum;   // sum of the diameters
  double d_1 = 0.0, d_2 = 0.0;
  bool turns = false;  // quarter-turn drive: by its diameters

  [[nodiscard]] double length(double a) const {
    if (turns) return 2.0 * a + around(d_1, a) + around(d_2, a);
    const double gamma = std::asin(rise / (2.0 * a));
    return 2.0 * a * std::cos(gamma) + sum * pi / 2.0 + rise * gamma;
  }
  /// With the pulleys so close that the spans vanish, or those of a quarter turn touch.
  [[nodiscard]] double least() const { return turns ? length(sum / 2.0) : (sum + rise) * pi / 2.0; }
  [[nodiscard]] double slope(double a) const {
    if (turns) return 2.0 - shrinking(d_1, a) - shrinking(d_2, a);
    return 2.0 * std::cos(std::asin(rise / (2.0 * a)));
  }

 private:
  /// The arc on a pulley of a quarter-turn drive, and how fast it falls with the centre distance.
  static double around(double d, double a) { return d * (pi / 2.0 + std::atan(d / (2.0 * a))); }
  static double shrinking(double d, double a) { return 2.0 * d * d / (4.0 * a * a + d * d); }
};

Shape shape_of(const Pulleys& p) {
  const double d_1 = in_si(p.d_1), d_2 = in_si(p.d_2);
  return {p.arrangement == Arrangement::crossed ? d_1 + d_2 : std::abs(d_2 - d_1), d_1 + d_2, d_1, d_2,
          p.arrangement == Arrangement::quarter_turn};
}

}  // namespace

Length centre_of_length(const Pulleys& pulleys) {
  const Shape shape = shape_of(pulleys);
  const double L = in_si(pulleys.L);
  if (!(L > shape.least())) return unset<Length>;
  double a = L / 2.0;
  for (int i = 0; i < 100; ++i) {
    const double next = a - (shape.length(a) - L) / shape.slope(a);
    if (!(next < a)) break;
    a = next;
  }
  return from_si<Length>(a);
}

bool stand_clear(const Pulleys& pulleys) {
  const Length least = (pulleys.d_1 + pulleys.d_2) / 2.0;
  if (is_set(pulleys.a)) return pulleys.a > least;
  return in_si(pulleys.L) > shape_of(pulleys).length(in_si(least));
}

FieldFault overlap(const Pulleys& pulleys) {
  const double least = in_si(pulleys.d_1 + pulleys.d_2) / 2.0;
  if (is_set(pulleys.a)) {
    return {
        "a", say("the pulleys would touch: their centres are {1} apart", format_quantity(in_si(pulleys.a), "mm")),
        say("the centre distance must be more than half the sum of the diameters, {1}", format_quantity(least, "mm"))};
  }
  return {"L", say("a belt of {1} is too short for these pulleys", format_quantity(in_si(pulleys.L), "mm")),
          say("pulleys that just touch need {1}", format_quantity(shape_of(pulleys).length(least), "mm"))};
}

}  // namespace loadpath::belt
