// A bar with bending by EN 1993-1-1:2005: section, lateral-torsional buckling, interaction with annex B.
#pragma once

#include "calculators/column/bending/classes.hpp"
#include "calculators/column/bending/parts.hpp"
#include "calculators/column/bending/result.hpp"
#include "lib/calculator/trace.hpp"

namespace loadpath::column {

/// The actions with their factor, and the section with its class.
struct Bending {
  Moments y, z;  // as given, without the factor of the actions
  Geometry s;
  SectionKind kind = SectionKind::unsaid;
  double gamma_F = 1.0;
  Force N = unset<Force>;                           // design value, compression positive
  Moment M_y = unset<Moment>, M_z = unset<Moment>;  // design values, magnitudes
  int section_class = 4;
};

/// Table 6.4 (general case), or table 6.5.
inline Curve twist_curve(const BeamColumnInput& in, SectionKind kind) {
  const bool is_low = in.h / in.b <= 2.0;
  if (in.twist_curves == TwistCurves::rolled && is_I(kind)) {
    if (kind == SectionKind::rolled_I) return is_low ? Curve::b : Curve::c;
    return is_low ? Curve::c : Curve::d;
  }
  if (kind == SectionKind::rolled_I) return is_low ? Curve::a : Curve::b;
  return kind == SectionKind::welded_I && is_low ? Curve::c : Curve::d;
}

template <class Tracer>
void turn_over(const BeamColumnInput& in, const Bending& at, SectionModulus W_y, BeamColumnResult& r, Tracer& trace) {
  r.chi_LT = 1.0;
  if (!can_turn_over(at.s) || !(at.M_y > 0.0 * N_m)) {
    trace.value("chi_LT", r.chi_LT, "no bending about a stronger axis");
    return;
  }
  const auto M_0 = trace.value("M_0", critical_uniform_moment(lateral_of(in, at.s), lateral_length(in)),
                               "critical moment under a uniform moment, fork ends, [EN1993-1-1-bending]");
  if (is_set(in.C_1_set)) {
    r.C_1 = trace.value("C_1", in.C_1_set, "as given");
    STEP_TO(r, M_cr, r.C_1 * M_0, "under the moments along the bar");
  } else {
    const auto M_cr = r.M_cr = trace.value("M_cr", critical_moment(in, at.s),
                                           is_one_segment(in) ? "by the energy method under the moments along the bar"
                                                              : "the moment counts as uniform between the supports");
    STEP_TO(r, C_1, M_cr / M_0, "over that of a uniform moment");
  }
  STEP_TO(r, lambda_LT, sqrt(W_y * in.R_e / r.M_cr), "EN 1993-1-1, 6.3.2.2, [EN1993-1-1-LTB]");
  const Curve curve = twist_curve(in, at.kind);
  const double alpha_LT = trace.value("alpha_LT", imperfection(curve), imperfection_reason(curve));
  if (in.twist_curves == TwistCurves::rolled && is_I(at.kind)) {
    STEP(Phi_LT, 0.5 * (1.0 + alpha_LT * (r.lambda_LT - 0.4) + 0.75 * pow<2>(r.lambda_LT)),
         "6.3.2.3, [EN1993-1-1-bending]");
    STEP_TO(r, chi_LT,
            r.lambda_LT <= 0.4 ? 1.0
                               : min(min(1.0, 1.0 / pow<2>(r.lambda_LT)),
                                     1.0 / (Phi_LT + sqrt(pow<2>(Phi_LT) - 0.75 * pow<2>(r.lambda_LT)))),
            "EN 1993-1-1 (6.57), [EN1993-1-1-bending]");
    return;
  }
  STEP(Phi_LT, 0.5 * (1.0 + alpha_LT * (r.lambda_LT - 0.2) + pow<2>(r.lambda_LT)), "6.3.2.2, [EN1993-1-1-LTB]");
  STEP_TO(r, chi_LT, r.lambda_LT <= 0.2 ? 1.0 : min(1.0, 1.0 / (Phi_LT + sqrt(pow<2>(Phi_LT) - pow<2>(r.lambda_LT)))),
          "EN 1993-1-1 (6.56), [EN1993-1-1-LTB]");
}

/// Torsional buckling of an I section over the length between its supports against twisting; curve of z.
template <class Tracer>
void twist(const BeamColumnInput& in, const Bending& at, double partial, BeamColumnResult& r, Tracer& trace) {
  r.chi_T = 1.0;
  if (!is_I(at.kind) || !(at.N > 0.0 * kN)) return;
  const Length l_T = lateral_length(in);
  const auto A = trace.value("A", at.s.A, "area");
  const auto N_T = trace.value(
      "N_T", (in.E / 2.6 * at.s.I_t + pi * pi * in.E * at.s.I_w / (l_T * l_T)) / ((at.s.I_y + at.s.I_z) / at.s.A),
      "critical force of torsional buckling, EN 1993-1-1 6.3.1.4, [EN1993-1-1-bending]");
  STEP(lambda_T, sqrt(A * in.R_e / N_T), "EN 1993-1-1 (6.52)");
  const double alpha_T = trace.value("alpha_T", r.axes[1].alpha, "curve of buckling about z");
  STEP(Phi_T, 0.5 * (1.0 + alpha_T * (lambda_T - 0.2) + pow<2>(lambda_T)), "6.3.1.2, [EN1993-1-1-buckling]");
  STEP_TO(r, chi_T, lambda_T <= 0.2 ? 1.0 : 1.0 / (Phi_T + sqrt(pow<2>(Phi_T) - pow<2>(lambda_T))),
          "EN 1993-1-1 (6.49), [EN1993-1-1-buckling]");
  const auto N = trace.value("N", at.N, "compression, with the factor of the actions");
  const double gamma_M1 = trace.value("gamma_M1", partial, "partial factor of buckling");
  STEP_TO(r, u_T, gamma_M1 * N / (r.chi_T * A * in.R_e), "over the resistance to torsional buckling");
}

/// 6.2.9.1 of sections of class 1 and 2, [EN1993-1-1-bending]; linear for solid bars, for class 3 (6.2.9.2), and beyond
/// the plastic axial resistance.
inline double section_utilisation(const BeamColumnInput& in, const Bending& at, double n, double m_y, double m_z) {
  if (at.section_class > 2 || at.kind == SectionKind::solid || n >= 1.0) return n + m_y + m_z;
  const double A = in_si(at.s.A);
  const auto rest = [&](Length side, Length wall) {
    return std::min(0.5, std::max(0.0, 1.0 - 2.0 * in_si(side * wall) / A));
  };
  if (is_set(in.d)) return std::max(n, std::hypot(m_y, m_z) / std::min(1.0, 1.0 - std::pow(n, 1.7)));
  const Length flange = is_set(in.t_f) ? in.t_f : in.t_w;
  const double a = rest(in.b, flange), of_y = std::min(1.0, (1.0 - n) / (1.0 - 0.5 * a));
  if (is_I(at.kind)) {
    const double of_z = n <= a ? 1.0 : 1.0 - std::pow((n - a) / (1.0 - a), 2);
    return std::max(n, std::pow(m_y / of_y, 2) + std::pow(m_z / of_z, std::max(1.0, 5.0 * n)));
  }
  const double of_z = std::min(1.0, (1.0 - n) / (1.0 - 0.5 * rest(in.h, in.t_w)));
  const double power = 1.13 * n * n >= 1.0 ? 6.0 : std::min(6.0, 1.66 / (1.0 - 1.13 * n * n));
  return std::max(n, std::pow(m_y / of_y, power) + std::pow(m_z / of_z, power));
}

/// Annex B, tables B.1 and B.2.
template <class Tracer>
void annex_B(const BeamColumnInput& in, const Bending& at, double n_y, double n_z, BeamColumnResult& r, Tracer& trace) {
  constexpr double of_swaying_ends = 0.9;
  r.C_my = trace.value("C_my", sways(in, AxisName::y) ? of_swaying_ends : uniform_moment_factor(at.y),
                       "table B.3, [EN1993-1-1-bending]");
  r.C_mz = trace.value("C_mz", sways(in, AxisName::z) ? of_swaying_ends : uniform_moment_factor(at.z),
                       "table B.3, [EN1993-1-1-bending]");
  r.C_mLT = trace.value("C_mLT", is_one_segment(in) ? uniform_moment_factor(at.y) : 1.0,
                        is_one_segment(in) ? "table B.3, [EN1993-1-1-bending]" : "uniform between the supports");
  const double lambda_bar_y = trace.value("lambda_bar_y", std::min(r.axes[0].lambda_bar, 1.0), "of axis y, at most 1");
  const double lambda_bar_z = trace.value("lambda_bar_z", std::min(r.axes[1].lambda_bar, 1.0), "of axis z, at most 1");
  const bool twists = !is_hollow(at.kind) && can_turn_over(at.s) && r.chi_LT < 1.0;
  if (at.section_class > 2) {
    STEP_TO(r, k_yy, r.C_my * (1.0 + 0.6 * lambda_bar_y * n_y), "table B.1, elastic, [EN1993-1-1-bending]");
    STEP_TO(r, k_zz, r.C_mz * (1.0 + 0.6 * lambda_bar_z * n_z), "table B.1, elastic, [EN1993-1-1-bending]");
    STEP_TO(r, k_yz, k_zz, "table B.1, elastic, [EN1993-1-1-bending]");
    if (twists) {
      STEP_TO(r, k_zy, 1.0 - 0.05 * lambda_bar_z * n_z / (r.C_mLT - 0.25), "table B.2, elastic, [EN1993-1-1-bending]");
    } else {
      STEP_TO(r, k_zy, 0.8 * k_yy, "table B.1, elastic, [EN1993-1-1-bending]");
    }
    return;
  }
  STEP_TO(r, k_yy, r.C_my * (1.0 + max(lambda_bar_y - 0.2, 0.0) * n_y), "table B.1, plastic, [EN1993-1-1-bending]");
  if (is_hollow(at.kind)) {
    STEP_TO(r, k_zz, r.C_mz * (1.0 + max(lambda_bar_z - 0.2, 0.0) * n_z),
            "table B.1, hollow, plastic, [EN1993-1-1-bending]");
  } else {
    STEP_TO(r, k_zz, r.C_mz * (1.0 + max(2.0 * lambda_bar_z - 0.6, 0.0) * n_z),
            "table B.1, plastic, [EN1993-1-1-bending]");
  }
  STEP_TO(r, k_yz, 0.6 * r.k_zz, "table B.1, plastic, [EN1993-1-1-bending]");
  if (!twists) {
    STEP_TO(r, k_zy, 0.6 * k_yy, "table B.1, plastic, [EN1993-1-1-bending]");
  } else {
    STEP(k_T, 1.0 - 0.1 * lambda_bar_z * n_z / (r.C_mLT - 0.25), "table B.2, plastic, [EN1993-1-1-bending]");
    STEP_TO(r, k_zy, lambda_bar_z < 0.4 ? min(k_T, 0.6 + lambda_bar_z) : k_T,
            "table B.2, plastic, [EN1993-1-1-bending]");
  }
}

}  // namespace loadpath::column
