// A bar with bending by AISC 360 (allowable strength): resistance to bending by chapter F, interaction by H1.
#pragma once

#include "calculators/column/bending/eurocode_bending.hpp"

namespace loadpath::column {

/// Width-to-thickness ratios of flange and web in bending, with their limits, table B4.1b.
struct Compactness {
  double flange = 0.0, flange_p = 1.0, flange_r = 1.0;  // the ratio, limits of compact and of noncompact
  double web = 0.0, web_p = 1.0;
};

inline Compactness compactness(const BeamColumnInput& in, SectionKind kind, Length height, Length width) {
  const double root = std::sqrt(in.E / in.R_e), square = in.E / in.R_e;
  const Length wall = in.t_w, flange = is_set(in.t_f) ? in.t_f : wall;
  if (is_I(kind)) {
    const Length r = is_set(in.r) ? in.r : 0.0 * mm;
    return {0.5 * in.b / in.t_f, 0.38 * root, 1.0 * root, (in.h - 2.0 * (in.t_f + r)) / in.t_w, 3.76 * root};
  }
  if (is_set(in.d)) return {in.d / wall, 0.07 * square, 0.31 * square, 0.0, 1.0};
  return {(width - 3.0 * flange) / flange, 1.12 * root, 1.40 * root, (height - 3.0 * wall) / wall, 2.42 * root};
}

/// The nominal moment without lateral-torsional buckling: F2, F3, F6, F7 and F8, between compact and noncompact.
inline Moment moment_of_section(const BeamColumnInput& in, SectionKind kind, const Compactness& c, SectionModulus Z,
                                SectionModulus S, bool about_weak) {
  const Moment M_p = in.R_e * (about_weak ? min(Z, 1.6 * S) : Z);
  if (c.flange <= c.flange_p) return M_p;
  if (is_set(in.d)) return min(M_p, (0.021 * in.E / c.flange + in.R_e) * S);
  if (!is_I(kind)) {
    const double share = 3.57 * c.flange * std::sqrt(in.R_e / in.E) - 4.0;
    return min(M_p, M_p - (M_p - in.R_e * S) * share);
  }
  return M_p - (M_p - 0.7 * in.R_e * S) * ((c.flange - c.flange_p) / (c.flange_r - c.flange_p));
}

/// The lengths up to which the bar yields first, and up to which it buckles inelastically.
struct TwistLengths {
  Length L_p = unset<Length>, L_r = unset<Length>;
};

/// The limits of F2 for an I section, those of F7 for a box.
inline TwistLengths twist_lengths(const BeamColumnInput& in, const Bending& at) {
  const Geometry& s = at.s;
  const Length r_y = sqrt(s.I_z / s.A);
  if (!is_I(at.kind)) {
    const auto root = r_y * in.E * sqrt(s.I_t * s.A);
    return {0.13 * root / (in.R_e * s.W_pl_y), 2.0 * root / (0.7 * in.R_e * s.W_y)};
  }
  const auto r_ts = sqrt(sqrt(s.I_z * s.I_w) / s.W_y);
  const double J = s.I_t / (s.W_y * (in.h - in.t_f)), strain = 0.7 * in.R_e / in.E;
  return {1.76 * r_y * std::sqrt(in.E / in.R_e),
          1.95 * r_ts / strain * std::sqrt(J + std::sqrt(J * J + 6.76 * strain * strain))};
}

/// (F2-3) and (F2-4) of an I section; of a box the elastic branch of F7.
inline Moment elastic_twist_moment(const BeamColumnInput& in, const Bending& at, Length L_b, double C_b) {
  const Geometry& s = at.s;
  if (!is_I(at.kind)) return 2.0 * in.E * C_b * sqrt(s.I_t * s.A) * sqrt(s.I_z / s.A) / L_b;
  const auto r_ts = sqrt(sqrt(s.I_z * s.I_w) / s.W_y);
  const double J = s.I_t / (s.W_y * (in.h - in.t_f)), slenderness = L_b / r_ts;
  const Stress F_cr =
      C_b * pi * pi * in.E / (slenderness * slenderness) * std::sqrt(1.0 + 0.078 * J * slenderness * slenderness);
  return F_cr * s.W_y;
}

/// The nominal moment about y, with lateral-torsional buckling.
template <class Tracer>
Moment nominal_moment_y(const BeamColumnInput& in, const Bending& at, BeamColumnResult& r, Tracer& trace) {
  const Compactness c = compactness(in, at.kind, in.h, in.b);
  const auto M_s = trace.value("M_s", moment_of_section(in, at.kind, c, at.s.W_pl_y, at.s.W_y, false),
                               "nominal moment of the section about y, F2, F3, F7, F8, [AISC360-bending]");
  if (!can_turn_over(at.s) || is_set(in.d)) return M_s;
  const double C_b = r.C_1 = trace.value("C_b",
                                         is_set(in.C_1_set)   ? in.C_1_set
                                         : is_one_segment(in) ? moment_gradient_factor(at.y)
                                                              : 1.0,
                                         "AISC 360 (F1-1), [AISC360-bending]; 1 where only a part of the bar is known");
  const auto [p, e] = twist_lengths(in, at);
  const auto L_p = trace.value("L_p", p, "F2, F7: up to here the section yields, [AISC360-bending]");
  const auto L_r = trace.value("L_r", e, "F2, F7: from here it buckles elastically, [AISC360-bending]");
  const auto L_b = trace.value("L_b", lateral_length(in), "between supports against twisting");
  if (L_b <= L_p) return M_s;
  const auto M_p = trace.value("M_p", in.R_e * at.s.W_pl_y, "plastic moment about y");
  const auto M_r = trace.value("M_r", 0.7 * in.R_e * at.s.W_y, "at the start of yielding with residual stresses");
  if (L_b > L_r) {
    r.M_cr = trace.value("M_cr", elastic_twist_moment(in, at, L_b, C_b), "elastic, (F2-3), (F7-11), [AISC360-bending]");
    return min(M_s, r.M_cr);
  }
  STEP(M_b, C_b * (M_p - (M_p - M_r) * (L_b - L_p) / (L_r - L_p)), "inelastic, (F2-2), (F7-10), [AISC360-bending]");
  return min(M_s, M_b);
}

/// B_1 of appendix 8 with the effective length: allowable strength, alpha = 1.6. Near the critical force and beyond it
/// stays finite; there the axial part exceeds 1 by itself.
inline double amplification(const BeamColumnInput& in, const Bending& at, AxisName axis, Length s) {
  if (in.analysis == Analysis::second_order) return 1.0;
  constexpr double most = 0.999;
  const Moments& m = axis == AxisName::y ? at.y : at.z;
  const double C_m = sways(in, axis) || m.has_load() ? 1.0 : 0.6 + 0.4 * m.end_ratio();
  const Force P_e = pi * pi * in.E * (axis == AxisName::y ? at.s.I_y : at.s.I_z) / (s * s);
  const double x = 1.6 * std::max(0.0, in_si(at.N)) / in_si(P_e);
  return std::max(1.0, C_m / (1.0 - std::min(x, most)));
}

/// (H1-1a), (H1-1b), and H1.2 in tension.
template <class Tracer>
void interact_by_aisc(const BeamColumnInput& in, const Bending& at, BeamColumnResult& r, Tracer& trace) {
  constexpr double of_tension = 1.67;
  const bool is_pressed = at.N > 0.0 * kN;
  const auto P_r = trace.value("P_r", abs(at.N), "required axial strength");
  const auto P_c =
      trace.value("P_c", is_pressed ? r.P_all : in.R_e * at.s.A / of_tension,
                  is_pressed ? "allowable force of chapter E" : "allowable force of D2, [AISC360-bending]");
  const auto M_n = trace.value("M_n", nominal_moment_y(in, at, r, trace),
                               "nominal moment about y, the lower of section and lateral-torsional buckling");
  STEP_TO(r, M_cy, M_n / in.Omega_b, "over Omega_b");
  const Compactness c = compactness(in, at.kind, in.b, in.h);
  const auto M_nz = trace.value("M_nz", moment_of_section(in, at.kind, c, at.s.W_pl_z, at.s.W_z, true),
                                "nominal moment about z, F6, F7, F8, [AISC360-bending]");
  STEP_TO(r, M_cz, M_nz / in.Omega_b, "over Omega_b");
  const auto s_y = r.axes[0].s, s_z = r.axes[1].s;
  const double B_y = r.B_y = trace.value("B_y", amplification(in, at, AxisName::y, s_y),
                                         "B_1, (A-8-3), [AISC360-bending]; 1 of moments of second order");
  const double B_z = r.B_z = trace.value("B_z", amplification(in, at, AxisName::z, s_z),
                                         "B_1, (A-8-3), [AISC360-bending]; 1 of moments of second order");
  STEP(n_P, P_r / P_c, "axial part");
  STEP(m_M, B_y * r.M_yEd / r.M_cy + B_z * r.M_zEd / r.M_cz, "bending part, with its amplification");
  STEP_TO(r, u_H, n_P >= 0.2 ? n_P + 8.0 / 9.0 * m_M : n_P / 2.0 + m_M, "AISC 360 (H1-1), [AISC360-bending]");
  if (r.M_yEd > 0.0 * N_m) {
    STEP_TO(r, u_LT, r.M_yEd / r.M_cy, "moment about y without the axial part");
  }
}

/// The largest ratio of a part in bending over its limit: noncompact flanges, compact webs.
inline double slender_in_bending(const BeamColumnInput& in, SectionKind kind) {
  const Compactness y = compactness(in, kind, in.h, in.b), z = compactness(in, kind, in.b, in.h);
  if (is_I(kind) || is_set(in.d)) return std::max(y.flange / y.flange_r, y.web / y.web_p);
  return std::max({y.flange / y.flange_r, y.web / y.web_p, z.flange / z.flange_r, z.web / z.web_p});
}

}  // namespace loadpath::column
