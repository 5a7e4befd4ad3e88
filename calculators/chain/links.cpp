#include "calculators/chain/links.hpp"

#include "calculators/gear/involute.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace loadpath::chain {

using std::numbers::pi;

double links_at(double pitches, double z_1, double z_2) {
  const double half = std::abs(z_2 - z_1) / (2.0 * pi);
  const double lean = std::asin(half / pitches);
  return 2.0 * std::sqrt(pitches * pitches - half * half) + 0.5 * (z_1 + z_2) + 2.0 * half * lean;
}

double pitches_of(double links, double z_1, double z_2) {
  const double half = std::abs(z_2 - z_1) / (2.0 * pi), straight = links - 0.5 * (z_1 + z_2);
  if (half == 0.0) return straight > 0.0 ? 0.5 * straight : std::numeric_limits<double>::quiet_NaN();
  const double complement = gear::angle_of_involute(0.5 * straight / half - 0.5 * pi);
  return half / std::cos(complement);
}

}  // namespace loadpath::chain
