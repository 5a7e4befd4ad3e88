// The chart of critical stresses over the slenderness with the bar's own point, and its buckled shapes.
#include "calculators/column/buckling.hpp"
#include "calculators/column/buckling_parts.hpp"

#include <algorithm>

namespace loadpath::column {

namespace {

/// The curve of a method through the data of the governing axis.
Stress stress_at(double lambda, const Material& material, const AxisResult& axis, Method method) {
  NoTrace trace;
  if (method == Method::secant) return secant_stress(lambda, axis.eta, material.E, material.R_e, axis.eta_0);
  if (method == Method::ec3) return ec3_reduction(lambda, axis.alpha, material, trace) * material.R_e;
  return stress_of_slenderness(method, lambda, material, trace);
}

Method method_named(std::string_view name) {
  for (const auto& word : choices_of(Method{})) {
    if (name == word.key) return word.value;
  }
  return Method::euler;
}

figure::Plot chart(const Buckling::Input& in, const Buckling::Result& r) {
  const Material material = material_of(in);
  const AxisResult& axis = r.axes[r.axis == AxisName::y ? 0 : 1];
  const double end = std::max({200.0, 1.2 * r.lambda, 1.2 * material.lambda_1});
  figure::Plot plot;
  plot.x = {"lambda", "slenderness", "-"};
  plot.y = {"sigma_cr", "critical stress", "MPa"};
  for (const auto& by : r.methods) {
    figure::Curve curve{std::string(by.name.view()), {}, {}, false};
    constexpr int points = 160;
    for (int i = 1; i <= points; ++i) {
      const double lambda = end * i / points;
      curve.x.push_back(lambda);
      curve.y.push_back(in_si(stress_at(lambda, material, axis, method_named(by.name.view()))));
    }
    plot.curves.push_back(std::move(curve));
  }
  if (is_set(r.sigma_cr)) plot.marks.push_back({r.lambda, in_si(r.sigma_cr), "critical"});
  if (is_set(r.F)) plot.marks.push_back({r.lambda, in_si(r.F / r.A), "loaded"});
  if (is_set(in.R_e)) plot.bounds.push_back({in_si(in.R_e), "R_e"});
  return plot;
}

void add_shape(const Buckling::Input& in, AxisName axis, figure::Plot& plot) {
  const bool about_y = axis == AxisName::y;
  if (is_set(about_y ? in.beta_y : in.beta_z)) return;  // the factor does not give the end conditions
  const Bar bar = bar_of(in, axis);
  Shape shape = buckled_shape(bar, buckling_parameter(bar));
  for (double& x : shape.x) x *= in_si(in.l);
  plot.curves.push_back({about_y ? "about y" : "about z", std::move(shape.x), std::move(shape.w), false});
}

}  // namespace

std::vector<figure::Figure> Buckling::figures(const Input& in, const Result& r) {
  std::vector<figure::Figure> figures{
      {"critical-stress", "Critical stress against slenderness (no safety factor)", chart(in, r)}};
  figure::Plot shapes;
  shapes.x = {"x", "position along the bar", "mm"};
  shapes.y = {"w", "deflection / maximum deflection", "-"};
  for (const auto axis : {AxisName::y, AxisName::z}) add_shape(in, axis, shapes);
  if (auto bar = bar_figure(in, r)) figures.insert(figures.begin(), std::move(*bar));
  if (!shapes.curves.empty()) figures.push_back({"buckled-shape", "Buckling mode shape", std::move(shapes)});
  return figures;
}

}  // namespace loadpath::column
