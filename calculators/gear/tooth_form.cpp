#include "calculators/gear/tooth_form.hpp"

#include "calculators/gear/involute.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loadpath::gear {

using std::numbers::pi;

namespace {

/// Depth of the straight flank of the rack below its reference line.
double straight_depth(const Rack& rack) { return rack.h_f - rack.rho * (1.0 - std::sin(rack.alpha)); }

/// s^2/(6 h) of the section through a point of the fillet under a load that meets the middle of the tooth at y_load.
double section(const FormPoint& p, double y_load) { return 2.0 * p.x * p.x / (3.0 * (y_load - p.y)); }

}  // namespace

FormPoint fillet_point(const Rack& rack, double z, double x, double lean) {
  const double corner = pi / 4.0 - rack.h_f * std::tan(rack.alpha) -
                        (1.0 - std::sin(rack.alpha)) * rack.rho / std::cos(rack.alpha);  // from the middle of the space
  const double depth = rack.h_f - rack.rho - x;  // of the corner's centre below the pitch line
  const double across = depth * std::tan(lean);  // the normal runs through the pitch point
  const double px = across + rack.rho * std::sin(lean);
  const double py = 0.5 * z - depth - rack.rho * std::cos(lean);
  const double turn = 2.0 * (across - corner) / z + pi / z;  // of the gear, and from the space to the tooth
  return {-(std::cos(turn) * px - std::sin(turn) * py), std::sin(turn) * px + std::cos(turn) * py};
}

double half_angle(double alpha, double z, double x, double r) {
  const double at = std::acos(std::clamp(0.5 * z * std::cos(alpha) / r, -1.0, 1.0));
  return (0.5 * pi + 2.0 * x * std::tan(alpha)) / z + involute(alpha) - involute(at);
}

double form_radius(const Rack& rack, double z, double x) {
  const double base = 0.5 * z * std::cos(rack.alpha);
  const double along = 0.5 * z * std::sin(rack.alpha) - (straight_depth(rack) - x) / std::sin(rack.alpha);
  return std::hypot(base, std::max(0.0, along));
}

double lewis_factor(const Rack& rack, double z, double x, double r_a) {
  const double base = 0.5 * z * std::cos(rack.alpha);
  const double y_load = base / std::cos(std::acos(base / r_a) - half_angle(rack.alpha, z, x, r_a));
  const auto at = [&](double lean) { return section(fillet_point(rack, z, x, lean), y_load); };
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = 0.0, high = 0.5 * pi - rack.alpha;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = at(a), at_b = at(b);
  while (high - low > 1e-8) {  // the value is flat there: 1e-8 in the lean is 1e-16 in the factor
    if (at_a < at_b) {
      high = b, b = a, at_b = at_a;
      at_a = at(a = high - golden * (high - low));
    } else {
      low = a, a = b, at_a = at_b;
      at_b = at(b = low + golden * (high - low));
    }
  }
  return at(0.5 * (low + high));
}

}  // namespace loadpath::gear
