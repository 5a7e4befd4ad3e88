#include "calculators/motion/point_path.hpp"

#include <cmath>
#include <limits>

namespace loadpath::motion {

namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double size(const Vector& a) { return std::sqrt(dot(a, a)); }
void drop_rounding(Vector& a) {
  const double scale = size(a);
  for (double& component : a) component = without_rounding(component, scale);
}

/// Whether a speed is only rounding, compared with the acceleration and the distances and times involved.
bool is_rest(const PointState& s, double t) {
  constexpr double rounding = 1e-12;
  return s.speed <= rounding * (std::sqrt(s.acceleration * size(s.r)) + s.acceleration * std::abs(t));
}

}  // namespace

PointState PointPath::at(double t) const {
  PointState s;
  const std::array<Written, 3> laws = all();
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const numerics::Jet jet = motion::at(laws[i], t);
    s.r[i] = jet.value, s.v[i] = jet.first, s.a[i] = jet.second;
  }
  for (Vector* const vector : {&s.r, &s.v, &s.a}) drop_rounding(*vector);
  s.speed = size(s.v);
  s.acceleration = size(s.a);
  s.a_tau = s.a_n = s.kappa = std::numeric_limits<double>::quiet_NaN();
  if (is_rest(s, t)) {
    s.v = {};
    s.speed = 0.0;
    return s;
  }
  s.a_tau = dot(s.v, s.a) / s.speed;
  s.a_n = size(cross(s.v, s.a)) / s.speed;
  s.kappa = s.a_n / (s.speed * s.speed);
  return s;
}

double PointPath::length(double t_1, double t_2) const {
  return integral([](const void* path, double t) { return size(static_cast<const PointPath*>(path)->at(t).v); }, this,
                  t_1, t_2);
}

}  // namespace loadpath::motion
