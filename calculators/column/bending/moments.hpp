// Bending moments of a bar between its ends: two end moments, a load evenly distributed over the length, and a force at
// mid-length. Moments and loads are positive where they bend the bar to the same side.
#pragma once

#include "lib/quantity/units.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::column {

struct Moments {
  Moment M_1 = 0.0 * N_m.one, M_2 = 0.0 * N_m.one;  // at the start and at the end
  Stiffness q = 0.0 * N_per_mm.one;
  Force F = 0.0 * kN.one;
  Length l = 0.0 * mm.one;

  [[nodiscard]] Moment across() const { return q * l * l / 8.0 + F * l / 4.0; }
  [[nodiscard]] bool has_load() const { return in_si(abs(q)) > 0.0 || in_si(abs(F)) > 0.0; }

  /// At the place x l.
  [[nodiscard]] Moment at(double x) const {
    return M_1 * (1.0 - x) + M_2 * x + q * l * l / 2.0 * (x * (1.0 - x)) + F * l / 2.0 * std::min(x, 1.0 - x);
  }

  [[nodiscard]] Moment at_middle() const { return at(0.5); }

  /// The largest magnitude: at an end, at mid-length, or where the parabola of a half of the bar has its top.
  [[nodiscard]] Moment largest() const {
    Moment most = max(max(abs(M_1), abs(M_2)), abs(at_middle()));
    const double parabola = in_si(q * l * l), slope = in_si(M_2 - M_1), kink = in_si(F * l) / 2.0;
    if (parabola == 0.0) return most;
    const double left = 0.5 + (slope + kink) / parabola, right = 0.5 + (slope - kink) / parabola;
    if (left > 0.0 && left < 0.5) most = max(most, abs(at(left)));
    if (right > 0.5 && right < 1.0) most = max(most, abs(at(right)));
    return most;
  }

  /// The largest magnitude of the shear force: at one of the ends, or next to the force.
  [[nodiscard]] Force shear() const {
    const Force even = abs((M_2 - M_1) / l), at_middle = abs(F / 2.0), at_ends = abs(q * l / 2.0 + F / 2.0);
    return even + max(at_middle, at_ends);
  }

  /// The end moment of the larger magnitude, and the other one over it; 1 without end moments.
  [[nodiscard]] Moment larger_end() const { return abs(M_1) >= abs(M_2) ? M_1 : M_2; }
  [[nodiscard]] double end_ratio() const {
    const Moment larger = larger_end(), smaller = abs(M_1) >= abs(M_2) ? M_2 : M_1;
    return in_si(larger) == 0.0 ? 1.0 : in_si(smaller) / in_si(larger);
  }
};

/// The equivalent uniform moment factor of EN 1993-1-1, table B.3, for a bar whose ends do not sway.
inline double uniform_moment_factor(const Moments& m) {
  constexpr double least = 0.4;
  const double psi = m.end_ratio();
  if (!m.has_load()) return std::max(least, 0.6 + 0.4 * psi);
  const bool is_force = abs(m.F) * m.l / 4.0 > abs(m.q) * m.l * m.l / 8.0;
  const double M_h = in_si(m.larger_end()), M_s = in_si(m.at_middle());
  if (std::abs(M_s) > std::abs(M_h)) {
    const double alpha_h = M_h / M_s;
    const double start = is_force ? 0.90 : 0.95, share = is_force ? 0.10 : 0.05;
    if (alpha_h >= 0.0 || psi >= 0.0) return start + share * alpha_h;
    // The code prints a minus for the force; the unfavourable sign is taken.
    const double turned = share * alpha_h * (1.0 + 2.0 * psi);
    return start + (is_force ? std::abs(turned) : turned);
  }
  if (M_h == 0.0) return 1.0;  // no moment at the ends and none at mid-length: a load of both signs
  const double alpha_s = M_s / M_h;
  if (alpha_s >= 0.0) return std::max(least, 0.2 + 0.8 * alpha_s);
  const double raised = psi >= 0.0 ? (is_force ? 0.0 : 0.1) : (is_force ? -0.2 * psi : 0.1 * (1.0 - psi));
  return std::max(least, raised - 0.8 * alpha_s);
}

/// AISC 360 (F1-1), for lateral-torsional buckling.
inline double moment_gradient_factor(const Moments& m) {
  const double most = in_si(m.largest());
  if (most == 0.0) return 1.0;
  const auto at = [&](double x) { return std::abs(in_si(m.at(x))); };
  return 12.5 * most / (2.5 * most + 3.0 * at(0.25) + 4.0 * at(0.5) + 3.0 * at(0.75));
}

}  // namespace loadpath::column
