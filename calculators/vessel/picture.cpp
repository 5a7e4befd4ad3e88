#include "calculators/vessel/picture.hpp"

#include <cmath>

namespace loadpath::vessel {

namespace {

draw::Figure stresses_along(const std::vector<Sample>& along) {
  draw::Plot plot;
  plot.x = {"s", "way along the meridian", "mm"};
  plot.y = {"sigma", "membrane stress", "MPa"};
  draw::Curve hoop{"sigma_o", {}, {}}, meridional{"sigma_M", {}, {}};
  double s = 0.0;
  for (std::size_t i = 0; i < along.size(); ++i) {
    if (i > 0) s += std::hypot(along[i].r - along[i - 1].r, along[i].z - along[i - 1].z);
    hoop.x.push_back(s), hoop.y.push_back(along[i].sigma_o);
    meridional.x.push_back(s), meridional.y.push_back(along[i].sigma_M);
  }
  plot.curves = {std::move(hoop), std::move(meridional)};
  return {"stresses", "Hoop and meridional stress along the meridian", std::move(plot)};
}

draw::Figure section(const std::vector<Sample>& along) {
  draw::Scheme scheme;
  for (const double side : {1.0, -1.0}) {
    draw::Scheme::Path meridian{"", {}};
    for (const Sample& s : along) meridian.points.push_back({side * s.r, s.z});
    scheme.paths.push_back(std::move(meridian));
  }
  return {"section", "Section of the shell through its axis", std::move(scheme)};
}

}  // namespace

std::vector<draw::Figure> pictures(const std::vector<Sample>& along, const WallResult& r) {
  if (!is_set(r.sigma_v)) return {};
  return {section(along), stresses_along(along)};
}

}  // namespace loadpath::vessel
