// Damage of a load spectrum by linear accumulation (Miner): [ISO6336-6]. The S-N curve of a gear goes through its
// limits at three numbers of cycles, which are those of the plain rating; each block has stresses with load factors of
// its own.
#pragma once

#include "calculators/gear/rating/iso_flank.hpp"
#include "calculators/gear/rating/iso_root.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::gear::rating {

/// Limits of one gear in MPa: static up to `few` cycles, at the knee, and at `last` cycles, below which nothing
/// damages.
struct SnCurve {
  double few = unset<double>, knee = unset<double>;
  double at_rest = unset<double>, at_knee = unset<double>, at_last = unset<double>;
  static constexpr double last = 1e10;

  template <class Limit>
  static SnCurve through(double few, double knee, const Limit& limit) {
    return {few, knee, limit(few) / MPa, limit(knee) / MPa, limit(last) / MPa};
  }
  /// Damage of n cycles of a stress; above the static limit more than 1.
  [[nodiscard]] double damage(double sigma, double n) const {
    if (!(n > 0.0) || sigma <= at_last) return 0.0;
    if (sigma > at_rest) return std::max(n / few, 1.0) * (sigma / at_rest);
    const bool is_finite = sigma > at_knee;
    const double many = is_finite ? few : last, limit = is_finite ? at_rest : at_last;
    return n / knee * std::pow(sigma / at_knee, std::log(knee / many) / std::log(limit / at_knee));
  }
};

/// The stress of a block on one gear, with the cycles of a tooth and its curve.
struct BlockStress {
  double sigma = 0.0, n = 0.0;
  SnCurve curve;
};
using BlockStresses = List<BlockStress, most_load_blocks>;

inline double damage_sum(const BlockStresses& all, double S) {
  double sum = 0.0;
  for (const BlockStress& b : all) sum += b.curve.damage(S * b.sigma, b.n);
  return sum;
}

/// The factor on all stresses that makes the damage sum 1. It lies between that at which the first block damages and
/// that at which the first reaches its static limit; the sum rises with it, in steps where a curve begins. Unset if no
/// block has a torque.
inline double factor_of_unit_damage(const BlockStresses& all) {
  double low = HUGE_VAL, high = HUGE_VAL;
  for (const BlockStress& b : all) {
    if (!(b.sigma > 0.0)) continue;
    low = std::min(low, b.curve.at_last / b.sigma), high = std::min(high, b.curve.at_rest / b.sigma);
  }
  if (high == HUGE_VAL) return unset<double>;
  if (damage_sum(all, high * (1.0 - 1e-14)) <= 1.0) return high;
  for (int i = 0; i < 60; ++i) {
    const double S = std::sqrt(low * high);
    (damage_sum(all, S) <= 1.0 ? low : high) = S;
  }
  return low;
}

inline double few_of_flank() { return 1e5; }
inline double knee_of_flank(GearMaterial material) {
  return is_nitrided(material) || material == GearMaterial::grey ? 2e6 : 5e7;
}
inline constexpr double knee_of_root = 3e6;

/// Exponents of torque in the finite life of the chart: the contact stress rises with the square root of the torque.
inline double torque_exponent_of_flank(GearMaterial material) {
  const double knee = knee_of_flank(material), most = knee < 5e7 ? 1.3 : 1.6;
  return std::log(knee / few_of_flank()) / std::log(most) / 2.0;
}
inline double torque_exponent_of_root(GearMaterial material) {
  return std::log(knee_of_root / static_cycles(material)) / std::log(static_life(material));
}

/// The four spectra of stress: flanks and roots of both gears.
struct Spectra {
  BlockStresses flank_1, flank_2, root_1, root_2;
};

/// The input of one block on its own, for its load factors.
inline Input input_of_block(const Input& in, const LoadBlock& block) {
  Input at = in;
  at.T_1 = block.k * in.T_1;
  at.f_sh_1 = block.k * in.f_sh_1, at.f_sh_2 = block.k * in.f_sh_2;
  if (is_set(block.n)) at.n_1 = block.n;
  at.blocks.clear();
  return at;
}

inline double cycles_of_block(const Input& at, const Wheel& wheel, double q) {
  return q * wheel.cycles * std::abs(in_si(at.n_1)) / (2.0 * pi) * in_si(at.L_h);
}

inline BlockStress flank_stress(const Input& at, const PairResult& g, const Wheel& wheel, const Wheel& mate, Stress lim,
                                Stress sigma, double n, const Result& r) {
  NoTrace quiet;
  return {sigma / MPa, n, SnCurve::through(few_of_flank(), knee_of_flank(wheel.material), [&](double N) {
            return flank_limit_iso(at, g, wheel, mate, lim, N, r, quiet).sigma;
          })};
}
inline BlockStress root_stress(const Input& at, const Wheel& wheel, const Form& form, Stress lim, Stress sigma,
                               double n) {
  NoTrace quiet;
  return {sigma / MPa, n, SnCurve::through(static_cycles(wheel.material), knee_of_root, [&](double N) {
            return root_limit_iso(at, wheel, form, lim, N, quiet).sigma;
          })};
}

