#include "calculators/section/shapes/rectangle.hpp"

#include "calculators/section/shapes/torsion.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::section {

template <class Tracer>
Rectangle::Result Rectangle::own(const Input& in, Tracer& trace) {
  const auto& [b, h] = in;
  Result r = centred();
  STEP_TO(r, A, b * h, "area of a rectangle");
  STEP_TO(r, I_y, b * pow<3>(h) / 12.0, "second moment of a rectangle about its middle line, [Garrison]");
  STEP_TO(r, I_z, h * pow<3>(b) / 12.0, "second moment of a rectangle about its middle line, [Garrison]");
  STEP(a_t, max(b, h), "longer side");
  STEP(b_t, min(b, h), "shorter side");
  const auto [k_1, k_2] = rectangle_factors(a_t / b_t);
  trace.value("k_1", k_1, "series of Saint-Venant for these sides: 0.1406 of a square, 1/3 of a strip, [Oasys]");
  STEP_TO(r, I_t, k_1 * a_t * pow<3>(b_t), "torsion of a rectangle");
  trace.value("k_2", k_2, "Saint-Venant series: maximum shear at the middle of the longer side");
  STEP_TO(r, W_t, k_2 * a_t * b_t * b_t, "torsion of a rectangle");
  return r;
}

Extremes Rectangle::extremes(const Input& in) { return box(in.b, in.h); }

Contours Rectangle::contours(const Input& in) { return {rectangle(in.b, in.h), {}}; }

void Rectangle::describe(const Input& in, SectionRecord& section) {
  section.kind = SectionKind::solid;
  section.h = in.h, section.b = in.b;
}

template Rectangle::Result Rectangle::own(const Input&, NoTrace&);
template Rectangle::Result Rectangle::own(const Input&, Trace&);

}  // namespace loadpath::section

template const loadpath::Calculator& loadpath::erased<loadpath::section::Rectangle>();
