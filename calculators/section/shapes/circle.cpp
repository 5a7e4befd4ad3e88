#include "calculators/section/shapes/circle.hpp"

#include "lib/calculator/calculator_of.hpp"

namespace loadpath::section {

template <class Tracer>
Circle::Result Circle::own(const Input& in, Tracer& trace) {
  const auto& [d] = in;
  Result r = centred();
  STEP_TO(r, A, pi / 4.0 * d * d, "area of a circle");
  STEP_TO(r, I_y, pi / 64.0 * pow<4>(d), "half the polar second moment of area, [B19]");
  STEP_TO(r, I_z, I_y, "every diameter is alike");
  STEP_TO(r, I_t, pi / 32.0 * pow<4>(d), "polar second moment of area, exact for circles, [B19]");
  STEP_TO(r, W_t, 2.0 * I_t / d, "maximum shear at the surface, [B19]");
  return r;
}

Extremes Circle::extremes(const Input& in) { return disc(in.d); }

Contours Circle::contours(const Input& in) { return {circle(in.d), {}}; }

void Circle::describe(const Input& in, SectionRecord& section) {
  section.kind = SectionKind::solid;
  section.d = in.d;
}

template Circle::Result Circle::own(const Input&, NoTrace&);
template Circle::Result Circle::own(const Input&, Trace&);

}  // namespace loadpath::section

template const loadpath::Calculator& loadpath::erased<loadpath::section::Circle>();
