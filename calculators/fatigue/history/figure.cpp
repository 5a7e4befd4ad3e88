#include "calculators/fatigue/history/figure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace loadpath::fatigue {

namespace {

constexpr std::size_t most_points = 400;  // points of a curve in a drawing
constexpr double Pa = 1e6;                // Pa per MPa
constexpr double least_share = 0.01;      // share of the largest cycle: smaller ones would compress the rest

/// Cumulative steps down from the largest cycle: number of cycles at least so large. Many steps are joined.
figure::Curve spectrum(const std::vector<rainflow::Cycle>& cycles, const std::vector<double>& stress, double passages) {
  std::vector<std::size_t> order(cycles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return stress[a] != stress[b] ? stress[a] > stress[b] : a < b; });
  figure::Curve curve{"load spectrum", {}, {}};
  double sum = 0.0;
  const std::size_t every = 1 + order.size() / most_points;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double before = std::max(1.0, sum * passages);
    sum += cycles[order[i]].count;
    if (i % every != 0 && i + 1 != order.size()) continue;
    const double S = stress[order[i]] * Pa;
    if (S < least_share * stress[order.front()] * Pa) break;
    curve.x.insert(curve.x.end(), {before, std::max(1.0, sum * passages)});
    curve.y.insert(curve.y.end(), {S, S});
  }
  return curve;
}

figure::Curve lives(const rainflow::SnCurve& curve, double most) {
  figure::Curve line{"S-N curve", {}, {}};
  constexpr int points = 60;
  const double from = 3.0, to = std::max(8.0, std::log10(most) + 0.5);
  for (int i = 0; i <= points; ++i) {
    const double N = std::pow(10.0, from + (to - from) * i / points);
    if (const auto S = curve.stress(N)) line.x.push_back(N), line.y.push_back(*S * Pa);
  }
  return line;
}

}  // namespace

std::vector<figure::Figure> spectrum_figure(const std::vector<rainflow::Cycle>& cycles,
                                            const std::vector<double>& stress, const rainflow::SnCurve& curve,
                                            double passages, const std::string& meaning) {
  figure::Plot plot;
  plot.x = {"N", "cycles", "-", true};
  plot.y = {"S", meaning, "MPa", true};
  plot.curves.push_back(spectrum(cycles, stress, passages));
  plot.curves.push_back(lives(curve, plot.curves.front().x.back()));
  const bool is_range = meaning == "range";
  return {{"collective",
           is_range ? "Cumulative load spectrum with S-N curve" : "Cumulative load spectrum with S-N curve, r = −1",
           std::move(plot)}};
}

}  // namespace loadpath::fatigue
