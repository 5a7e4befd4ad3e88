// Bounds by the material: allowable stresses must not exceed its strength, and fatigue limits are bounded by its
// tensile strength. A calculator marks such inputs with a Meaning; lib/project compares. Usual properties of metals.
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

/// GPa: usual moduli of metals. Magnesium has 45 and 17, steels up to 220 and 85; plastics, timber and cemented
/// carbides lie outside.
inline constexpr double least_E = 40.0, most_E = 230.0, least_G = 15.0, most_G = 90.0;
/// MPa: spring steels and hardened pins; wires and maraging steels lie outside.
inline constexpr double most_yield_strength = 1400.0, most_tensile_strength = 1800.0;

/// At most `part` of the strength in `column`; of a material without it, at most `part` of another strength.
struct StrengthBound {
  struct Share {
    const char* column;
    double part;
    const char* text;  // name of the bound, in messages
  };
  const char* meaning;
  Share share, otherwise;
};

/// Yield in shear by the distortion-energy theory. Fatigue limits of steels are 0.4 to 0.6 R_m in bending, and less
/// in tension (recalled); above 0.9 R_e only those of soft steels, whose R_m is 1.5 R_e and more.
inline constexpr double shear_over_normal = 0.57735026918962576;
inline constexpr double most_fatigue_limit = 0.6, most_limit_of_yield = 0.9;
inline constexpr StrengthBound::Share of_tensile{"R_m", 1.0, "R_m"};
inline constexpr StrengthBound::Share of_limit{"R_m", most_fatigue_limit, "0.6 R_m"};
inline constexpr StrengthBound::Share of_limit_in_shear{"R_m", most_fatigue_limit* shear_over_normal,
                                                        "0.6 R_m/sqrt(3)"};
inline constexpr StrengthBound::Share of_yield{"R_e", most_limit_of_yield, "0.9 R_e"};
inline constexpr StrengthBound::Share of_yield_in_shear{"R_e", most_limit_of_yield* shear_over_normal,
                                                        "0.9 R_e/sqrt(3)"};
inline constexpr std::array strength_bounds{
    StrengthBound{yield_strength, {"R_e", 1.0, "R_e"}, of_tensile},
    StrengthBound{allowable_in_normal, {"R_e", 1.0, "R_e"}, of_tensile},
    StrengthBound{allowable_in_shear, {"R_e", shear_over_normal, "R_e/sqrt(3)"}, of_tensile},
    StrengthBound{crushing_stress, of_tensile, of_tensile},
    StrengthBound{limit_in_normal, of_limit, of_yield},
    StrengthBound{limit_in_shear, of_limit_in_shear, of_yield_in_shear},
    StrengthBound{specimen_in_bending, of_limit, of_yield},
    StrengthBound{specimen_in_tension, of_limit, of_yield},
    StrengthBound{mean_strength, of_limit, of_yield},
    StrengthBound{specimen_in_torsion, of_limit_in_shear, of_yield_in_shear}};

/// Names of a strength of the material in calculators that follow a standard with other symbols.
constexpr std::array<const char*, 3> symbols_of_strength(std::string_view column) {
  using Symbols = std::array<const char*, 3>;
  return column == "R_m" ? Symbols{"R_m", "sigma_B", "R_mN"} : Symbols{"R_e", "sigma_S", "R_eN"};
}

/// The bound of a meaning; null if it has none.
constexpr const StrengthBound* strength_bound_of(std::string_view meaning) {
  for (const StrengthBound& bound : strength_bounds) {
    if (meaning == bound.meaning) return &bound;
  }
  return nullptr;
}

/// The least safety factor that an allowable stress includes.
inline constexpr double least_margin = 1.1;

/// An allowable stress takes any strength: its designer has decided.
constexpr bool is_allowable(std::string_view meaning) {
  return meaning == allowable_in_normal || meaning == allowable_in_shear;
}

}  // namespace loadpath
