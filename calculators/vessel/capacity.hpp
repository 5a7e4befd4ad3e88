// Load capacity of a wall: the strength condition, solved for the pressure, the thickness or the ratio of the radii.
//
// Its stresses grow linearly with the pressure of the gas, with the reciprocal of the thickness where the radii stay as
// they are, and in thick walls with a function of the radii. So the condition has a closed form: straight lines for
// Tresca and the membrane stresses, a parabola for von Mises.
#pragma once

#include "calculators/vessel/membrane.hpp"
#include "lib/numerics/fixed_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace loadpath::vessel {

/// A stress that grows linearly with a load x >= 0, in SI: at + by x.
struct Growing {
  double at = 0.0, by = 0.0;

  friend constexpr Growing operator-(Growing a, Growing b) { return {a.at - b.at, a.by - b.by}; }
};

/// Hoop and meridional stress including the weld joint efficiency, and the radial stress at the inner surface.
struct GrowingStresses {
  Growing o, M, r;
};

/// The load at which it reaches sigma; 0 where it does without one, infinite (by a division) where it never does.
inline double load_of(Growing stress, double sigma) {
  const auto [at, by] = stress;
  const double load = (sigma - std::copysign(1.0, by) * at) / std::abs(by);
  return std::abs(at) < sigma && std::isfinite(by) ? load : 0.0;
}

/// The load at which the first of these does.
template <class... Stresses>
double load_at(double sigma, const Stresses&... stresses) {
  double least = std::numeric_limits<double>::infinity();
  ((least = std::min(least, load_of(stresses, sigma))), ...);
  return least;
}

/// The same for the root of half the sum of their squares.
template <class... Stresses>
double load_at_mises(double sigma, const Stresses&... differences) {
  const double a = (0.0 + ... + (differences.by * differences.by));  // a quadratic, its middle coefficient halved
  const double b = (0.0 + ... + (differences.at * differences.by));
  const double c = ((-2.0 * sigma * sigma) + ... + (differences.at * differences.at));
  const double root = std::sqrt(b * b - a * c);
  const double rising = a > 0.0 ? (root - b) / a : std::numeric_limits<double>::infinity();
  return c < 0.0 && std::isfinite(a) ? (b > 0.0 ? -c / (b + root) : rising) : 0.0;
}

/// The load at which stresses are just strong enough: 0 where they are too large without it.
inline double largest_load(const GrowingStresses& s, const Strength& strength) {
  const double sigma = in_si(strength.sigma_all);
  if (strength.hypothesis == Hypothesis::membrane) return load_at(sigma, s.o, s.M);
  if (strength.hypothesis == Hypothesis::mises) return load_at_mises(sigma, s.o - s.M, s.o - s.r, s.M - s.r);
  return load_at(sigma, s.o - s.M, s.o - s.r, s.M - s.r);
}

/// From the stresses without load and at a load.
inline Growing growing(Stress without, Stress with, double load) {
  return {in_si(without), in_si(with - without) / load};
}

/// The allowable gas pressure of a wall; zero where the liquid by itself is too much.
template <class Shape>
Stress allowable_pressure(const Shape& shape, Length delta_c, const Strength& strength) {
  const auto one_over_load = [&](double t) {
    NoTrace off;
    const Place place = shape.at(t, off);
    const Membrane none = membrane(place, 0.0 * MPa, delta_c, strength, off);
    const Membrane some = membrane(place, strength.sigma_all, delta_c, strength, off);
    const GrowingStresses s{growing(none.s_o, some.s_o, 1.0), growing(none.s_M, some.s_M, 1.0),
                            growing(-none.p_i, -some.p_i, 1.0)};
    return 1.0 / largest_load(s, strength);
  };
  return strength.sigma_all / largest_over(shape, one_over_load).f;
}

/// The thickness that the places of a shape need if its radii stay as they are; infinite where none is enough.
/// `unit` is any length.
template <class Shape>
Length needed_thickness(const Shape& shape, Stress p, Length unit, const Strength& strength) {
  const auto units = [&](double t) {
    NoTrace off;
    const Membrane m = membrane(shape.at(t, off), p, unit, strength, off);
    const GrowingStresses s{{0.0, in_si(m.s_o)}, {0.0, in_si(m.s_M)}, {in_si(-m.p_i), 0.0}};
    return 1.0 / largest_load(s, strength);
  };
  return largest_over(shape, units).f * unit;
}

/// The least carrying thickness of the shape that `make(delta_c)` gives; unset where none is. `scale` is a length of
/// the vessel.
template <class Make>
Length least_thickness(const Make& make, Stress p, Length scale, const Strength& strength) {
  constexpr double thickest = 16.0, thinnest = 1e-9;  // between rings a wall of zero thickness would be enough
  const double most = thickest * in_si(scale);
  const auto needed = [&](Length delta_c) { return in_si(needed_thickness(make(delta_c), p, scale, strength)); };
  if constexpr (requires { make(scale).is_straight(); }) {
    const auto by_si = [&](double delta_c) { return needed(from_si<Length>(delta_c)); };
    if (make(scale).is_straight()) return from_si<Length>(numerics::straight_fixed_point(by_si, most));
  }
  const auto of_some = [&](double delta_c) { return needed(max(from_si<Length>(delta_c), thinnest * scale)); };
  return from_si<Length>(numerics::fixed_point(of_some, most));
}

}  // namespace loadpath::vessel