/// Equivalent torque of all cycles by an exponent, [ISO6336-6]: every block counts, as if the finite life had no end.
inline Moment equivalent_torque(const List<BlockDamage, most_load_blocks>& blocks, double p) {
  double most = 0.0, sum = 0.0, cycles = 0.0;
  for (const BlockDamage& b : blocks) most = std::max(most, b.T / N_m);
  for (const BlockDamage& b : blocks) {
    const double turns = b.q * in_si(b.n);
    sum += turns * std::pow(b.T / N_m / most, p), cycles += turns;
  }
  return most * std::pow(sum / cycles, 1.0 / p) * N_m.one;
}

template <class Tracer>
void equivalent_torques(const Input& in, Result& r, Tracer& trace) {
  const auto of = [&](const char* symbol, double p, const char* why) {
    return trace.value(symbol, equivalent_torque(r.blocks, p), why);
  };
  constexpr auto flank =
      "mean of T to the power p over the cycles, p half the exponent of the S-N curve for pitting, [ISO6336-6]";
  constexpr auto root =
      "mean of T to the power p over the cycles, p the exponent of the S-N curve for the root, [ISO6336-6]";
  r.T_H1 = of("T_H1", torque_exponent_of_flank(in.material_1), flank);
  r.T_H2 = of("T_H2", torque_exponent_of_flank(in.material_2), flank);
  r.T_F1 = of("T_F1", torque_exponent_of_root(in.material_1), root);
  r.T_F2 = of("T_F2", torque_exponent_of_root(in.material_2), root);
  STEP_TO(r, K_AH, max(r.T_H1, r.T_H2) / abs(in.T_1), "application factor in place of the spectrum, pitting");
  STEP_TO(r, K_AF, max(r.T_F1, r.T_F2) / abs(in.T_1), "application factor in place of the spectrum, tooth root");
}

/// Damage of every block on one gear and of all, at the required safety factor; then the safety factor.
template <class Tracer>
double damage_of(const BlockStresses& all, double S_min, double BlockDamage::*D, const char* symbol, Result& r,
                 double& sum, Tracer& trace) {
  sum = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    r.blocks[i].*D = all[i].curve.damage(S_min * all[i].sigma, all[i].n);
    sum += r.blocks[i].*D;
  }
  trace.value(symbol, sum, "sum of n/N over the blocks, stresses times the required safety factor, [ISO6336-6]");
  return factor_of_unit_damage(all);
}

/// What remains of a rating: both safety factors of both gears, at which their damage sums are 1.
template <class Tracer>
void safety_by_damage(const Input& in, const Spectra& spectra, Result& r, Tracer& trace) {
  const double S_H = is_set(in.S_Hmin) ? in.S_Hmin : 1.0, S_F = is_set(in.S_Fmin) ? in.S_Fmin : 1.0;
  constexpr auto why = "factor on the stresses of all blocks that makes the damage sum 1, [ISO6336-6]";
  const auto of = [&](const BlockStresses& all, double S_min, double BlockDamage::*D, const char* symbol, double& sum,
                      const char* symbol_of_S) {
    const double S = damage_of(all, S_min, D, symbol, r, sum, trace);
    return trace.value(symbol_of_S, S, why);
  };
  const double S_H1 = r.S_H1 = of(spectra.flank_1, S_H, &BlockDamage::D_H1, "D_H1", r.D_H1, "S_H1");
  const double S_H2 = r.S_H2 = of(spectra.flank_2, S_H, &BlockDamage::D_H2, "D_H2", r.D_H2, "S_H2");
  const double S_F1 = r.S_F1 = of(spectra.root_1, S_F, &BlockDamage::D_F1, "D_F1", r.D_F1, "S_F1");
  const double S_F2 = r.S_F2 = of(spectra.root_2, S_F, &BlockDamage::D_F2, "D_F2", r.D_F2, "S_F2");
  if (is_set(in.S_Hmin)) {
    STEP_TO(r, u_H1, in.S_Hmin / S_H1, "required / calculated safety factor");
    STEP_TO(r, u_H2, in.S_Hmin / S_H2, "required / calculated safety factor");
  }
  if (is_set(in.S_Fmin)) {
    STEP_TO(r, u_F1, in.S_Fmin / S_F1, "required / calculated safety factor");
    STEP_TO(r, u_F2, in.S_Fmin / S_F2, "required / calculated safety factor");
  }
}

}  // namespace loadpath::gear::rating
