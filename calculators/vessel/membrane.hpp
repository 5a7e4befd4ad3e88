// Membrane stresses of shells of revolution by eq. 9 of [B24], their equivalent stress, and the most loaded place.
//
// A shape is a class with
//   std::size_t places() const;                           how many places are looked at
//   double place(std::size_t i) const;                    the i-th, as a parameter 0..1 along the meridian
//   static constexpr bool continuous = true;              where any place between them may govern
//   template <class Tracer> Place at(double t, Tracer&);  the shell there
//   Length sharpest() const;                              its smallest radius of curvature
#pragma once

#include "calculators/vessel/most_loaded.hpp"
#include "calculators/vessel/wall.hpp"
#include "lib/quantity/gravity.hpp"

namespace loadpath::vessel {

inline constexpr Acceleration gravity = standard_gravity * m_per_s2;

using Curvature = Twist;    // 1/length
using Tension = Stiffness;  // force per length of a section

/// The shell at a place: p q_M + n_M is the meridional force per length that balances what lies beyond the place.
struct Place {
  Length rho_o = unset<Length>;                 // radius of curvature across the meridian
  Curvature kappa_M = from_si<Curvature>(0.0);  // curvature of the meridian, 0 where it is straight
  Length q_M = unset<Length>;                   // share of the gas
  Tension n_M = from_si<Tension>(0.0);          // share of the liquid
  Stress p_l = from_si<Stress>(0.0);            // pressure of the liquid
  Length r = unset<Length>, z = unset<Length>;  // where it is: from the axis, along it
  double w_o = 1.0;                             // share of the hoop force in the wall next to rings
};

/// The pressure of a liquid at rest at the height z above the lowest place; zero above the surface.
template <class Tracer>
Stress head(const Liquid& liquid, Length z, Tracer& trace) {
  const Acceleration g_n = trace.value("g_n", gravity, "standard acceleration of free fall");
  trace.value("z", z, "height of the position");
  return NAMED_STEP("p_l", liquid.rho * g_n * max(liquid.h_l - z, 0.0 * liquid.h_l), "head of the liquid");
}

struct Strength {
  Stress sigma_all;
  double z_l, z_c;
  Hypothesis hypothesis;
};

/// Wall stresses: the pressure on it, hoop and meridional stress, and both divided by the weld joint efficiency.
struct Membrane {
  Stress p_i, o, M, s_o, s_M;
};

template <class Tracer>
Stress allowable(const WallInput& in, Tracer& trace) {
  if (is_set(in.sigma_adm)) return NAMED_STEP("sigma_all", in.sigma_adm, "as given");
  return NAMED_STEP("sigma_all", in.R_e / in.S, "yield strength over the safety factor");
}

/// Equivalent of the principal stresses s_o, s_M in the wall and -p_i at its inner surface.
template <class Tracer>
Stress equivalent(Stress s_o, Stress s_M, Stress p_i, Hypothesis hypothesis, Tracer& trace) {
  if (hypothesis == Hypothesis::membrane)
    return NAMED_STEP("sigma_v", max(abs(s_o), abs(s_M)), "the larger membrane stress, [B24]");
  if (hypothesis == Hypothesis::mises)
    return NAMED_STEP("sigma_v", sqrt(0.5 * (pow<2>(s_o - s_M) + pow<2>(s_M + p_i) + pow<2>(s_o + p_i))),
                      "with the radial stress -p_i at the inner surface, [Mises]");
  return NAMED_STEP("sigma_v", max(max(s_o, s_M), -p_i) - min(min(s_o, s_M), -p_i),
                    "Tresca, with the radial stress -p_i at the inner surface");
}

template <class Tracer>
Stress hoop(const Place& place, Stress p_i, Stress sigma_M, Length delta_c, Tracer& trace) {
  if (place.w_o < 1.0)
    return NAMED_STEP("sigma_o", place.w_o * place.rho_o * p_i / delta_c,
                      "[B24] (9), (10) with rings: the wall carries its part");
  return NAMED_STEP("sigma_o", place.rho_o * (p_i / delta_c - sigma_M * place.kappa_M),
                    "equilibrium normal to the wall, [B24] (9)");
}

template <class Tracer>
Membrane membrane(const Place& place, Stress p, Length delta_c, const Strength& strength, Tracer& trace) {
  STEP(p_i, p + place.p_l, "gas and liquid");
  STEP(sigma_M, (p * place.q_M + place.n_M) / delta_c, "axial equilibrium of the part beyond the location, [B24] (11)");
  const Stress sigma_o = hoop(place, p_i, sigma_M, delta_c, trace);
  STEP(s_o, sigma_o / strength.z_l, "hoop stress for longitudinal welds");
  STEP(s_M, sigma_M / strength.z_c, "meridional stress for circumferential welds");
  return {p_i, sigma_o, sigma_M, s_o, s_M};
}

template <class Tracer>
Stress equivalent(const Membrane& m, Hypothesis hypothesis, Tracer& trace) {
  return equivalent(m.s_o, m.s_M, m.p_i, hypothesis, trace);
}

/// The place of the largest equivalent stress.
template <class Shape>
double governing_place(const Shape& shape, Stress p, Length delta_c, const Strength& strength) {
  if (shape.places() == 1) return shape.place(0);
  return largest_over(shape,
                      [&](double t) {
                        NoTrace off;
                        const Membrane m = membrane(shape.at(t, off), p, delta_c, strength, off);
                        return equivalent(m, strength.hypothesis, off) / strength.sigma_all;
                      })
      .t;
}

/// How far the middle of the carrying wall lies outside of the surface that the given radii belong to.
template <class Tracer>
Length offset(const WallInput& in, Length delta, Length delta_c, Tracer& trace) {
  if (in.measured == Measured::inner)
    return NAMED_STEP("e", in.c + 0.5 * delta_c, "mid-surface of the carrying wall, from the inside of the new wall");
  if (in.measured == Measured::outer)
    return NAMED_STEP("e", -0.5 * delta_c,
                      "mid-surface of the carrying wall, from the outside, which tolerance and corrosion leave");
  return NAMED_STEP("e", in.c + 0.5 * delta_c - 0.5 * delta,
                    "mid-surface of the carrying wall, from that of the new wall");
}

/// The same for a wall of this carrying thickness.
inline Length offset(const WallInput& in, Length delta_c) {
  NoTrace off;
  return offset(in, (delta_c + in.c + in.c_t) / (1.0 - in.f_t), delta_c, off);
}

}  // namespace loadpath::vessel
