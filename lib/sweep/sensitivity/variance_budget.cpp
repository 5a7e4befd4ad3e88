#include "lib/sweep/sensitivity/variance_budget.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::sweep {

namespace {

/// Deviations of the output that one deviation of each input makes, and how they go together.
struct Deviations {
  std::vector<double> parts;
  std::span<const double> correlation;

  [[nodiscard]] double together(std::size_t i, std::size_t k) const {
    if (correlation.empty()) return i == k ? 1.0 : 0.0;
    return correlation[i * parts.size() + k];
  }
  /// The contribution of input i to the variance, including its part of the covariances.
  [[nodiscard]] double contribution(std::size_t i) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < parts.size(); ++k) sum += together(i, k) * parts[k];
    return parts[i] * sum;
  }
  [[nodiscard]] double variance() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) sum += contribution(i);
    return sum;
  }
};

bool before(const BudgetLine& a, const BudgetLine& b) { return a.variance < b.variance; }

}  // namespace

Budget variance_budget(const Slopes& slopes, std::size_t output, std::span<const double> sd,
                       std::span<const double> correlation) {
  Budget budget;
  Deviations deviations{std::vector<double>(slopes.inputs), correlation};
  for (std::size_t i = 0; i < slopes.inputs; ++i) {
    const Slope& slope = slopes.at(output, i);
    deviations.parts[i] = sd[i] == 0.0 ? 0.0 : slope.value * sd[i];
    budget.certain = budget.certain && (sd[i] == 0.0 || slope.kind == Slope::Kind::smooth);
  }
  budget.variance = deviations.variance();
  for (std::size_t i = 0; i < slopes.inputs; ++i) {
    Deviations tightened = deviations;
    tightened.parts[i] *= 0.5;
    budget.lines.push_back({i, deviations.contribution(i) / budget.variance, tightened.variance()});
  }
  std::stable_sort(budget.lines.begin(), budget.lines.end(), before);
  return budget;
}

}  // namespace loadpath::sweep
