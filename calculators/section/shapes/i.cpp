#include "calculators/section/shapes/i.hpp"

#include "calculators/section/shapes/corner.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::section {

namespace {

/// Torsion of three plates, more for their T-junctions and less for the ends of the flanges.
template <class Tracer>
void twist(const I::Input& in, I::Result& result, Tracer& trace) {
  const auto& [h, b, t_w, t_f, r] = static_cast<const Flanged&>(in);
  STEP_TO(result, w_t, t_w / t_f, "range of the rolled sections that the torsion constant was checked with");
  STEP_TO(result, w_r, r / t_f, "range of the rolled sections that the torsion constant was checked with");
  if (!ranges_of_I.hold(w_t, w_r)) return;
  STEP(alpha_1, -0.042 + 0.2204 * w_t + 0.1355 * w_r - 0.0865 * w_r * w_t - 0.0725 * w_t * w_t,
       "T-junction of web and flange, [SCI-P385]");
  STEP(D_1, (pow<2>(t_f + r) + (r + t_w / 4.0) * t_w) / (2.0 * r + t_f), "circle in the junction, [SCI-P385]");
  STEP_TO(result, I_t,
          2.0 / 3.0 * b * pow<3>(t_f) + (h - 2.0 * t_f) * pow<3>(t_w) / 3.0 + 2.0 * alpha_1 * pow<4>(D_1) -
              0.420 * pow<4>(t_f),
          "flanges, web, two junctions, four ends of flanges, [SCI-P385]");
  STEP_TO(result, W_t, I_t / max(t_w, t_f), "shear in the thickest plate, without the stress raised in the fillets");
}

}  // namespace

template <class Tracer>
I::Result I::own(const Input& in, Tracer& trace) {
  const auto& [h, b, t_w, t_f, r] = static_cast<const Flanged&>(in);
  Result result{centred()};
  const auto [A_r, e_r, I_r, I_rp] = corner(r, trace);
  STEP_TO(result, A, 2.0 * b * t_f + (h - 2.0 * t_f) * t_w + 4.0 * A_r, "flanges, web and four fillets");
  STEP_TO(result, I_y,
          (b * pow<3>(h) - (b - t_w) * pow<3>(h - 2.0 * t_f)) / 12.0 + 4.0 * (I_r + A_r * pow<2>(h / 2.0 - t_f - e_r)),
          "the rectangle less the open areas next to the web, plus the fillets by Steiner, [Garrison]");
  STEP_TO(result, I_z,
          (2.0 * t_f * pow<3>(b) + (h - 2.0 * t_f) * pow<3>(t_w)) / 12.0 + 4.0 * (I_r + A_r * pow<2>(t_w / 2.0 + e_r)),
          "flanges, web, and the fillets by Steiner, [Garrison]");
  twist(in, result, trace);
  return result;
}

Extremes I::extremes(const Input& in) { return box(in.b, in.h); }

Contours I::contours(const Input& in) { return {i_outline(in.h, in.b, in.t_w, in.t_f, in.r), {}}; }

void I::describe(const Input& in, SectionRecord& section) {
  section.kind = kind_of(in.fabrication);
  section.h = in.h, section.b = in.b;
  section.t_f = in.t_f, section.t_w = in.t_w, section.r = in.r;
}

template I::Result I::own(const Input&, NoTrace&);
template I::Result I::own(const Input&, Trace&);

}  // namespace loadpath::section

template const loadpath::Calculator& loadpath::erased<loadpath::section::I>();
