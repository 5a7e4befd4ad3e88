// Bounds of typed inputs of gear.worm: friction by the sliding velocity, the form factor by the pressure angle, the
// thinnest usual worm. A more favourable value needs a reason.
#pragma once

#include "calculators/gear/worm/strength.hpp"
#include "lib/calculator/bound.hpp"

#include <cmath>

namespace loadpath::gear::worm_gear {

/// The coefficient of friction of the formula at the sliding velocity; NaN without a speed.
inline double friction_by_speed(const Input& in) {
  if (!is_set(in.n_1) || !is_set(in.d_1) || !is_set(in.m_x) || !(in.z_1 > 0)) return unset<double>;
  Input untyped = in;
  untyped.mu = unset<double>;
  Result r;
  r.v_s = in.n_1 * in.d_1 / (2.0 * std::cos(std::atan(in.m_x * in.z_1 / in.d_1)));
  NoTrace none;
  return friction(untyped, r, none);
}

/// Good oils and polished worms are within a fifth of the formula; from memory.
inline double least_friction(const Input& in) { return 0.8 * friction_by_speed(in); }

/// Self-locking by sliding friction; at a standstill, without n_1, the user states the friction.
inline double most_friction(const Input& in) {
  return in.locking == WormTypes::Locking::required ? 1.25 * friction_by_speed(in) : unset<double>;
}

/// Half a printed digit more, for tables have it by steps of the pressure angle.
inline double most_form_factor(const Input& in) {
  NoTrace none;
  return 1.03 * form_factor(in, none);
}

/// Standard worms have diameter quotients from 6 on; from memory.
inline double least_diameter(const Input& in) { return is_set(in.m_x) ? in_si(6.0 * in.m_x) : unset<double>; }

/// AGMA takes 43.2 a^1.7 square inches, with a in inches, for a case without ribs (Shigley, 13-11); ribs and a fan make
/// it three times that at most, bound set by loadpath.
inline double most_surface(const Input& in) {
  constexpr double inch = 0.0254, of_plain_case = 43.2, with_ribs = 3.0;
  const double a = in_si(0.5 * (in.d_1 + in.m_x * in.z_2)) / inch;
  return with_ribs * of_plain_case * std::pow(a, 1.7) * inch * inch;
}

}  // namespace loadpath::gear::worm_gear
