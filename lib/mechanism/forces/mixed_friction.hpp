// The coefficient of friction at a sliding speed: mixed friction between that at rest and that of fast sliding.
//
// mu(v) = mu + (mu_s - mu) exp(-(|v|/v_s)^delta), the Stribeck curve [Stribeck] without its viscous part, which is a
// resistance of the joint of its own. The rise mu_s/mu - 1 is a ratio, so that a share of the coefficient is a share of
// the entire curve.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/numerics/dual.hpp"

#include <cmath>

namespace loadpath::mechanism {

/// `speed`: m/s, of either sign. The derivative at rest is set to zero.
template <class Scalar>
Scalar coefficient_at(const BasicFriction<Scalar>& friction, const Scalar& speed) {
  using std::abs;
  if (friction.rise == 0.0) return friction.coefficient;
  const double v = std::abs(numerics::value_of(speed));
  const double part = std::pow(v / friction.stribeck_speed, friction.stribeck_exponent), decay = std::exp(-part);
  const double slope = v > 0.0 && decay > 0.0 ? -decay * friction.stribeck_exponent * part / v : 0.0;
  const Scalar boundary = decay + slope * (abs(speed) - v);  // the decay, and for a dual its derivative
  return friction.coefficient * (1.0 + friction.rise * boundary);
}

}  // namespace loadpath::mechanism
