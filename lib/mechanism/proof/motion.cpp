#include "lib/mechanism/proof/motion.hpp"

#include "lib/numerics/magnitude.hpp"

#include <algorithm>

namespace loadpath::mechanism {
namespace {

void flatten(std::span<const Pose> poses, double length, std::span<double> flat) {
  for (std::size_t k = 0; k < poses.size(); ++k) {
    flat[3 * k] = poses[k].x / length;
    flat[3 * k + 1] = poses[k].y / length;
    flat[3 * k + 2] = poses[k].phi;
  }
}

double largest(std::span<const double> values) {
  double most = 0.0;
  for (const double x : values) most = numerics::larger_magnitude(most, x);
  return most;
}

/// The error of J x - right, which replaces `right`, relative to the largest value of both and `scale`.
double error(const Constraints& constraints, std::span<const double> x, std::span<double> right, double scale) {
  scale = numerics::larger_magnitude(numerics::larger_magnitude(scale, largest(x)), largest(right));
  const auto pattern = constraints.pattern();
  for (std::size_t n = 0; n < pattern.size(); ++n) {
    right[static_cast<std::size_t>(pattern[n].row)] -=
        constraints.jacobian()[n] * x[static_cast<std::size_t>(pattern[n].column)];
  }
  return scale == 0.0 ? 0.0 : largest(right) / scale;
}

}  // namespace

MotionProof::MotionProof(const Instant& instant)
    : velocity_(instant.constraints().columns() + 3),
      acceleration_(instant.constraints().columns() + 3),
      rate_(instant.constraints().rows()),
      rate_change_(instant.constraints().rows()) {}

double MotionProof::residual(const Instant& instant, std::span<const Drive> drives) {
  const Constraints& constraints = instant.constraints();
  const std::size_t first = constraints.first_driver_row();
  flatten(instant.at().velocity, instant.length(), velocity_);
  flatten(instant.at().acceleration, instant.length(), acceleration_);
  std::ranges::fill(rate_, 0.0);
  std::ranges::fill(rate_change_, 0.0);
  constraints.centripetal(velocity_, rate_change_);
  double most = largest(constraints.residual().first(first));
  for (std::size_t k = 0; k < drives.size(); ++k) {
    const double unit = instant.virtual_rate(k);
    most = numerics::larger_magnitude(most, constraints.coordinate(k) - drives[k].coordinate / unit);
    rate_[first + k] = drives[k].speed / unit;
    rate_change_[first + k] += drives[k].acceleration / unit;
  }
  // Centripetal accelerations may cancel, but still determine the rounding error.
  const double centripetal = largest(velocity_) * largest(velocity_);
  most = numerics::larger_magnitude(most, error(constraints, velocity_, rate_, 0.0));
  return numerics::larger_magnitude(most, error(constraints, acceleration_, rate_change_, centripetal));
}

}  // namespace loadpath::mechanism
