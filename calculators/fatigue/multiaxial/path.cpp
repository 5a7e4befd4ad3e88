#include "calculators/fatigue/multiaxial/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::fatigue {

namespace {

double mises(const PlaneStress& s) { return std::sqrt(s.x * s.x + s.y * s.y - s.x * s.y + 3.0 * s.xy * s.xy); }

/// J_2 = (sigma_x^2 + sigma_y^2 - sigma_x sigma_y)/3 + tau^2 is the square of the length of this.
std::array<double, 3> deviator(const PlaneStress& s) {
  return {(s.x + s.y) / std::sqrt(12.0), (s.x - s.y) / 2.0, s.xy};
}

/// Half the difference of the largest and the least value that `of` takes along the path.
template <class Of>
double amplitude(const StressPath& path, const Of& of) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double value = of(path.at(i));
    least = std::min(least, value), most = std::max(most, value);
  }
  return (most - least) / 2.0;
}

/// The largest shear stress of a deviator. In the plane its principal values are m + rho and m - rho, across it -2 m.
double tresca_shear(double u_1, double rho) {
  const double m = u_1 / std::sqrt(3.0);
  return std::max(rho, (3.0 * std::abs(m) + rho) / 2.0);
}

}  // namespace

StressPath::StressPath(const Varying<Stress>& x, const Varying<Stress>& y, const Varying<Stress>& xy)
    : x_(of(x)), y_(of(y)), xy_(of(xy)), size_(std::max({x.positions(), y.positions(), xy.positions()})) {}

StressPath::Component StressPath::of(const Varying<Stress>& q) {
  return q.is_series() ? Component{q.series->si.data(), 0.0} : Component{nullptr, in_si(q.one)};
}

double largest_mises(const StressPath& path) {
  double most = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) most = std::max(most, mises(path.at(i)));
  return most;
}

double mises_in_phase(const StressPath& path) {
  const double x = amplitude(path, [](const PlaneStress& s) { return s.x; });
  const double y = amplitude(path, [](const PlaneStress& s) { return s.y; });
  const double across = amplitude(path, [](const PlaneStress& s) { return s.x - s.y; });
  const double xy = amplitude(path, [](const PlaneStress& s) { return s.xy; });
  return std::sqrt((x * x + y * y + across * across) / 2.0 + 3.0 * xy * xy);
}

double largest_hydrostatic(const StressPath& path) {
  double most = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) most = std::max(most, (path.at(i).x + path.at(i).y) / 3.0);
  return most;
}

DeviatorBall deviator_ball(const StressPath& path) {
  return numerics::smallest_ball<3>(path.size(), [&](std::size_t i) { return deviator(path.at(i)); });
}

double largest_mesoscopic(const StressPath& path, const DeviatorBall& ball, double a) {
  double most = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const PlaneStress s = path.at(i);
    const auto u = deviator(s);
    const double tau = tresca_shear(u[0] - ball.centre[0], std::hypot(u[1] - ball.centre[1], u[2] - ball.centre[2]));
    most = std::max(most, tau + a * std::max((s.x + s.y) / 3.0, 0.0));
  }
  return most;
}

}  // namespace loadpath::fatigue
