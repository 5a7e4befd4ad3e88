// Torsional and torsional-flexural buckling of a compressed bar of open section with an axis of symmetry, by
// EN 1993-1-1, 6.3.1.4, and AISC 360, E4: channels, tees and angles of equal legs.
//
// The section turns about its shear centre while it bends about its axis of symmetry. The ends are held against
// twisting and free to warp; without I_t, I_w or the place of the shear centre they follow from the middle lines of the
// walls.
#pragma once

#include "calculators/column/buckling_parts.hpp"
#include "calculators/column/member/methods.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::column {

/// Of an open section: what turns it, what holds it against warping, and its shear centre from the centroid, on the
/// axis of symmetry. Unset for a section without one, or whose walls are not known.
struct Twisting {
  SecondMoment I_t = unset<SecondMoment>;
  Warping I_w = unset<Warping>;
  Length e = unset<Length>;
};
Twisting twisting_of(const BucklingInput& in);
/// Only by the middle lines of its walls.
Twisting twisting_by_walls(const BucklingInput& in);

/// Distance of the supports against twisting; a free or swaying end is not held.
Length twisting_length(const BucklingInput& in);

/// About the axis of symmetry of an open section: second moment, and effective length.
SecondMoment moment_of_symmetry(const BucklingInput& in);
Length length_of_symmetry(const BucklingInput& in, const MemberResult& r);

/// Whether all of this is known.
inline bool twists_about_known_axis(const BucklingInput& in) {
  const Twisting twist = twisting_of(in);
  return is_set(twist.I_t) && is_set(twist.I_w) && is_set(twist.e) && is_set(moment_of_symmetry(in));
}

/// Sum of both second moments.
SecondMoment polar_moment(const BucklingInput& in);

template <class Tracer>
void buckle_twisting(const BucklingInput& in, MemberResult& r, Tracer& trace) {
  if (!is_set(in.A) || !is_set(in.E)) return;  // known to the compiler of a sweep, which calls nothing then
  if (!twists_about_known_axis(in)) return;
  const Twisting twist = twisting_of(in);
  const auto I_t = trace.value("I_t", twist.I_t, is_set(in.I_t) ? "as given" : "thin walls: sum of b t^3/3");
  const auto I_w =
      trace.value("I_w", twist.I_w, is_set(in.I_w) ? "as given" : "middle lines of the walls, [EN1993-1-1-TF]");
  const auto e_M =
      trace.value("e_M", twist.e, is_set(in.y_M) ? "as given" : "middle lines of the walls, [EN1993-1-1-TF]");
  const auto l_T = trace.value("l_T", twisting_length(in), "distance of the supports against twisting");
  const auto I_p = trace.value("I_p", polar_moment(in), "sum of both second moments");
  const auto I_s = trace.value("I_s", moment_of_symmetry(in), "about the axis of symmetry");
  const auto s = trace.value("s", length_of_symmetry(in, r), "effective length for bending about it");
  STEP(i_0, sqrt(I_p / r.A + pow<2>(e_M)), "polar radius about the shear centre, 6.3.1.4, [EN1993-1-1-TF]");
  STEP(G, in.E / 2.6, "nu = 0.3");
  STEP_TO(r, N_crT, (G * I_t + pow<2>(pi) * in.E * I_w / pow<2>(l_T)) / pow<2>(i_0),
          "torsional buckling, [EN1993-1-1-TF]");
  STEP(N_s, pow<2>(pi) * in.E * I_s / pow<2>(s), "flexural buckling about the axis of symmetry, [B25]");
  STEP(H, 1.0 - pow<2>(e_M / i_0), "AISC 360 (E4-8), [AISC360-E4]");
  STEP_TO(r, N_crTF, 2.0 * N_s * N_crT / (N_s + N_crT + sqrt(pow<2>(N_s + N_crT) - 4.0 * H * N_s * N_crT)),
          "torsional-flexural buckling, the smaller root, (E4-3), [AISC360-E4], [EN1993-1-1-TF]");
  STEP_TO(r, lambda_TF, pi * sqrt(in.E * r.A / N_crTF), "slenderness of the bar that buckles at the same force");
}

/// The stress at which it buckles so, by the method that decides, and the force with its safety over it.
template <class Tracer>
void judge_twisting(const BucklingInput& in, const Material& material, Method by, MemberResult& r, Tracer& trace) {
  if (!is_set(r.lambda_TF) || !(r.F > 0.0 * kN)) return;
  NoTrace none;  // the symbols of these formulas are those of flexural buckling
  Stress critical = unset<Stress>;
  if (by == Method::ec3) {
    if (!is_set(in.R_e) || !is_steel(in) || !is_set(r.axes[1].alpha)) return;
    const double reduction = ec3_reduction(r.lambda_TF, r.axes[1].alpha, material, none);
    const double chi_TF = trace.value("chi_TF", reduction, "6.3.1.4, curve about z, (6.49), [EN1993-1-1-TF]");
    critical = NAMED_STEP("sigma_TF", chi_TF * in.R_e, "without its partial factor");
  } else {
    critical = trace.value("sigma_TF", stress_of_slenderness(by, r.lambda_TF, material, none),
                           "by the governing method at the slenderness of this buckling");
  }
  const auto sigma_TF = critical;
  const double n = safety(in, by, true, trace);
  if (!is_set(sigma_TF) || !is_set(n)) return;
  STEP_TO(r, u_TF, n * r.F / (sigma_TF * r.A), "force, with the safety factor n, over that of this buckling");
}

}  // namespace loadpath::column
