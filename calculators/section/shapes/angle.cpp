#include "calculators/section/shapes/angle.hpp"

#include "calculators/section/shapes/corner.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::section {

namespace {

template <class Tracer>
void twist(const Angle::Input& in, Angle::Result& result, Tracer& trace) {
  const auto& [h, b, t, r, r_2] = in;
  STEP_TO(result, w, t / (min(h, b) - t), "thickness over length of the shorter leg");
  if (!(w <= thickest_open_wall)) return;
  STEP(K_1, max(h, b) * pow<3>(t) * (1.0 / 3.0 - 0.21 * (t / max(h, b)) * (1.0 - pow<4>(t / max(h, b)) / 12.0)),
       "the longer leg, a rectangle, [Roark]");
  STEP(l, min(h, b) - t, "length of the other leg");
  STEP(K_2, l * pow<3>(t) * (1.0 / 3.0 - 0.105 * (t / l) * (1.0 - pow<4>(t / l) / 192.0)),
       "a rectangle with one free end, [Roark]");
  STEP(D, (4.0 - 2.0 * sqrt(2.0)) * t, "inscribed circle where the legs meet, without the fillet, [Roark]");
  STEP_TO(result, I_t, K_1 + K_2 + 0.07 * pow<4>(D), "both legs and their joint, [Roark]");
  STEP_TO(result, W_t, I_t / t, "shear in the thin walls");
}

}  // namespace

template <class Tracer>
Angle::Result Angle::own(const Input& in, Tracer& trace) {
  const auto& [h, b, t, r, r_2] = in;
  Result result;
  const auto [A_r, e_r, I_r, I_rp] = corner(r, trace);
  NoTrace quiet;
  const auto [A_2, e_2, I_2, I_2p] = corner(r_2, quiet);
  trace.value("I_rp", I_rp, "product of area of the root fillet about its own axes");
  trace.value("A_2", A_2, "area that a rounded toe lacks, by the formulas of the fillet");
  trace.value("e_2", e_2, "its centroid from the faces of the leg");
  trace.value("I_2", I_2, "its second moment");
  trace.value("I_2p", I_2p, "its product of area");
  STEP_TO(result, A, t * (h + b - t) + A_r - 2.0 * A_2, "two legs, the root fillet, less the toes");
  STEP_TO(result, y_S,
          (h * t * t + (b * b - t * t) * t + 2.0 * A_r * (t + e_r) - 2.0 * A_2 * (t - e_2 + b - e_2)) / (2.0 * A),
          "first moment about the back of the upright leg over the area");
  STEP_TO(result, z_S,
          (b * t * t + (h * h - t * t) * t + 2.0 * A_r * (t + e_r) - 2.0 * A_2 * (t - e_2 + h - e_2)) / (2.0 * A),
          "first moment about the back of the other leg over the area");
  STEP_TO(result, I_y,
          (t * pow<3>(h) + (b - t) * pow<3>(t)) / 3.0 + I_r + A_r * pow<2>(t + e_r) - 2.0 * I_2 -
              A_2 * (pow<2>(t - e_2) + pow<2>(h - e_2)) - A * z_S * z_S,
          "about the back of the leg, brought to the centroid by Steiner, [Garrison]");
  STEP_TO(result, I_z,
          (t * pow<3>(b) + (h - t) * pow<3>(t)) / 3.0 + I_r + A_r * pow<2>(t + e_r) - 2.0 * I_2 -
              A_2 * (pow<2>(t - e_2) + pow<2>(b - e_2)) - A * y_S * y_S,
          "about the back of the leg, brought to the centroid by Steiner, [Garrison]");
  STEP_TO(result, I_yz,
          t * t * (h * h + b * b - t * t) / 4.0 + I_rp + A_r * pow<2>(t + e_r) - 2.0 * I_2p -
              A_2 * (t - e_2) * (h - e_2 + b - e_2) - A * y_S * z_S,
          "about the corner, brought to the centroid by Steiner, [Garrison]");
  twist(in, result, trace);
  return result;
}

Extremes Angle::extremes(const Input& in) {
  const auto& [h, b, t, r, r_2] = in;
  const Length none = from_si<Length>(0.0);
  return {{none, none}, {b, none}, {none, h}, {b - r_2, t - r_2, r_2}, {t - r_2, h - r_2, r_2}};
}

Contours Angle::contours(const Input& in) { return {angle_outline(in.h, in.b, in.t, in.r, in.r_2), {}}; }

void Angle::describe(const Input& in, SectionRecord& section) {
  section.kind = SectionKind::angle;
  section.h = in.h, section.b = in.b;
  section.t_f = section.t_w = in.t, section.r = in.r;
}

template Angle::Result Angle::own(const Input&, NoTrace&);
template Angle::Result Angle::own(const Input&, Trace&);

}  // namespace loadpath::section

template const loadpath::Calculator& loadpath::erased<loadpath::section::Angle>();
