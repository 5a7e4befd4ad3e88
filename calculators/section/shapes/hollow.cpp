#include "calculators/section/shapes/hollow.hpp"

#include "calculators/section/shapes/corner.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::section {

namespace {

/// Torsion of a closed thin wall with its corners.
template <class Tracer>
void twist(const Hollow::Input& in, Hollow::Result& result, Tracer& trace) {
  const auto& [h, b, t, r_o, r_i, fabrication] = in;
  STEP_TO(result, w, t / (min(h, b) - t), "thickness over the shorter middle line");
  if (!(w <= thickest_closed_wall)) return;
  STEP(R_c, (r_o + r_i) / 2.0, "radius of the middle line in a corner, [EN10210-2]");
  STEP(h_m, 2.0 * (b - t + h - t) - 2.0 * R_c * (4.0 - pi), "length of the middle line, [EN10210-2]");
  STEP(A_h, (b - t) * (h - t) - R_c * R_c * (4.0 - pi), "area that the middle line encloses, [EN10210-2]");
  STEP(K, 2.0 * A_h * t / h_m, "Bredt, [EN10210-2]");
  STEP_TO(result, I_t, pow<3>(t) * h_m / 3.0 + 2.0 * K * A_h, "closed wall, and the wall by itself, [EN10210-2]");
  STEP_TO(result, W_t, I_t / (t + K / t), "shear at the outer face, [EN10210-2]");
}

}  // namespace

template <class Tracer>
Hollow::Result Hollow::own(const Input& in, Tracer& trace) {
  const auto& [h, b, t, r_o, r_i, fabrication] = in;
  Result result{centred()};
  NoTrace quiet;
  const auto [A_o, e_o, I_o, I_op] = corner(r_o, quiet);
  const auto [A_i, e_i, I_i, I_ip] = corner(r_i, quiet);
  trace.value("A_o", A_o, "area that a rounded outer corner lacks: (1 - pi/4) r_o^2");
  trace.value("e_o", e_o, "from the faces to its centroid: 0.2234 r_o");
  trace.value("I_o", I_o, "its second moment: 0.007545 r_o^4");
  trace.value("A_i", A_i, "area in an inner corner, likewise");
  trace.value("e_i", e_i, "from the inner faces to its centroid");
  trace.value("I_i", I_i, "its second moment");
  STEP_TO(result, A, b * h - (b - 2.0 * t) * (h - 2.0 * t) - 4.0 * A_o + 4.0 * A_i,
          "outer less inner rectangle, with the corners");
  STEP_TO(result, I_y,
          (b * pow<3>(h) - (b - 2.0 * t) * pow<3>(h - 2.0 * t)) / 12.0 - 4.0 * (I_o + A_o * pow<2>(h / 2.0 - e_o)) +
              4.0 * (I_i + A_i * pow<2>(h / 2.0 - t - e_i)),
          "outer less inner rectangle, the corners by Steiner, [EN10210-2]");
  STEP_TO(result, I_z,
          (h * pow<3>(b) - (h - 2.0 * t) * pow<3>(b - 2.0 * t)) / 12.0 - 4.0 * (I_o + A_o * pow<2>(b / 2.0 - e_o)) +
              4.0 * (I_i + A_i * pow<2>(b / 2.0 - t - e_i)),
          "outer less inner rectangle, the corners by Steiner, [EN10210-2]");
  twist(in, result, trace);
  return result;
}

Extremes Hollow::extremes(const Input& in) { return rounded_box(in.b, in.h, in.r_o); }

Contours Hollow::contours(const Input& in) {
  const Length b_i = in.b - 2.0 * in.t, h_i = in.h - 2.0 * in.t;
  return {rectangle(in.b, in.h, in.r_o), rectangle(b_i, h_i, in.r_i)};
}

void Hollow::describe(const Input& in, SectionRecord& section) {
  section.kind = kind_of(in.fabrication);
  section.h = in.h, section.b = in.b;
  section.t_f = section.t_w = in.t;
}

template Hollow::Result Hollow::own(const Input&, NoTrace&);
template Hollow::Result Hollow::own(const Input&, Trace&);

}  // namespace loadpath::section

template const loadpath::Calculator& loadpath::erased<loadpath::section::Hollow>();
