// Permissible contact stress of [ISO6336-2], edition 2006, method B: lubricant film, work hardening, life; as restated
// in [IACS-M56].
#pragma once

#include "calculators/gear/rating/wheels.hpp"

namespace loadpath::gear::rating {

inline bool is_iso(const Input& in) { return in.standard == RatingStandard::iso6336; }

/// Z_L, Z_v and Z_R, by the softer of both materials.
template <class Tracer>
void lubricant_film(const Input& in, const PairResult& g, Stress softer, Result& r, Tracer& trace) {
  const double alpha_wt = g.alpha_wt;
  const double sigma_s = trace.value("sigma_s", softer / MPa, "allowable stress number of the softer gear, MPa");
  const double nu_o = trace.value("nu_o", in.nu_40 / mm2_per_s, "viscosity of the oil at 40 °C, mm^2/s");
  STEP(C_ZL, 0.83 + 0.08 * min(max((sigma_s - 850.0) / 350.0, 0.0), 1.0), "constant, [ISO6336-2] 2006, clause 12");
  STEP_TO(r, Z_L, C_ZL + 4.0 * (1.0 - C_ZL) / pow<2>(1.2 + 134.0 / nu_o),
          "lubricant factor, [ISO6336-2] 2006, clause 12");
  STEP(C_Zv, C_ZL + 0.02, "constant, [ISO6336-2] 2006, clause 12");
  STEP_TO(r, Z_v, C_Zv + 2.0 * (1.0 - C_Zv) / sqrt(0.8 + 32.0 / (r.v / m_per_s)),
          "velocity factor, [ISO6336-2] 2006, clause 12");
  const Length d_b1 = trace.value("d_b1", g.d_b1, "base circle"), d_b2 = trace.value("d_b2", g.d_b2, "base circle");
  STEP(rho_1, 0.5 * d_b1 * tan(alpha_wt), "radius of the flank of gear 1 at the pitch point");
  STEP(rho_2, 0.5 * d_b2 * tan(alpha_wt), "radius of the flank of gear 2 at the pitch point");
  STEP(rho_red, rho_1 * rho_2 / (rho_1 + rho_2), "radius of relative curvature");
  STEP(R_z10, (in.R_z1 + in.R_z2) / 2.0 * cbrt(10.0 * mm / rho_red), "mean roughness, related to a radius of 10 mm");
  STEP(C_ZR, min(max(0.32 - 0.0002 * sigma_s, 0.08), 0.15), "constant, [ISO6336-2] 2006, clause 12");
  STEP_TO(r, Z_R, pow(3.0 * um / R_z10, C_ZR), "roughness factor, [ISO6336-2] 2006, clause 12");
  STEP_TO(r, Z_LVR, Z_L * Z_v * Z_R, "lubricant film in all");
}

/// Equivalent roughness of a hard gear on a soft one, um, from 3 to 16.
inline double equivalent_roughness(const Input& in, const PairResult& g, const Wheel& soft, const Wheel& hard,
                                   Speed v) {
  const double rho_1 = 0.5 * (g.d_b1 / mm) * std::tan(g.alpha_wt), rho_2 = 0.5 * (g.d_b2 / mm) * std::tan(g.alpha_wt);
  const double rho_red = rho_1 * rho_2 / (rho_1 + rho_2);
  const double film = std::pow(v / m_per_s * (in.nu_40 / mm2_per_s) / 1500.0, 0.33);
  const double R_z = hard.R_z / um * std::pow(10.0 / rho_red, 0.33) * std::pow(hard.R_z / soft.R_z, 0.66) / film;
  return std::min(std::max(R_z, 3.0), 16.0);
}

inline bool is_through_hardened(GearMaterial m) {
  return m == GearMaterial::through_carbon || m == GearMaterial::through_alloy;
}

/// Z_W of a soft gear on a surface-hardened one, and of a through-hardened wheel on a harder pinion; 1 at least.
inline double work_hardening_iso(const Input& in, const PairResult& g, const Wheel& wheel, const Wheel& mate, Speed v) {
  if (!is_set(wheel.H) || is_hardened(wheel.material) || wheel.material == GearMaterial::grey) return 1.0;
  if (is_hardened(mate.material)) {
    const double HB = std::min(std::max(wheel.H, 130.0), 470.0);
    const double smooth = std::pow(3.0 / equivalent_roughness(in, g, wheel, mate, v), 0.15);
    return std::max(1.0, (1.2 - (HB - 130.0) / 1700.0) * smooth);
  }
  const bool both = is_through_hardened(wheel.material) && is_through_hardened(mate.material);
  if (!both || !is_set(mate.H) || wheel.z < mate.z) return 1.0;
  const double harder = std::min(mate.H / wheel.H, 1.7), u = std::min(wheel.z / mate.z, 20.0);
  return harder < 1.2 ? 1.0 : std::max(1.0, 1.0 + (0.00898 * harder - 0.00829) * (u - 1.0));
}

/// Z_NT or Y_NT beyond the knee: down to 0.85 at 1e10 cycles, the lower limit of the standard; so without a life.
inline double beyond_knee(double N, double knee) {
  constexpr double last = 1e10, least = 0.85;
  if (!is_set(N) || N >= last) return least;
  return N <= knee ? 1.0 : std::pow(least, std::log(N / knee) / std::log(last / knee));
}

/// A limit at the cycles of a gear, with its life factor where the standard has one.
struct LifeLimit {
  Stress sigma = unset<Stress>;
  double factor = unset<double>;
};

/// Permissible contact stress of one gear with S_Hmin of 1. At rest the film and work hardening count for nothing.
template <class Tracer>
LifeLimit flank_limit_iso(const Input& in, const PairResult& g, const Wheel& wheel, const Wheel& mate,
                          Stress sigma_Hlim, double N, const Result& r, Tracer& trace) {
  const double Z_L = r.Z_L, Z_v = r.Z_v, Z_R = r.Z_R;
  const double Z_W = trace.value("Z_W", work_hardening_iso(in, g, wheel, mate, r.v),
                                 "work hardening factor, [ISO6336-2] 2006, clause 13");
  const double Z_X = trace.value("Z_X", 1.0, "size factor, [ISO6336-2] 2006, clause 14");
  const bool is_short = is_nitrided(wheel.material) || wheel.material == GearMaterial::grey;
  const double knee = is_short ? 2e6 : 5e7, few = 1e5, most = is_short ? 1.3 : 1.6;
  STEP(sigma_Href, sigma_Hlim * Z_L * Z_v * Z_R * Z_W * Z_X, "reference stress of the flanks");
  double life = beyond_knee(N, knee);
  if (is_set(N) && N < knee) {
    const double rise = most * (sigma_Hlim / sigma_Href);
    life = std::pow(std::max(1.0, rise), std::log(knee / std::max(N, few)) / std::log(knee / few));
  }
  const double Z_NT = trace.value(wheel.symbols.Z_NT, life,
                                  is_set(N) ? "life factor at the cycles of the gear, [ISO6336-2] 2006, clause 11"
                                            : "life factor of 1e10 cycles, no life given, [ISO6336-2] 2006, clause 11");
  trace.value("Z_NT", Z_NT, "of this gear");
  STEP(sigma_HG, sigma_Href * Z_NT, "pitting stress limit, [ISO6336-2] 2006, 5.4");
  return {sigma_HG, Z_NT};
}

}  // namespace loadpath::gear::rating
