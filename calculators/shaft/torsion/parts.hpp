// The shaft of shaft.torsion as it is given: its length, its torques and the stretches between them.
#pragma once

#include "calculators/shaft/parts/power.hpp"
#include "calculators/shaft/torsion/types.hpp"

namespace loadpath::shaft {

inline Length total_length(const TorsionTypes::Input& in) {
  Length sum = 0.0 * m.one;
  for (const auto& s : in.segments) sum += s.l;
  for (const auto& t : in.torques) {
    if (in.segments.empty()) sum = max(sum, t.x);
  }
  return is_set(in.l) ? in.l : sum;
}

inline Cylinder cylinder_of(const TorsionTypes::Input& in, const TorsionTypes::Segment& s) {
  const bool own_bore = is_set(s.chi) || is_set(s.d_bore);
  return {s.l, is_set(s.d) ? s.d : in.d, own_bore ? s.chi : in.chi, own_bore ? s.d_bore : in.d_bore, s.rho};
}

inline Cylinders cylinders_of(const TorsionTypes::Input& in) {
  Cylinders cylinders;
  for (const auto& s : in.segments) cylinders.push_back(cylinder_of(in, s));
  if (cylinders.empty()) cylinders.push_back({total_length(in), in.d, in.chi, in.d_bore});
  return cylinders;
}

/// The sum of the torques, which an end that is held takes.
inline Moment given_sum(const TorsionTypes::Input& in) {
  Moment sum = 0.0 * N_m.one;
  for (const auto& t : in.torques) sum += t.T;
  return sum;
}

/// Whether a torque lies beyond the end of the shaft.
inline bool is_beyond(const TorsionTypes::Input& in, const TorsionTypes::Torque& t) {
  return !(t.x <= total_length(in) * (1.0 + 1e-12));
}

/// The torques with the reaction of the end that is held.
inline Torques torques_of(const TorsionTypes::Input& in) {
  Torques torques;
  for (const auto& t : in.torques) torques.push_back({t.x, t.T});
  const Moment reaction = -given_sum(in);
  if (in.fixed == TorsionTypes::Fixed::left) torques.push_back({0.0 * m.one, reaction});
  if (in.fixed == TorsionTypes::Fixed::right) torques.push_back({total_length(in), reaction});
  return torques;
}

/// The short form: one torque through the full shaft length.
inline Stretches stretches_of_short_form(const TorsionTypes::Input& in) {
  NoTrace quiet;
  const Moment T = torque_of(in, quiet);
  Stretches parts;
  Length x = 0.0 * m.one;
  if (in.segments.empty()) parts.push_back({x, T, {in.l, in.d, in.chi, in.d_bore}});
  for (const auto& s : in.segments) {
    parts.push_back({x, T, cylinder_of(in, s)});
    x += s.l;
  }
  return parts;
}

/// The stretches of constant moment and diameter, from left to right.
inline Stretches stretches_of(const TorsionTypes::Input& in) {
  return in.torques.empty() ? stretches_of_short_form(in) : stretches(torques_of(in), cylinders_of(in));
}

}  // namespace loadpath::shaft
