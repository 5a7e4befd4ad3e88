// The flanks of the wheel of gear.cycloidal: epicycloids, offset by the radius of the pins.
#pragma once

#include "lib/quantity/units.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loadpath::gear::cycloidal {

/// The flank of the wheel by the angle theta of the rolling circle since the point of contact was the pitch point. The
/// contact lies on the line from the pitch point to the point of the circle, at half the angle to the tangent.
struct CycloidFlank {
  double r_2 = 0.0, rho = 0.0, r_p = 0.0;  // pitch radius of the wheel, radii of the rolling circle and of the pins; m

  [[nodiscard]] double distance(double theta) const { return 2.0 * rho * std::sin(0.5 * theta) - r_p; }
  [[nodiscard]] double radius(double theta) const {
    const double l = distance(theta), half = 0.5 * theta;
    return std::hypot(r_2 + l * std::sin(half), l * std::cos(half));
  }
  /// The polar angle of the point of the flank from the start of the epicycloid, towards the middle of the tooth.
  [[nodiscard]] double polar(double theta) const {
    const double l = distance(theta), half = 0.5 * theta;
    return theta * rho / r_2 - std::atan2(l * std::cos(half), r_2 + l * std::sin(half));
  }
  /// Start of the flank: its radius of curvature, that of the epicycloid less that of the pin, is zero.
  [[nodiscard]] double start() const {
    return 2.0 * std::asin(std::min(1.0, r_p * (r_2 + 2.0 * rho) / (4.0 * rho * (r_2 + rho))));
  }
};

/// Of the input of gear.cycloidal: with pins where their diameter is given.
CycloidFlank flank_of(const auto& in) {
  const double r_1 = 0.5 * in_si(in.m) * in.z_1, r_2 = 0.5 * in_si(in.m) * in.z_2;
  if (!is_set(in.d_p)) return {r_2, 0.5 * r_1, 0.0};
  return {r_2, r_1, 0.5 * in_si(in.d_p)};
}

/// The polar angle of the middle of the tooth from the start of the epicycloid.
double middle_of(const auto& in) {
  const double space = is_set(in.d_p) ? 1.0 : 0.5;
  return space * std::numbers::pi / in.z_2 - in_si(in.j) / (in_si(in.m) * in.z_2);
}

/// The angle at which a rising function takes a value, between two angles.
template <class Function>
double angle_where(const Function& function, double value, double low, double high) {
  constexpr int halvings = 60;
  for (int k = 0; k < halvings; ++k) {
    const double between = 0.5 * (low + high);
    (function(between) < value ? low : high) = between;
  }
  return 0.5 * (low + high);
}

double pointed_angle(const auto& in) {
  const CycloidFlank flank = flank_of(in);
  return angle_where([&](double theta) { return flank.polar(theta); }, middle_of(in), flank.start(), std::numbers::pi);
}

/// End of the flank at a tip of this radius.
double tip_angle(const auto& in, double radius) {
  const CycloidFlank flank = flank_of(in);
  return angle_where([&](double theta) { return flank.radius(theta); }, radius, flank.start(), pointed_angle(in));
}

}  // namespace loadpath::gear::cycloidal
