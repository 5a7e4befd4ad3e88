#include "calculators/motion/elimination/path_equation.hpp"

#include "calculators/motion/elimination/candidates.hpp"
#include "calculators/motion/elimination/substitution.hpp"
#include "calculators/motion/elimination/terms.hpp"
#include "lib/quantity/expression/relation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace loadpath::motion {

namespace {

constexpr double nan_of_path = std::numeric_limits<double>::quiet_NaN();
constexpr double rounding_of_place = 1e-14;
/// The numbers of an equation have ten digits.
constexpr double most_deviation = 1e-8;

double extent_of(const std::vector<double>& values) {
  const auto [low, high] = std::ranges::minmax_element(values);
  return *high - *low;
}

double size_of(const std::vector<double>& values) {
  double size = 0.0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

/// Left side less right side of an equation.
struct Sides {
  Relation left, right;

  [[nodiscard]] double at(double x, double y) const {
    const std::array<double, 2> place{x, y};
    return left.at(place) - right.at(place);
  }
  /// Distance of a point from the curve to first order; a slope beyond the end of a function counts as none.
  [[nodiscard]] double distance(double x, double y, double step) const {
    const double value = std::abs(at(x, y));
    if (value == 0.0) return 0.0;
    const double along_x = (at(x + step, y) - at(x - step, y)) / (2.0 * step);
    const double along_y = (at(x, y + step) - at(x, y - step)) / (2.0 * step);
    return value / std::hypot(std::isfinite(along_x) ? along_x : 0.0, std::isfinite(along_y) ? along_y : 0.0);
  }
};

void add_both_ways(const SummedCoordinate& x, const SummedCoordinate& y, std::vector<CurveEquation>& all) {
  add_lines(x, y, all);
  if (!all.empty()) return;
  add_powers(x, y, true, all);
  add_powers(y, x, true, all);
  add_conics(x, y, all);
  add_multiple_waves(x, y, all);
  add_multiple_waves(y, x, all);
  add_powers(x, y, false, all);
  add_powers(y, x, false, all);
}

/// An inverse that holds on one branch only comes last.
void add_substitutions(const PathCoordinate& x, const PathCoordinate& y, std::vector<CurveEquation>& all) {
  std::vector<CurveEquation> both;
  add_substitution(x.name, x.law, y.name, y.law, both);
  add_substitution(y.name, y.law, x.name, x.law, both);
  const auto has_arc = [](const CurveEquation& curve) {
    return std::ranges::any_of(std::array{"asin(", "acos(", "atan("},
                               [&](const char* arc) { return curve.text.find(arc) != std::string::npos; });
  };
  if (both.size() == 2 && has_arc(both[0]) && !has_arc(both[1])) std::swap(both[0], both[1]);
  std::ranges::move(both, std::back_inserter(all));
}

}  // namespace

double deviation_of(std::string_view equation, const PathCoordinate& x, const PathCoordinate& y) {
  constexpr std::string_view sign = " = ";
  const std::size_t at = equation.find(sign);
  if (at == std::string_view::npos) return nan_of_path;
  const std::array variables{Law::Variable{x.name, {}}, Law::Variable{y.name, {}}};
  auto left = Relation::parse(equation.substr(0, at), variables, Dimension{});
  auto right = Relation::parse(equation.substr(at + sign.size()), variables, Dimension{});
  if (!left || !right) return nan_of_path;
  const Sides sides{std::move(*left), std::move(*right)};
  const double extent = std::hypot(extent_of(x.values), extent_of(y.values));
  double largest = 0.0;
  for (std::size_t i = 0; i < x.values.size(); ++i) {
    const double distance = sides.distance(x.values[i], y.values[i], 1e-6 * extent);
    if (!std::isfinite(distance)) return nan_of_path;
    largest = std::max(largest, distance);
  }
  const double relative = largest / extent;
  return relative <= rounding_of_place ? 0.0 : relative;
}

PathEquation path_equation(const PathCoordinate& x, const PathCoordinate& y, double longest) {
  const double extent = std::hypot(extent_of(x.values), extent_of(y.values));
  const double size = std::max(size_of(x.values), size_of(y.values));
  if (extent <= 1e-12 * size) return {{"", PathForm::point}, nan_of_path};
  std::vector<CurveEquation> all;
  if (const auto laws = as_sums(x.law, y.law, longest)) {
    const SummedCoordinate of_x{x.name, laws->first, size_of(x.values)};
    const SummedCoordinate of_y{y.name, laws->second, size_of(y.values)};
    add_both_ways(of_x, of_y, all);
  }
  add_substitutions(x, y, all);
  for (CurveEquation& curve : all) {
    const double deviation = deviation_of(curve.text, x, y);
    if (deviation <= most_deviation) return {std::move(curve), deviation};
  }
  return {{}, nan_of_path};
}

}  // namespace loadpath::motion
