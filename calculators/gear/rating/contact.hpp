// Contact stress of the flanks, [DIN3990-2] or [ISO6336-2] of 2006, and what it may be.
#pragma once

#include "calculators/gear/rating/iso_flank.hpp"

namespace loadpath::gear::rating {

template <class Tracer>
void contact_factors(const Input& in, const PairResult& g, Result& r, Tracer& trace) {
  const double alpha_t = trace.angle("alpha_t", g.alpha_t, "transverse pressure angle");
  const double alpha_wt = trace.angle("alpha_wt", g.alpha_wt, "working pressure angle");
  const double eps_alpha = trace.value("eps_alpha", g.eps_alpha, "transverse contact ratio");
  const double eps_beta = trace.value("eps_beta", g.eps_beta, "overlap ratio");
  STEP(beta_b, atan(tan(in.beta) * cos(alpha_t)), "base helix angle");
  STEP_TO(r, Z_H, sqrt(2.0 * cos(beta_b) * cos(alpha_wt) / (pow<2>(cos(alpha_t)) * sin(alpha_wt))), "zone factor");
  if (in.beta == 0.0) {
    STEP_TO(r, Z_eps, sqrt((4.0 - eps_alpha) / 3.0), "contact ratio factor, spur gears");
  } else if (eps_beta < 1.0) {
    STEP_TO(r, Z_eps, sqrt((4.0 - eps_alpha) / 3.0 * (1.0 - eps_beta) + eps_beta / eps_alpha),
            "contact ratio factor, overlap below 1");
  } else {
    STEP_TO(r, Z_eps, sqrt(1.0 / eps_alpha), "contact ratio factor");
  }
  if (is_iso(in)) {
    STEP_TO(r, Z_beta, sqrt(1.0 / cos(in.beta)),
            "helix factor, [ISO6336-2] 2006, clause 9; its reciprocal in DIN 3990-2");
  } else {
    STEP_TO(r, Z_beta, sqrt(cos(in.beta)), "helix factor, [DIN3990-2]; its reciprocal in ISO 6336-2 from 2006 on");
  }
}

/// Z_B and Z_D: to the inner point of single contact of gear 1 and gear 2.
template <class Tracer>
void single_contact(const Input& in, const PairResult& g, Result& r, Tracer& trace) {
  const double alpha_wt = g.alpha_wt, eps_alpha = g.eps_alpha, eps_beta = g.eps_beta;
  const Length d_a1 = trace.value("d_a1", g.d_a1, "tip circle"), d_a2 = trace.value("d_a2", g.d_a2, "tip circle");
  const Length d_b1 = trace.value("d_b1", g.d_b1, "base circle"), d_b2 = trace.value("d_b2", g.d_b2, "base circle");
  STEP(t_a1, sqrt(pow<2>(d_a1 / d_b1) - 1.0), "tangent of the pressure angle at the tip of gear 1");
  STEP(t_a2, sqrt(pow<2>(d_a2 / d_b2) - 1.0), "tangent of the pressure angle at the tip of gear 2");
  STEP(M_1, tan(alpha_wt) / sqrt((t_a1 - 2.0 * pi / in.z_1) * (t_a2 - (eps_alpha - 1.0) * 2.0 * pi / in.z_2)),
       is_iso(in) ? "inner point of single contact of gear 1, [ISO6336-2] 2006, clause 6"
                  : "inner point of single contact of gear 1, [DIN3990-2]");
  STEP(M_2, tan(alpha_wt) / sqrt((t_a2 - 2.0 * pi / in.z_2) * (t_a1 - (eps_alpha - 1.0) * 2.0 * pi / in.z_1)),
       is_iso(in) ? "inner point of single contact of gear 2, [ISO6336-2] 2006, clause 6"
                  : "inner point of single contact of gear 2, [DIN3990-2]");
  if (eps_beta >= 1.0) {
    r.Z_B = trace.value("Z_B", 1.0, "helical gears with an overlap ratio of 1 or more");
    r.Z_D = trace.value("Z_D", 1.0, "the same");
    return;
  }
  STEP_TO(r, Z_B, max(M_1 - eps_beta * (M_1 - 1.0), 1.0), "single-pair tooth contact factor, gear 1");
  STEP_TO(r, Z_D, max(M_2 - eps_beta * (M_2 - 1.0), 1.0), "single-pair tooth contact factor, gear 2");
}

/// Z_LVR of lubricant, velocity and roughness together, [DIN3990-11].
template <class Tracer>
void flank_factor(const Input& in, const PairResult& g, Result& r, Tracer& trace) {
  if (in.finish == Finish::hobbed) {
    r.Z_LVR = trace.value("Z_LVR", 0.85, "hobbed, shaped or planed teeth, [DIN3990-11]");
    return;
  }
  const Length a_w = trace.value("a_w", g.a_w, "centre distance");
  STEP(R_z100, (in.R_z1 + in.R_z2) / 2.0 * cbrt(100.0 * mm / a_w), "mean roughness, related to 100 mm");
  const bool smooth = R_z100 <= 4.0 * um.one;
  r.Z_LVR = in.finish == Finish::mixed
                ? trace.value("Z_LVR", smooth ? 0.92 : 0.85, "one gear hobbed: 0.92 up to 4 um, [DIN3990-11]")
                : trace.value("Z_LVR", smooth ? 1.0 : 0.92, "ground or shaved: 1 up to 4 um, [DIN3990-11]");
}

/// Z_W: a soft gear that a smooth hard one work-hardens.
inline double work_hardening(const Wheel& wheel, const Wheel& mate) {
  const bool soft = !is_hardened(wheel.material) && wheel.material != GearMaterial::grey;
  if (!soft || !is_hardened(mate.material) || !(mate.R_z <= 6.0 * um.one) || !is_set(wheel.H)) return 1.0;
  const double HB = std::min(std::max(wheel.H, 130.0), 470.0);
  return 1.2 - (HB - 130.0) / 1700.0;
}

/// Z_X of large modules.
inline double size_factor_of_flank(GearMaterial material, double m) {
  if (is_nitrided(material)) return std::min(1.0, std::max(1.08 - 0.011 * m, 0.75));
  if (is_hardened(material)) return std::min(1.0, std::max(1.05 - 0.005 * m, 0.9));
  return 1.0;
}

struct Contact {
  Stress sigma = unset<Stress>, limit = unset<Stress>;
  double S = unset<double>, u = unset<double>, Z_NT = unset<double>;
};

/// The limit at the cycles of the gear: of a static load, of endurance, between them a line in logarithms.
template <class Tracer>
Stress limit_at(Stress endless, Stress at_rest, double N, double few, double many, Tracer& trace, const char* symbol) {
  if (!is_set(N) || N >= many || !(at_rest > endless))
    return trace.value(symbol, endless, "for endurance, [DIN3990-11]");
  const double e = std::log10(at_rest / endless) / std::log10(many / few);
  return trace.value(symbol, std::pow(many / std::max(N, few), e) * endless, "at the cycles of the gear, [DIN3990-11]");
}

/// Of one gear by [DIN3990-11], with the factor of lubricant, velocity and roughness together.
template <class Tracer>
LifeLimit flank_limit_din(const Input& in, const Wheel& wheel, const Wheel& mate, Stress sigma_Hlim, double N,
                          const Result& r, Tracer& trace) {
  const double Z_LVR = r.Z_LVR;
  const double Z_W = trace.value("Z_W", work_hardening(wheel, mate), "work hardening factor");
  const double Z_X = trace.value("Z_X", size_factor_of_flank(wheel.material, in.m_n / mm), "size factor");
  STEP(sigma_Hend, sigma_Hlim * Z_LVR * Z_W * Z_X, "endurance limit of the flanks");
  const bool is_short = is_nitrided(wheel.material) || wheel.material == GearMaterial::grey;
  const double Z_stat = is_short ? 1.3 : 1.6;
  return {limit_at(sigma_Hend, Z_stat * Z_W * sigma_Hlim, N, 1e5, is_short ? 2e6 : 5e7, trace, "sigma_HG")};
}

template <class Tracer>
Contact contact_of(const Input& in, const PairResult& g, const Wheel& wheel, const Wheel& mate, double Z_single,
                   Stress lim, double N, const Result& r, Tracer& trace) {
  Contact c;
  const Stress sigma_H0 = r.sigma_H0;
  const double K_V = r.K_V, K_Hbeta = r.K_Hbeta, K_Halpha = r.K_Halpha;
  trace.value("Z_BD", Z_single, "single-pair tooth contact factor of this gear");
  const double Z_BD = Z_single;
  STEP(sigma_H, Z_BD * sigma_H0 * sqrt(in.K_A * K_V * K_Hbeta * K_Halpha),
       is_iso(in) ? "contact stress, [ISO6336-2] 2006, 5.3" : "contact stress, [DIN3990-2]");
  c.sigma = trace.value(wheel.symbols.sigma_H, sigma_H, "of this gear");
  if (!in.blocks.empty()) return c;  // its limit is one of damage
  const Stress sigma_Hlim = trace.value("sigma_Hlim", lim, "allowable stress number of this gear");
  const LifeLimit limit = is_iso(in) ? flank_limit_iso(in, g, wheel, mate, sigma_Hlim, N, r, trace)
                                     : flank_limit_din(in, wheel, mate, sigma_Hlim, N, r, trace);
  const Stress sigma_HG = limit.sigma;
  c.Z_NT = limit.factor;
  c.limit = trace.value(wheel.symbols.sigma_HG, sigma_HG, "of this gear");
  const double S_H = c.S =
      NAMED_STEP(wheel.symbols.S_H, sigma_HG / sigma_H, "calculated safety factor against pitting");
  trace.value("S_H", S_H, "this safety factor");
  if (is_set(in.S_Hmin)) c.u = NAMED_STEP(wheel.symbols.u_H, in.S_Hmin / S_H, "required / calculated safety factor");
  return c;
}

}  // namespace loadpath::gear::rating
