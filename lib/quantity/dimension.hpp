// The dimension of a run-time quantity: exponents of length, mass, time, temperature and angle.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace loadpath {

/// Exponents are kept in twelfths, so that square, cube and fourth roots stay exact.
struct Dimension {
  static constexpr int one = 12;
  enum Base { length, mass, time, temperature, angle, count };
  std::array<std::int16_t, count> twelfths{};

  constexpr bool operator==(const Dimension&) const = default;

  /// The same without the angle, for comparing expressions, so that P = M omega fits.
  [[nodiscard]] constexpr Dimension without_angle() const {
    Dimension d = *this;
    d.twelfths[angle] = 0;
    return d;
  }
  [[nodiscard]] constexpr bool is_number() const { return *this == Dimension{}; }
  [[nodiscard]] constexpr bool is_angle_or_number() const { return without_angle() == Dimension{}; }

  friend constexpr Dimension operator*(Dimension a, const Dimension& b) {
    for (std::size_t i = 0; i < count; ++i) a.twelfths[i] = static_cast<std::int16_t>(a.twelfths[i] + b.twelfths[i]);
    return a;
  }
  friend constexpr Dimension operator/(Dimension a, const Dimension& b) {
    for (std::size_t i = 0; i < count; ++i) a.twelfths[i] = static_cast<std::int16_t>(a.twelfths[i] - b.twelfths[i]);
    return a;
  }
  /// The dimension to the power numerator/denominator.
  [[nodiscard]] constexpr Dimension power(int numerator, int denominator = 1) const {
    Dimension d = *this;
    for (auto& e : d.twelfths) e = static_cast<std::int16_t>(e * numerator / denominator);
    return d;
  }
  /// Builds a dimension from integer exponents.
  static constexpr Dimension of(int l, int m, int t, int theta = 0, int a = 0) {
    Dimension d;
    d.twelfths = {static_cast<std::int16_t>(l * one), static_cast<std::int16_t>(m * one),
                  static_cast<std::int16_t>(t * one), static_cast<std::int16_t>(theta * one),
                  static_cast<std::int16_t>(a * one)};
    return d;
  }
};

/// Distinctions that a dimension does not make: absolute temperature or difference, moment or energy.
enum class Kind : std::uint8_t { plain, temperature, difference, moment, energy };

/// The dimension in words a machine designer uses ("stress", "moment"), or as a product of SI units.
std::string name_of(const Dimension& dimension);

/// The coherent SI unit as a text that parse_unit reads: "kg*m^2/s^3"; empty for a plain number.
std::string si_unit(const Dimension& dimension);

}  // namespace loadpath
