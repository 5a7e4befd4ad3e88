#include "calculators/section/shapes/ellipse.hpp"

#include "lib/calculator/calculator_of.hpp"

#include <cmath>

namespace loadpath::section {

template <class Tracer>
Ellipse::Result Ellipse::own(const Input& in, Tracer& trace) {
  const auto& [b, h] = in;
  Result r = centred();
  STEP_TO(r, A, pi / 4.0 * b * h, "area of an ellipse");
  STEP_TO(r, I_y, pi / 64.0 * b * pow<3>(h), "a circle, stretched");
  STEP_TO(r, I_z, pi / 64.0 * h * pow<3>(b), "a circle, stretched");
  STEP_TO(r, I_t, pi / 16.0 * pow<3>(b) * pow<3>(h) / (b * b + h * h), "torsion of an ellipse, [Anexa-BMOM]");
  STEP(a_t, max(b, h), "longer axis");
  STEP(b_t, min(b, h), "minor axis, at the ends of which the shear is maximum");
  STEP_TO(r, W_t, pi / 16.0 * a_t * b_t * b_t, "torsion of an ellipse, [Anexa-BMOM]");
  return r;
}

/// The ends of both axes, which are those of inertia.
Extremes Ellipse::extremes(const Input& in) {
  const Length none = 0.0 * mm;
  return {{in.b / 2.0, none}, {none, in.h / 2.0}, {-in.b / 2.0, none}, {none, -in.h / 2.0}};
}

Contours Ellipse::contours(const Input& in) {
  constexpr int points = 48;
  Contours contours;
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * pi * i / points;
    contours.outline.push_back({in.b / 2.0 * std::cos(angle), in.h / 2.0 * std::sin(angle)});
  }
  return contours;
}

void Ellipse::describe(const Input& in, SectionRecord& section) {
  section.kind = SectionKind::solid;
  section.h = in.h, section.b = in.b;
}

template Ellipse::Result Ellipse::own(const Input&, NoTrace&);
template Ellipse::Result Ellipse::own(const Input&, Trace&);

}  // namespace loadpath::section

template const loadpath::Calculator& loadpath::erased<loadpath::section::Ellipse>();
