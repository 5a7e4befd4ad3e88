#include "calculators/gear/tooth_form.hpp"

#include "calculators/gear/fillet.hpp"
#include "calculators/gear/involute.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loadpath::gear {

using std::numbers::pi;

namespace {

/// Depth of the straight flank of the rack below its reference line.
double straight_depth(const Rack& rack) { return rack.h_f - rack.rho * (1.0 - std::sin(rack.alpha)); }

}  // namespace

FormPoint fillet_point(const Rack& rack, double z, double x, double lean) {
  const Fillet::Touched at = Fillet(rack, numerics::sine_cosine(rack.alpha), z, x).at(std::tan(lean));
  return {at.x, at.y};
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

}  // namespace loadpath::gear
