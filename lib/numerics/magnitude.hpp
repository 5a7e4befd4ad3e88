// Comparing magnitudes.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace loadpath::numerics {

/// The larger magnitude; NaN propagates.
inline double larger_magnitude(double most, double x) {
  return std::isnan(most) || std::abs(x) <= most ? most : std::abs(x);
}

/// Rounded to 30 bits, nine digits.
inline double nine_digits(double x) {
  constexpr std::uint64_t half = std::uint64_t{1} << 22U;
  if (!std::isfinite(x)) return x;
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(x) + half) & ~(2U * half - 1U));
}

/// Whether a is larger than b in nine digits; sorts may use it. The first value that none exceeds is the one that
/// governs: the last bits, in which the C library's functions differ from CPU to CPU, do not choose between values
/// equal by symmetry.
inline bool exceeds(double a, double b) { return a > b && nine_digits(a) > nine_digits(b); }

}  // namespace loadpath::numerics
