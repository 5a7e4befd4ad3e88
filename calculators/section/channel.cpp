#include "calculators/section/channel.hpp"

#include "calculators/section/corner.hpp"
#include "calculators/section/outline.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath {

namespace {

template <class Tracer>
void twist(const ChannelSection::Input& in, ChannelSection::Result& result, Tracer& trace) {
  const auto& [h, b, t_w, t_f, r] = in;
  STEP(w, max(t_w / (h - 2.0 * t_f), t_f / b), "thickness over length of the stubbier wall");
  result.w = w;
  if (!(w <= section::thickest_open_wall)) return;
  STEP(I_t, (2.0 * b * pow<3>(t_f) + (h - 2.0 * t_f) * pow<3>(t_w)) / 3.0, "thin open walls, [Oasys]");
  STEP(W_t, I_t / max(t_w, t_f), "shear in the thickest wall");
  result.I_t = I_t, result.W_t = W_t;
}

}  // namespace

template <class Tracer>
ChannelSection::Result ChannelSection::own(const Input& in, Tracer& trace) {
  const auto& [h, b, t_w, t_f, r] = in;
  Result result{section::centred()};
  const auto [A_r, e_r, I_r, I_rp] = section::corner(r, trace);
  STEP(A, 2.0 * b * t_f + (h - 2.0 * t_f) * t_w + 2.0 * A_r, "flanges, web and two fillets");
  STEP(y_S, (b * b * t_f + (h - 2.0 * t_f) * t_w * t_w / 2.0 + 2.0 * A_r * (t_w + e_r)) / A,
       "first moment about the back of the web over the area");
  STEP(I_y,
       (b * pow<3>(h) - (b - t_w) * pow<3>(h - 2.0 * t_f)) / 12.0 + 2.0 * (I_r + A_r * pow<2>(h / 2.0 - t_f - e_r)),
       "the rectangle less what is open beside the web, and the fillets by Steiner, [Garrison]");
  STEP(I_z,
       (2.0 * t_f * pow<3>(b) + (h - 2.0 * t_f) * pow<3>(t_w)) / 3.0 + 2.0 * (I_r + A_r * pow<2>(t_w + e_r)) -
           A * y_S * y_S,
       "about the back of the web, brought to the centroid by Steiner, [Garrison]");
  result.A = A, result.y_S = y_S, result.I_y = I_y, result.I_z = I_z;
  twist(in, result, trace);
  return result;
}

section::Extremes ChannelSection::extremes(const Input& in) {
  return section::corners_of(section::channel_outline(in.h, in.b, in.t_w, in.t_f));
}

std::vector<draw::Figure> ChannelSection::figures(const Input& in, const Result& r) {
  return section::figures({{section::channel_outline(in.h, in.b, in.t_w, in.t_f, in.r)}, {}}, r);
}

template ChannelSection::Result ChannelSection::own(const Input&, NoTrace&);
template ChannelSection::Result ChannelSection::own(const Input&, Trace&);

template const Calculator& erased<ChannelSection>();

}  // namespace loadpath
