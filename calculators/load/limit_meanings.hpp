// What the fatigue limits and notch factors of different loadings are, so that none is taken for another.
#pragma once

#include "lib/calculator/meaning.hpp"

namespace loadpath::fatigue {

inline constexpr auto limit_in_normal = "a fatigue limit of a part in normal stresses";
inline constexpr auto limit_in_shear = "a fatigue limit of a part in shear";
inline constexpr auto specimen_in_bending = "a fatigue limit of smooth specimens in bending";
inline constexpr auto specimen_in_tension = "a fatigue limit of smooth specimens in tension and compression";
inline constexpr auto specimen_in_torsion = "a fatigue limit of smooth specimens in torsion";
inline constexpr auto factor_in_normal = "a factor between specimen and part in normal stresses";
inline constexpr auto factor_in_shear = "a factor between specimen and part in shear";

}  // namespace loadpath::fatigue
