// The thick-walled result next to the membrane one: Lamé's stresses at the inner surface of cylinders and spheres. It
// is always printed, so that nothing jumps where the thin wall ends; but not of spheres with liquid, whose weight on
// the ring it leaves out.
#pragma once

#include "calculators/vessel/assess.hpp"

namespace loadpath::vessel {

struct LameResult {
  Stress sigma_L = unset<Stress>;
  double e_L = unset<double>;
  Length delta_L = unset<Length>;
  double u_L = unset<double>;
};

template <class Result>
constexpr auto lame_results() {
  return Fields{
      Field<Result, Stress>{&Result::sigma_L, "sigma_L", MPa, "thick wall: equivalent stress by Lamé, inside"},
      Field<Result, double>{&Result::e_L, "e_L", ratio, "error of the thin-wall equivalent stress against Lamé"},
      Field<Result, Length>{&Result::delta_L, "delta_L", mm, "thick wall: minimum nominal thickness by Lamé"},
      Field<Result, double>{&Result::u_L, "u_L", ratio, "thick wall: equivalent stress / allowable stress"}};
}

/// Hoop and meridional stress at the inner surface.
struct Principal {
  Stress o, M;
};

/// A cylinder, with or without the axial force of its ends.
struct ThickCylinder {
  static constexpr int power = 2;  // power of the radii in the function that its stresses grow linearly with
  bool closed;

  template <class Tracer>
  Principal operator()(Stress p_i, Length R_i, Length R_a, Tracer& trace) const {
    STEP(sigma_t, p_i * (pow<2>(R_a) + pow<2>(R_i)) / (pow<2>(R_a) - pow<2>(R_i)), "hoop stress inside, [Lame]");
    if (!closed) return {sigma_t, trace.value("sigma_z", 0.0 * MPa, "no ends, no pull")};
    STEP(sigma_z, p_i * pow<2>(R_i) / (pow<2>(R_a) - pow<2>(R_i)), "pull of the ends over the ring, [Lame]");
    return {sigma_t, sigma_z};
  }
};

struct ThickSphere {
  static constexpr int power = 3;

  template <class Tracer>
  Principal operator()(Stress p_i, Length R_i, Length R_a, Tracer& trace) const {
    STEP(sigma_t, p_i * (pow<3>(R_a) + 2.0 * pow<3>(R_i)) / (2.0 * (pow<3>(R_a) - pow<3>(R_i))),
         "stress inside, alike in all directions of the wall, [Lame]");
    trace.step("sigma_z", "sigma_t", "along the meridian too", sigma_t);
    return {sigma_t, sigma_t};
  }
};

template <class Thick, class Tracer>
Membrane thick_stresses(const Thick& thick, Stress p_i, Length R_i, Length R_a, const Strength& strength,
                        Tracer& trace) {
  const auto [sigma_t, sigma_z] = thick(p_i, R_i, R_a, trace);
  STEP(s_o, sigma_t / strength.z_l, "hoop stress for longitudinal welds");
  STEP(s_M, sigma_z / strength.z_c, "meridional stress for circumferential welds");
  return {p_i, sigma_t, sigma_z, s_o, s_M};
}

/// Wall over mean radius, from the reciprocal x of the powers' ratio, outer over inner radius, less 1: zero of a solid
/// wall, the larger the thinner. Unset where x is not positive.
template <int power>
double wall_over_mean(double x) {
  if (!(x > 0.0)) return unset<double>;
  // 1 - 1/c of the ratio c of the radii, c^power = 1 + 1/x, without the cancellation of thin walls
  const double c = power == 2 ? std::sqrt(1.0 + 1.0 / x) : numerics::cube_root(1.0 + 1.0 / x);
  const double wall = 1.0 / (x * c * (power == 2 ? c + 1.0 : c * c + c + 1.0));  // over the outer radius
  return 2.0 * wall / (2.0 - wall);
}

/// Wall over mean radius of the vessel that is just strong enough; unset where even a solid one is not. The load is the
/// x of wall_over_mean.
template <class Thick>
double least_thickness_ratio(const Thick& thick, Stress p_i, const Strength& strength) {
  NoTrace off;
  const Length unit = 1.0 * m;
  const double x_half = 1.0 / (std::pow(2.0, Thick::power) - 1.0);
  const Membrane solid = thick_stresses(thick, p_i, 0.0 * unit, unit, strength, off);
  const Membrane half = thick_stresses(thick, p_i, 0.5 * unit, unit, strength, off);
  const double x = largest_load(
      {growing(solid.s_o, half.s_o, x_half), growing(solid.s_M, half.s_M, x_half), {in_si(-p_i), 0.0}}, strength);
  return wall_over_mean<Thick::power>(x);
}

/// The thickness with that ratio, where the mean radius `mean(delta_c)` is a straight line; unset where there is none.
template <class Mean>
Length thickness_of_ratio(double ratio, const Mean& mean) {
  const Length thin = mean(0.0 * m);
  const double slope = (mean(thin) - thin) / thin;
  const double delta_c = in_si(ratio * thin / (1.0 - ratio * slope));
  return from_si<Length>(delta_c >= 0.0 ? delta_c : unset<double>);
}

/// Checks and sizes the wall by Lamé; `mean(delta_c)` is the middle radius of a wall of this thickness.
template <class Thick, class Result, class Mean, class Tracer>
void compare(const Thick& thick, const WallInput& in, Result& r, Length R_m, const Mean& mean, Tracer& trace) {
  const Strength strength = strength_of(in, r.sigma_all);
  if (!(R_m > 0.5 * r.delta_c)) return;  // a wall that would fill the vessel
  STEP(R_i, R_m - 0.5 * r.delta_c, "inside of the carrying wall");
  STEP(R_a, R_m + 0.5 * r.delta_c, "outside of the carrying wall");
  const Stress sigma_L = r.sigma_L =
      equivalent(thick_stresses(thick, r.p_i, R_i, R_a, strength, trace), strength.hypothesis, trace);
  trace.value("sigma_L", sigma_L, "the thick wall");
  trace.value("sigma_v", r.sigma_v, "the thin wall");
  STEP_TO(r, e_L, r.sigma_v / sigma_L - 1.0, "error of the thin-wall formula");
  STEP_TO(r, u_L, sigma_L / r.sigma_all, "the same strength condition with the stress of the thick wall");
  const Length least = thickness_of_ratio(least_thickness_ratio(thick, r.p_i, strength), mean);
  r.delta_L = ordered("delta_L", least, in, trace);
}

}  // namespace loadpath::vessel
