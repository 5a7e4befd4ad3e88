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

namespace {

/// Integrals of u^k/(1 + x u) over u from 0 to 1, k = 0, 1, 2.
struct Moments {
  double m0 = 0.0, m1 = 0.0, m2 = 0.0;
};

Moments moments(double x) {
  if (std::abs(x) > 0.1) {
    const double m0 = std::log1p(x) / x, m1 = (1.0 - m0) / x;
    return {m0, m1, (0.5 - m1) / x};
  }
  Moments sum;  // where the moment hardly changes the closed forms lose their digits
  double power = 1.0;
  for (int j = 0; j < 16; ++j, power *= -x)
    sum.m0 += power / (j + 1.0), sum.m1 += power / (j + 2.0), sum.m2 += power / (j + 3.0);
  return sum;
}

}  // namespace

Stretch run(double inertia, double omega_1, double M_1, double omega_2, double M_2, double load_1, double load_2) {
  const double step = omega_2 - omega_1, more = load_2 - load_1, unit = inertia * step / M_1;
  const auto [m0, m1, m2] = moments((M_2 - M_1) / M_1);
  return {unit * m0, unit * (omega_1 * m0 + step * m1),
          unit * (omega_1 * load_1 * m0 + (omega_1 * more + step * load_1) * m1 + step * more * m2)};
}

}  // namespace loadpath::machine
