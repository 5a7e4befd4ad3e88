// Usual properties of engineering metals.
#pragma once

namespace loadpath {

/// GPa: magnesium 45 and 17, steels up to 220 and 85; plastics, timber and cemented carbides lie outside.
inline constexpr double least_E = 40.0, most_E = 230.0, least_G = 15.0, most_G = 90.0;

/// MPa: spring steels and hardened pins; wires and maraging steels lie outside.
inline constexpr double most_yield_strength = 1400.0, most_tensile_strength = 1800.0;

}  // namespace loadpath
