// Bounds by the material: allowable stresses must not exceed its strength, and fatigue limits are bounded by its
// tensile strength. A calculator marks such inputs with a Meaning; lib/project compares.
#pragma once

#include <array>
#include <string_view>

namespace loadpath {

inline constexpr auto allowable_in_normal = "an allowable normal stress";
inline constexpr auto allowable_in_shear = "an allowable shear stress";

inline constexpr auto yield_strength = "a yield strength of the material";
inline constexpr auto crushing_stress = "a crushing stress";

inline constexpr auto limit_in_normal = "a fatigue limit of a part in normal stresses";
inline constexpr auto limit_in_shear = "a fatigue limit of a part in shear";
inline constexpr auto specimen_in_bending = "a fatigue limit of smooth specimens in bending";
inline constexpr auto specimen_in_tension = "a fatigue limit of smooth specimens in tension and compression";
inline constexpr auto specimen_in_torsion = "a fatigue limit of smooth specimens in torsion";
inline constexpr auto mean_strength = "a mean fatigue strength (50 % survival)";

/// At most `part` of the strength in `column`; if a material lacks that, at most its R_m.
struct StrengthBound {
  const char* meaning;
  const char* column;
  double part;
  const char* text;  // name of the bound, in messages
};

/// Yield in shear by the distortion energy hypothesis; 0.7 R_m is above the limit of any steel in bending (recalled:
/// 0.4 to 0.6 R_m).
inline constexpr double shear_over_normal = 0.57735026918962576;
inline constexpr double most_fatigue_limit = 0.7;
inline constexpr std::array strength_bounds{
    StrengthBound{yield_strength, "R_e", 1.0, "R_e"},
    StrengthBound{allowable_in_normal, "R_e", 1.0, "R_e"},
    StrengthBound{allowable_in_shear, "R_e", shear_over_normal, "R_e/sqrt(3)"},
    StrengthBound{crushing_stress, "R_m", 1.0, "R_m"},
    StrengthBound{limit_in_normal, "R_m", most_fatigue_limit, "0.7 R_m"},
    StrengthBound{limit_in_shear, "R_m", most_fatigue_limit* shear_over_normal, "0.7 R_m/sqrt(3)"},
    StrengthBound{specimen_in_bending, "R_m", most_fatigue_limit, "0.7 R_m"},
    StrengthBound{specimen_in_tension, "R_m", most_fatigue_limit, "0.7 R_m"},
    StrengthBound{mean_strength, "R_m", most_fatigue_limit, "0.7 R_m"},
    StrengthBound{specimen_in_torsion, "R_m", most_fatigue_limit* shear_over_normal, "0.7 R_m/sqrt(3)"}};

/// The bound of a meaning; null if it has none.
constexpr const StrengthBound* strength_bound_of(std::string_view meaning) {
  for (const StrengthBound& bound : strength_bounds) {
    if (meaning == bound.meaning) return &bound;
  }
  return nullptr;
}

/// An allowable stress takes any strength: its designer has decided.
constexpr bool is_allowable(std::string_view meaning) {
  return meaning == allowable_in_normal || meaning == allowable_in_shear;
}

}  // namespace loadpath
