// The bar as it buckles, and the moments along it about both axes.
#include "calculators/column/bending/beam_column.hpp"
#include "calculators/column/bending/parts.hpp"
#include "calculators/column/buckling_parts.hpp"

namespace loadpath::column {

namespace {

figure::Curve course(const char* name, const Moments& moments) {
  constexpr int steps = 60;
  figure::Curve curve{name, {}, {}, false};
  for (int i = 0; i <= steps; ++i) {
    const double x = static_cast<double>(i) / steps;
    curve.x.push_back(x * in_si(moments.l));
    curve.y.push_back(in_si(moments.at(x)));
  }
  return curve;
}

}  // namespace

std::vector<figure::Figure> BeamColumn::figures(const Input& in, const Result& r) {
  figure::Plot plot;
  plot.x = {"x", "position along the bar", "mm"};
  plot.y = {"M", "bending moment", "N*m"};
  if (r.M_yEd > 0.0 * N_m.one) plot.curves.push_back(course("about y", moments_about_y(in)));
  if (r.M_zEd > 0.0 * N_m.one) plot.curves.push_back(course("about z", moments_about_z(in)));
  std::vector<figure::Figure> figures;
  if (auto bar = bar_figure(in, r, {r.M_yEd, r.M_zEd})) figures.push_back(std::move(*bar));
  if (!plot.curves.empty())
    figures.push_back({"moments", "Bending moments along the bar (without partial factors)", std::move(plot)});
  return figures;
}

}  // namespace loadpath::column
