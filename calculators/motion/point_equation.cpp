#include "calculators/motion/point_equation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace loadpath::motion {

namespace {

constexpr int places = 257;

double place(double t_1, double t_2, int i) { return i + 1 == places ? t_2 : t_1 + (t_2 - t_1) * i / (places - 1); }

/// The time between two places at which a coordinate turns back.
double turning_time(const Written& law, double from, double to) {
  constexpr int halvings = 60;
  const bool rises = at(law, from).first > 0.0;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (from + to);
    ((at(law, middle).first > 0.0) == rises ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

PathCoordinate coordinate_of(const Written& law, double t_1, double t_2) {
  PathCoordinate coordinate{law.key, law.text->empty() ? "0" : law.text->view(), {}};
  for (int i = 0; i < places; ++i) coordinate.values.push_back(at(law, place(t_1, t_2, i)).value);
  return coordinate;
}

}  // namespace

PathLimits limits_of(const PointPath& path, double t_1, double t_2) {
  PathLimits limits;
  const std::array<Written, 3> laws = path.all();
  for (std::size_t k = 0; k < laws.size(); ++k) {
    numerics::Jet before = at(laws[k], t_1);
    double low = before.value, high = before.value, last = t_1;
    const auto widen = [&](double value) { low = std::min(low, value), high = std::max(high, value); };
    for (int i = 1; i < places; ++i) {
      const double t = place(t_1, t_2, i);
      const numerics::Jet here = at(laws[k], t);
      widen(here.value);
      if (before.first * here.first < 0.0) widen(at(laws[k], turning_time(laws[k], last, t)).value);
      before = here, last = t;
    }
    const double size = std::max(std::abs(low), std::abs(high));
    limits.low[k] = without_rounding(low, size), limits.high[k] = without_rounding(high, size);
  }
  return limits;
}

PathEquations equations_of(const PointPath& path, double t_1, double t_2) {
  const double longest = std::max(std::abs(t_1), std::abs(t_2));
  const PathCoordinate x = coordinate_of(path.x, t_1, t_2), y = coordinate_of(path.y, t_1, t_2);
  PathEquations equations;
  equations.plane = path_equation(x, y, longest);
  if (path.z.text->empty()) return equations;
  const PathCoordinate z = coordinate_of(path.z, t_1, t_2);
  const auto [low, high] = std::ranges::minmax_element(x.values);
  equations.space = path_equation(*low < *high ? x : y, z, longest);
  return equations;
}

}  // namespace loadpath::motion
