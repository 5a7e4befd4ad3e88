#include "calculators/section/shapes/ring.hpp"

#include "lib/calculator/calculator_of.hpp"

namespace loadpath::section {

template <class Tracer>
Ring::Result Ring::own(const Input& in, Tracer& trace) {
  Result r = centred();
  const Length d_i = is_set(in.t) ? NAMED_STEP("d_i", in.d - 2.0 * in.t, "bore that the wall leaves") : in.d_i;
  STEP_TO(r, A, pi / 4.0 * (in.d * in.d - d_i * d_i), "area of a ring");
  STEP_TO(r, I_y, pi / 64.0 * (pow<4>(in.d) - pow<4>(d_i)), "half the polar second moment of area, [B19]");
  STEP_TO(r, I_z, I_y, "every diameter is alike");
  STEP_TO(r, I_t, pi / 32.0 * (pow<4>(in.d) - pow<4>(d_i)), "polar second moment of area, exact for rings, [B19]");
  STEP_TO(r, W_t, 2.0 * I_t / in.d, "maximum shear at the surface, [B19]");
  return r;
}

Extremes Ring::extremes(const Input& in) { return disc(in.d); }

Contours Ring::contours(const Input& in) {
  const Length d_i = is_set(in.t) ? in.d - 2.0 * in.t : in.d_i;
  return {circle(in.d), circle(d_i)};
}

void Ring::describe(const Input& in, SectionRecord& section) {
  section.kind = kind_of(in.fabrication);
  section.d = in.d;
  section.t_w = is_set(in.t) ? in.t : 0.5 * (in.d - in.d_i);
}

template Ring::Result Ring::own(const Input&, NoTrace&);
template Ring::Result Ring::own(const Input&, Trace&);

}  // namespace loadpath::section

template const loadpath::Calculator& loadpath::erased<loadpath::section::Ring>();
