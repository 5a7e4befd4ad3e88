// How mean stresses count in a history, and the strengths that their rules need.
#pragma once

#include "calculators/fatigue/history/types.hpp"
#include "calculators/fatigue/tensile_strength.hpp"

#include <array>

namespace loadpath::fatigue {

/// The rule that is chosen; without one any, for it is not asked.
inline MeanRule rule_of(const HistoryTypes::Input& in) {
  constexpr std::array rules{MeanRule::goodman, MeanRule::soderberg, MeanRule::gerber, MeanRule::elliptic,
                             MeanRule::morrow,  MeanRule::swt,       MeanRule::walker, MeanRule::fkm};
  return in.mean == HistoryTypes::Means::none ? MeanRule::swt : rules[static_cast<std::size_t>(in.mean) - 1];
}
inline bool counts_means(const HistoryTypes::Input& in) {
  return HistoryTypes::is_of_part(in) && in.mean != HistoryTypes::Means::none;
}

/// Shear has its own strengths.
inline Haigh haigh_of(const HistoryTypes::Input& in) {
  Haigh h;
  NoTrace quiet;
  const bool shear = in.stress == Stresses::shear;
  h.R_m = shear ? tensile_in_shear(in.R_m, quiet) : in.R_m;
  h.R_e = shear ? yield_in_shear(in.R_e, quiet) : in.R_e;
  h.sigma_f = in.sigma_f, h.gamma = in.gamma, h.M = in.M;
  return h;
}

}  // namespace loadpath::fatigue
