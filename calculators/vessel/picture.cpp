#include "calculators/vessel/picture.hpp"

#include <cmath>

namespace loadpath::vessel {

namespace {

figure::Figure stresses_along(const std::vector<Sample>& along) {
  figure::Plot plot;
  plot.x = {"s", "distance along the meridian", "mm"};
  plot.y = {"sigma", "membrane stress", "MPa"};
  figure::Curve hoop{"sigma_o", {}, {}}, meridional{"sigma_M", {}, {}};
  double s = 0.0;
  for (std::size_t i = 0; i < along.size(); ++i) {
    if (i > 0) s += std::hypot(along[i].r - along[i - 1].r, along[i].z - along[i - 1].z);
    hoop.x.push_back(s), hoop.y.push_back(along[i].sigma_o);
    meridional.x.push_back(s), meridional.y.push_back(along[i].sigma_M);
  }
  plot.curves = {std::move(hoop), std::move(meridional)};
  return {"stresses", "Hoop and meridional stress along the meridian", std::move(plot)};
}

}  // namespace

std::vector<figure::Figure> pictures(const std::vector<Sample>& along, const WallInput& in, const WallResult& r,
                                     const Section& section) {
  if (!is_set(r.sigma_v) || !std::isfinite(in_si(r.delta)) || along.size() < 2) return {};
  return {section_figure(in, r, section), stresses_along(along)};
}

}  // namespace loadpath::vessel
