// Bounds of typed inputs of gear.bevel: stress numbers by the hardness, the geometry factors by the teeth, the speed of
// straight teeth. A more favourable value needs a reason.
#pragma once

#include "calculators/gear/bevel/rating.hpp"
#include "lib/calculator/bound.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::gear::bevel {

/// A tenth above the stress number of grade 1 by the hardness; NaN without a hardness.
inline double most_contact_number(double hardness) {
  NoTrace none;
  return is_set(hardness) ? 1.1 * in_si(contact_number("s_c", unset<Stress>, hardness, none)) : unset<double>;
}
inline double most_bending_number(double hardness) {
  NoTrace none;
  return is_set(hardness) ? 1.1 * in_si(bending_number("s_b", unset<Stress>, hardness, none)) : unset<double>;
}

/// The charts of AGMA 2003 end at 50 teeth of the pinion, or rise little beyond; from memory.
inline double counted_teeth(const BevelTypes::Input& in) { return std::min(50.0, in.z_1 + 0.0); }

/// 15 % above the chart: the factor of spur gears in contact at the pitch point, of which bevel gears have 0.8 with 20
/// teeth and 1.1 with 50; fitted to chart values of textbooks (25/25, 20/40, 20/60), from memory beyond.
inline double most_I(const BevelTypes::Input& in) {
  const double at_pitch_point = std::sin(in.alpha) * std::cos(in.alpha) / 2.0 * in.z_2 / (in.z_1 + in.z_2);
  return 1.15 * (0.6 + 0.01 * counted_teeth(in)) * at_pitch_point;
}
/// 15 % and 25 % above the chart, by the teeth of the pinion; from the same values.
inline double most_J_1(const BevelTypes::Input& in) { return 1.15 * (0.19 + 0.0025 * counted_teeth(in)); }
inline double most_J_2(const BevelTypes::Input& in) { return 1.25 * (0.15 + 0.0026 * counted_teeth(in)); }

/// Straight teeth: 5 m/s, of accurate ones 10 m/s, from memory; spiral teeth are customary beyond.
inline double most_speed(const BevelTypes::Input& in) {
  const bool is_rated = is_set(in.I) || is_set(in.J_1) || is_set(in.J_2);
  if (!is_rated || !is_set(in.m_et) || !(in.z_1 > 0)) return unset<double>;
  const Speed most = in.Q_v >= 8 ? 10.0 * m_per_s : 5.0 * m_per_s;
  return in_si(most) / (0.5 * in_si(in.m_et) * in.z_1);
}

}  // namespace loadpath::gear::bevel
