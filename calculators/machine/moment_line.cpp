#include "calculators/machine/moment_line.hpp"

#include <cmath>

namespace loadpath::machine {

double moment_at(std::span<const LinePoint> line, double omega) {
  if (line.empty()) return 0.0;
  if (omega <= line.front().omega) return line.front().M;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const LinePoint &a = line[i - 1], &b = line[i];
    if (omega <= b.omega) return a.M + (b.M - a.M) * (omega - a.omega) / (b.omega - a.omega);
  }
  return line.back().M;
}

Stretch run(double inertia, double omega_1, double M_1, double omega_2, double M_2) {
  const double step = omega_2 - omega_1, x = (M_2 - M_1) / M_1;
  // log(1 + x)/x and its next moment, by series where the moment hardly changes
  constexpr double small = 1e-4;
  const double first = std::abs(x) < small ? 1.0 - x / 2.0 + x * x / 3.0 : std::log1p(x) / x;
  const double second = std::abs(x) < small ? 0.5 - x / 3.0 + x * x / 4.0 : (1.0 - std::log1p(x) / x) / x;
  const double unit = inertia * step / M_1;
  return {unit * first, unit * (omega_1 * first + step * second)};
}

}  // namespace loadpath::machine
