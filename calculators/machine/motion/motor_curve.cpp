#include "calculators/machine/motion/motor_curve.hpp"

#include <algorithm>
#include <limits>

namespace loadpath::machine {

double MotorCurve::at(double omega) const {
  if (kind == Kind::points) return moment_at({line.data(), line.size()}, omega);
  const double s = slip(omega);
  return kind == Kind::straight ? M_A * s : 2.0 * M_K * s * s_K / (s * s + s_K * s_K);
}

double MotorCurve::breakdown_speed() const {
  if (kind == Kind::straight) return 0.0;
  if (kind == Kind::kloss) return std::max(omega_0 * (1.0 - s_K), 0.0);
  // Of equal torques the first: a level stretch at the beginning is not a falling branch.
  return std::max_element(line.begin(), line.end(), [](const auto& a, const auto& b) { return a.M < b.M; })->omega;
}

double MotorCurve::last_speed() const {
  return kind == Kind::points ? line.back().omega : std::numeric_limits<double>::infinity();
}

double MotorCurve::far_speed() const {
  constexpr double beyond_line = 1.05, beyond_no_load = 3.0;
  return kind == Kind::points ? beyond_line * line.back().omega : beyond_no_load * omega_0;
}

}  // namespace loadpath::machine
