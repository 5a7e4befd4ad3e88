// Meanings of the fatigue limits and notch factors of different loadings, so that they are not interchanged.
#pragma once

#include "lib/calculator/meaning.hpp"
#include "lib/calculator/strength_bounds.hpp"

namespace loadpath::fatigue {

using loadpath::limit_in_normal;
using loadpath::limit_in_shear;
using loadpath::specimen_in_bending;
using loadpath::specimen_in_tension;
using loadpath::specimen_in_torsion;
/// Limits of metals without a fatigue limit; the two governing choices are "loading, group", joined by "/".
inline constexpr auto strength_in_normal = "a fatigue strength at some number of cycles, of a metal without a limit";
inline constexpr auto strength_in_shear = "the same in shear: a fatigue strength at some number of cycles";
inline constexpr auto factor_in_normal = "a factor between specimen and part in normal stresses";
inline constexpr auto notch_in_tension = "a stress concentration factor in tension";
inline constexpr auto notch_in_bending = "a stress concentration factor in bending";
inline constexpr auto notch_in_torsion = "a stress concentration factor in torsion";
inline constexpr auto factor_in_shear = "a factor between specimen and part in shear";

}  // namespace loadpath::fatigue
