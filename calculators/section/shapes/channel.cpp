#include "calculators/section/shapes/channel.hpp"

#include "calculators/section/shapes/corner.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::section {

namespace {

template <class Tracer>
void twist(const Channel::Input& in, Channel::Result& result, Tracer& trace) {
  const auto& [h, b, t_w, t_f, r] = in;
  STEP_TO(result, w, max(t_w / (h - 2.0 * t_f), t_f / b), "thickness over length of the stubbier wall");
  if (!(w <= thickest_open_wall)) return;
  STEP_TO(result, I_t, (2.0 * b * pow<3>(t_f) + (h - 2.0 * t_f) * pow<3>(t_w)) / 3.0, "thin open walls, [Oasys]");
  STEP_TO(result, W_t, I_t / max(t_w, t_f), "shear in the thickest wall");
}

}  // namespace

template <class Tracer>
Channel::Result Channel::own(const Input& in, Tracer& trace) {
  const auto& [h, b, t_w, t_f, r] = in;
  Result result{centred()};
  const auto [A_r, e_r, I_r, I_rp] = corner(r, trace);
  STEP_TO(result, A, 2.0 * b * t_f + (h - 2.0 * t_f) * t_w + 2.0 * A_r, "flanges, web and two fillets");
  STEP_TO(result, y_S, (b * b * t_f + (h - 2.0 * t_f) * t_w * t_w / 2.0 + 2.0 * A_r * (t_w + e_r)) / A,
          "first moment about the back of the web over the area");
  STEP_TO(result, I_y,
          (b * pow<3>(h) - (b - t_w) * pow<3>(h - 2.0 * t_f)) / 12.0 + 2.0 * (I_r + A_r * pow<2>(h / 2.0 - t_f - e_r)),
          "the rectangle less the open areas next to the web, plus the fillets by Steiner, [Garrison]");
  STEP_TO(result, I_z,
          (2.0 * t_f * pow<3>(b) + (h - 2.0 * t_f) * pow<3>(t_w)) / 3.0 + 2.0 * (I_r + A_r * pow<2>(t_w + e_r)) -
              A * y_S * y_S,
          "about the back of the web, brought to the centroid by Steiner, [Garrison]");
  twist(in, result, trace);
  return result;
}

Extremes Channel::extremes(const Input& in) { return corners_of(channel_outline(in.h, in.b, in.t_w, in.t_f)); }

Contours Channel::contours(const Input& in) { return {channel_outline(in.h, in.b, in.t_w, in.t_f, in.r), {}}; }

void Channel::describe(const Input& in, SectionRecord& section) {
  section.kind = SectionKind::channel;
  section.h = in.h, section.b = in.b;
  section.t_f = in.t_f, section.t_w = in.t_w, section.r = in.r;
}

template Channel::Result Channel::own(const Input&, NoTrace&);
template Channel::Result Channel::own(const Input&, Trace&);

}  // namespace loadpath::section

template const loadpath::Calculator& loadpath::erased<loadpath::section::Channel>();
