// The fillet that the rounded corner of a rack leaves at the root of a tooth. Lengths and coordinates as in
// tooth_form.hpp.
#pragma once

#include "calculators/gear/rack.hpp"
#include "calculators/gear/trigonometry.hpp"

#include <numbers>

namespace loadpath::gear {

/// A point of the fillet where the normal of the contact leans from the middle of the space by an angle whose tangent
/// is known.
class Fillet {
 public:
  struct Touched {
    double x, y;
    double sine, cosine;  // direction of the fillet, from across the tooth
    double turn, size;    // rates with the lean: of that direction, and along the fillet
  };

  Fillet(const Rack& rack, numerics::SineCosine alpha, double z, double x)
      : z_(z), rho_(rack.rho), depth_(rack.h_f - rack.rho - x), corner_(corner_of(rack, alpha)) {}

  [[nodiscard]] Touched at(double lean_tangent) const {
    const double t = lean_tangent, w = 1.0 + t * t, root = std::sqrt(w), c = 1.0 / root, s = t * c;
    const double px = depth_ * t + rho_ * s,
                 py = 0.5 * z_ - depth_ - rho_ * c;  // the normal runs through the pitch point
    const auto [st, ct] = numerics::sine_cosine(turned() + 2.0 * depth_ * t / z_);
    const double turn = 2.0 * depth_ / z_ * w;
    // its tangent is normal to the normal
    return {st * py - ct * px, st * px + ct * py, st * c + ct * s,
            ct * c - st * s,   1.0 + turn,        turn * (depth_ * root + rho_) + rho_};
  }
  /// Angle of the gear at the lowest point, from the tooth space to the tooth.
  [[nodiscard]] double turned() const { return (std::numbers::pi - 2.0 * corner_) / z_; }

 private:
  /// Distance of the corner's centre from the middle of the space.
  static double corner_of(const Rack& rack, numerics::SineCosine alpha) {
    return std::numbers::pi / 4.0 - (rack.h_f * alpha.sine + (1.0 - alpha.sine) * rack.rho) / alpha.cosine;
  }

  double z_, rho_;
  double depth_;  // depth of the corner's centre below the pitch line
  double corner_;
};

}  // namespace loadpath::gear
