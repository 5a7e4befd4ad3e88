// Lewis' factor of a tooth from its form; inline and without a branch, for sweeps.
#pragma once

#include "calculators/gear/fillet.hpp"

#include <cmath>

namespace loadpath::gear {

/// The section of a fillet that is weakest under a load which meets the middle of the tooth at y_load: there s^2/h is
/// least, which is where the fillet's direction points to as much above the load as the section lies below it.
class WeakestSection {
 public:
  /// `steepest`: tangent of the lean at which the flank begins.
  WeakestSection(const Fillet& fillet, double y_load, double steepest)
      : fillet_(fillet), y_load_(y_load), end_(steepest), high_(steepest * (1.0 + 1e-9)) {
    const double lean = within(usual_direction - fillet.turned(), 0.05, 1.1);
    t_ = within(lean / (1.0 - lean * lean / 3.0), 0.0, 0.99 * end_);  // approximate tangent of the lean
  }

  /// s^2/(6 h). Three steps find it to rounding for usual gears.
  [[nodiscard]] double section() {
    approach(), approach(), approach(), approach();
    const Fillet::Touched p = fillet_.at(t_);
    return 2.0 * p.x * p.x / (3.0 * (y_load_ - p.y));
  }

 private:
  /// As std::clamp, by value: one by reference keeps a loop out of wide registers.
  static double within(double x, double low, double high) { return x < low ? low : (x > high ? high : x); }

  static constexpr double usual_direction = 1.1;  // angle at the weakest point of the fillet, rad

  /// A step of Newton's method for the slope of s^2/h over the lean, kept between the ends of the fillet and between
  /// the points that are known to lie on either side; the end is taken where the slope has no zero.
  void approach() {
    const auto [x, y, sine, cosine, turn, size] = fillet_.at(t_);
    const double h = y_load_ - y;
    const bool below = h > 0.0;  // beyond the load there is no section
    const double slope = x * sine - 2.0 * h * cosine;
    const double rate = size * sine * cosine + turn * (x * cosine + 2.0 * h * sine);
    const bool falls = below && slope < 0.0;  // the zero lies further up the fillet
    low_ = falls ? t_ : low_;
    high_ = falls ? high_ : t_;
    const double under = rate + t_ * slope, next = (t_ * rate - slope) / under;  // tangent of the lean less slope/rate
    const bool serves = below && rate > 0.0 && under > 0.0;
    const bool settled = serves && std::abs(next - t_) <= 1e-9;
    const double middle = 0.5 * (low_ + high_);
    const double up = end_ < high_ ? end_ : middle, down = low_ < 0.0 ? 0.0 : middle;
    const double guess = serves ? next : (falls ? end_ : middle);
    const double bounded = guess >= end_ ? up : (guess <= 0.0 ? down : guess);
    const double inside = bounded >= low_ && bounded <= high_ ? bounded : middle;
    t_ = settled ? within(next, 0.0, end_) : inside;
  }

  Fillet fillet_;
  double y_load_, end_;
  double low_ = -1e-9, high_;  // just beyond the ends, which have still to be looked at
  double t_ = 0.0;             // tangent of the lean
};

/// Lewis' factor Y of a tooth with the tip radius r_a under its tip: the least s^2/(6 h) over the fillet, which is the
/// section that the inscribed parabola of equal strength touches.
[[nodiscard]] inline double lewis_factor(const Rack& rack, double z, double x, double r_a) {
  const numerics::SineCosine alpha = numerics::sine_cosine(rack.alpha);
  const double tangent = alpha.sine / alpha.cosine;
  const double base = 0.5 * z * alpha.cosine, q = base / r_a;
  const double at = numerics::arc_cosine(q), at_tip = std::sqrt(1.0 - q * q) / q - at;  // its involute function
  const double half_angle = (0.5 * std::numbers::pi + 2.0 * x * tangent) / z + (tangent - rack.alpha) - at_tip;
  const double y_load = base / numerics::cosine(at - half_angle);
  return WeakestSection(Fillet(rack, alpha, z, x), y_load, alpha.cosine / alpha.sine).section();
}

}  // namespace loadpath::gear
