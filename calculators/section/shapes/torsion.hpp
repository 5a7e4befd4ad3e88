// Torsion constants of non-circular sections: what several sections and their tests share.
#pragma once

#include "calculators/section/properties/properties.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/mode.hpp"

#include <cmath>

namespace loadpath::section {

/// The factors of a rectangle of sides a >= b: I_t = k_1 a b^3, W_t = k_2 a b^2. Saint-Venant's series, exact to the
/// last digits: the part of it that falls off slowly is summed in closed form.
struct RectangleFactors {
  double k_1, k_2;
};

inline RectangleFactors rectangle_factors(double a_over_b) {
  constexpr double odd_fifth_powers = 1.0045237627951385;  // 1 + 1/3^5 + 1/5^5 + ...
  const double pi2 = pi * pi;
  constexpr double negligible = 1e-18;
  const double first = std::exp(-0.5 * pi * a_over_b), square = first * first;
  double tanhs = odd_fifth_powers, sechs = 0.0, power = first;  // exp(-n pi a/(2 b))
  for (int n = 1; n < 16 && power > negligible; n += 2, power *= square) {
    const double n2 = static_cast<double>(n) * n, e = power * power;
    tanhs -= 2.0 * e / (1.0 + e) / (n2 * n2 * n);
    sechs += 2.0 * power / (1.0 + e) / n2;
  }
  const double k_1 = (1.0 - 192.0 / (pi2 * pi2 * pi * a_over_b) * tanhs) / 3.0;
  return {k_1, k_1 / (1.0 - 8.0 / pi2 * sechs)};
}

/// How thick walls may be for the formulas of thin ones: over the shortest straight part of an open section, and over
/// the shorter middle line of a closed one (the thickest of EN 10210-2).
inline constexpr double thickest_open_wall = 0.25, thickest_closed_wall = 0.25;

/// Sections judge nothing but where their torsion constant holds.
template <class Input>
constexpr Mode<Input> torsion_mode(const char* limits) {
  return Mode<Input>{"torsion", "applicability of the torsion constant", &always<Input>}.judged_by(limits).of_shape();
}

/// The properties of a section whose torsion constant is valid for thin open walls only.
struct OpenWalls : Properties {
  double w = unset<double>;
};
inline constexpr auto results_of_open_walls = join(
    property_fields<OpenWalls>(),
    Fields{Field{&OpenWalls::w, "w", ratio, "thickest wall over the shortest part, for the torsion of thin open walls"}
               .limit(0, thickest_open_wall)});

/// Proportions of rolled I sections, web and fillet over flange thickness: IPE, HEA, HEB and HEM have 0.51 to 0.74 and
/// 0.54 to 1.93, and the torsion constant agrees with their tables within 4.3 %; without fillets it runs on smoothly.
struct RangesOfI {
  double least_web, most_web, most_fillet;

  [[nodiscard]] constexpr bool hold(double web, double fillet) const {
    return least_web <= web && web <= most_web && fillet <= most_fillet;
  }
};
inline constexpr RangesOfI ranges_of_I{0.4, 1.0, 2.0};

}  // namespace loadpath::section
