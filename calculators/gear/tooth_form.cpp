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

/// A point of the fillet, and its rate with the lean, which is along the fillet.
struct Touched {
  FormPoint point, rate;
};

class Fillet {
 public:
  Fillet(const Rack& rack, double z, double x)
      : z_(z), rho_(rack.rho), depth_(rack.h_f - rack.rho - x), corner_(corner_of(rack)) {}

  [[nodiscard]] Touched at(double lean) const {
    const double s = std::sin(lean), c = std::cos(lean), tangent = s / c;
    const double across = depth_ * tangent;  // the normal runs through the pitch point
    const double px = across + rho_ * s, py = 0.5 * z_ - depth_ - rho_ * c;
    const double turn = 2.0 * (across - corner_) / z_ + pi / z_;  // of the gear, and from the space to the tooth
    const double st = std::sin(turn), ct = std::cos(turn);
    const double size =
        2.0 * depth_ / (z_ * c * c) * (depth_ / c + rho_) + rho_;  // the tangent is normal to the normal
    return {{-(ct * px - st * py), st * px + ct * py}, {-size * (ct * c - st * s), size * (st * c + ct * s)}};
  }

 private:
  /// Of the corner's centre from the middle of the space.
  static double corner_of(const Rack& rack) {
    const double s = std::sin(rack.alpha), c = std::cos(rack.alpha);
    return pi / 4.0 - rack.h_f * std::tan(rack.alpha) - (1.0 - s) * rack.rho / c;
  }

  double z_, rho_;
  double depth_;  // of the corner's centre below the pitch line
  double corner_;
};

/// The zero of a rising function between low and high; the nearer end where there is none. Regula falsi by the Illinois
/// rule, to a part of the distance.
template <class Function>
double rising_zero(const Function& f, double low, double high, double part) {
  double at_low = f(low), at_high = f(high), x = low;
  if (!(at_low < 0.0)) return low;
  if (!(at_high > 0.0)) return high;
  for (int side = 0, i = 0; i < 60 && high - low > part; ++i) {
    const double last = x;
    x = high - at_high * (high - low) / (at_high - at_low);
    const double value = f(x);
    if (value > 0.0) {
      high = x, at_high = value;
      if (side > 0) at_low *= 0.5;
      side = 1;
    } else {
      low = x, at_low = value;
      if (side < 0) at_high *= 0.5;
      side = -1;
    }
    if (value == 0.0 || std::abs(x - last) <= part) break;
  }
  return x;
}

/// s^2/(6 h) of the section through a point of the fillet under a load that meets the middle of the tooth at y_load.
double section(const FormPoint& p, double y_load) { return 2.0 * p.x * p.x / (3.0 * (y_load - p.y)); }

}  // namespace

FormPoint fillet_point(const Rack& rack, double z, double x, double lean) { return Fillet(rack, z, x).at(lean).point; }

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
  const Fillet fillet(rack, z, x);
  const auto slope = [&](double lean) {  // of s^2/h, with the sign and a size like it
    const auto [p, rate] = fillet.at(lean);
    const double h = y_load - p.y, rise = p.x * rate.y;
    return h > 0.0 ? 2.0 * rate.x * h + rise : std::abs(rise);  // beyond the load there is no section
  };
  // the value is flat there: 1e-8 in the lean is 1e-16 in the factor
  return section(fillet.at(rising_zero(slope, 0.0, 0.5 * pi - rack.alpha, 1e-8)).point, y_load);
}

}  // namespace loadpath::gear
