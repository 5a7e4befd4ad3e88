#include "calculators/section/shapes/tee.hpp"

#include "calculators/section/shapes/corner.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::section {

namespace {

template <class Tracer>
void twist(const Tee::Input& in, Tee::Result& result, Tracer& trace) {
  const auto& [h, b, t_w, t_f, r] = in;
  STEP_TO(result, w, max(t_w / (h - t_f), t_f / b), "thickness over length of the stubbier wall");
  if (!(w <= thickest_open_wall)) return;
  STEP_TO(result, I_t, (b * pow<3>(t_f) + (h - t_f) * pow<3>(t_w)) / 3.0, "thin open walls, [Oasys]");
  STEP_TO(result, W_t, I_t / max(t_w, t_f), "shear in the thickest wall");
}

}  // namespace

template <class Tracer>
Tee::Result Tee::own(const Input& in, Tracer& trace) {
  const auto& [h, b, t_w, t_f, r] = in;
  Result result{centred()};
  const auto [A_r, e_r, I_r, I_rp] = corner(r, trace);
  STEP_TO(result, A, b * t_f + (h - t_f) * t_w + 2.0 * A_r, "flange, web and two fillets");
  STEP_TO(result, z_S, -(b * t_f * t_f + (h * h - t_f * t_f) * t_w + 4.0 * A_r * (t_f + e_r)) / (2.0 * A),
          "first moment about the upper face over the area, downwards negative");
  STEP_TO(
      result, I_y,
      (b * pow<3>(t_f) + t_w * (pow<3>(h) - pow<3>(t_f))) / 3.0 + 2.0 * (I_r + A_r * pow<2>(t_f + e_r)) - A * z_S * z_S,
      "about the upper face, brought to the centroid by Steiner, [Garrison]");
  STEP_TO(result, I_z, (t_f * pow<3>(b) + (h - t_f) * pow<3>(t_w)) / 12.0 + 2.0 * (I_r + A_r * pow<2>(t_w / 2.0 + e_r)),
          "flange, web, and the fillets by Steiner, [Garrison]");
  twist(in, result, trace);
  return result;
}

Extremes Tee::extremes(const Input& in) { return corners_of(tee_outline(in.h, in.b, in.t_w, in.t_f)); }

Contours Tee::contours(const Input& in) { return {tee_outline(in.h, in.b, in.t_w, in.t_f, in.r), {}}; }

void Tee::describe(const Input& in, SectionRecord& section) {
  section.kind = SectionKind::tee;
  section.h = in.h, section.b = in.b;
  section.t_f = in.t_f, section.t_w = in.t_w, section.r = in.r;
}

template Tee::Result Tee::own(const Input&, NoTrace&);
template Tee::Result Tee::own(const Input&, Trace&);

}  // namespace loadpath::section

template const loadpath::Calculator& loadpath::erased<loadpath::section::Tee>();
