#include "lib/mechanism/proof/motion.hpp"

#include "lib/numerics/magnitude.hpp"

#include <vector>

namespace loadpath::mechanism {
namespace {

/// With three zeros for the ground.
std::vector<double> in_units(std::span<const Pose> poses, double length) {
  std::vector<double> flat;
  flat.reserve(3 * poses.size() + 3);
  for (const Pose& p : poses) flat.insert(flat.end(), {p.x / length, p.y / length, p.phi});
  flat.resize(flat.size() + 3);
  return flat;
}

double largest(std::span<const double> values) {
  double most = 0.0;
  for (const double x : values) most = larger_magnitude(most, x);
  return most;
}

/// J x - right, over the largest value of both and `scale`.
double error(const Constraints& constraints, std::span<const double> x, std::vector<double> right, double scale) {
  scale = larger_magnitude(larger_magnitude(scale, largest(x)), largest(right));
  const auto pattern = constraints.pattern();
  for (std::size_t n = 0; n < pattern.size(); ++n) {
    right[static_cast<std::size_t>(pattern[n].row)] -=
        constraints.jacobian()[n] * x[static_cast<std::size_t>(pattern[n].column)];
  }
  return scale == 0.0 ? 0.0 : largest(right) / scale;
}

}  // namespace

double motion_residual(const Instant& instant, std::span<const Drive> drives) {
  const Constraints& constraints = instant.constraints();
  const std::size_t first = constraints.first_driver_row();
  const auto velocity = in_units(instant.at().velocity, instant.length());
  const auto acceleration = in_units(instant.at().acceleration, instant.length());
  std::vector<double> rate(constraints.rows()), rate_change(constraints.rows());
  constraints.centripetal(velocity, rate_change);
  double most = largest(constraints.residual().first(first));
  for (std::size_t k = 0; k < drives.size(); ++k) {
    const double unit = instant.virtual_rate(k);
    most = larger_magnitude(most, constraints.coordinate(k) - drives[k].coordinate / unit);
    rate[first + k] = drives[k].speed / unit;
    rate_change[first + k] += drives[k].acceleration / unit;
  }
  // Where centripetal accelerations cancel, they are still what rounding is a part of.
  const double centripetal = largest(velocity) * largest(velocity);
  most = larger_magnitude(most, error(constraints, velocity, rate, 0.0));
  return larger_magnitude(most, error(constraints, acceleration, rate_change, centripetal));
}

}  // namespace loadpath::mechanism
