// Powers of many numbers at once, inlined into the caller, so that they use its instructions: with AVX2 and without,
// the results are the same to the bit.
#pragma once

#include "lib/simd/attributes.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

namespace loadpath::rainflow {

/// The number of values processed at once.
inline constexpr std::size_t lot = 256;
using Lot = std::array<double, lot>;

namespace power {

inline constexpr std::uint64_t mantissa = 0xfffffffffffffU, bits_of_one = 0x3ff0000000000000U;

/// The logarithm of a normal positive number: the artanh series of its mantissa between 1/sqrt(2) and sqrt(2).
LOADPATH_INLINE double log2_of(double x) {
  constexpr std::uint64_t to_root = 0x95f619980c433U;  // from sqrt(2) to 2: shifts the exponent steps to sqrt(2)
  const std::uint64_t moved = std::bit_cast<std::uint64_t>(x) + to_root;
  // Exponents as the low bits of a double of 2^52, for AVX2 converts no 64-bit integers.
  const double exponent = std::bit_cast<double>(moved >> 52U | 0x4330000000000000U) - (0x1p52 + 1023.0);
  const double m = std::bit_cast<double>((moved & mantissa) + bits_of_one - to_root);
  const double t = (m - 1.0) / (m + 1.0), z = t * t;
  double sum = 1.0 / 19.0;
  for (int k = 17; k >= 1; k -= 2) sum = sum * z + 1.0 / k;
  return exponent + 2.0 * std::numbers::log2e * t * sum;
}

/// 0 below 2^-1021, infinite from 2^1023 on.
LOADPATH_INLINE double exp2_of(double y) {
  constexpr double shift = 0x1.8p52;  // rounds to an integer, which then is in the lowest bits
  const double limited = y < -1021.0 ? -1021.0 : (y > 1023.0 ? 1023.0 : y);
  const double moved = limited + shift;
  const double z = (limited - (moved - shift)) * std::numbers::ln2;
  double sum = 1.0;
  for (int k = 13; k >= 1; --k) sum = sum * (z * (1.0 / k)) + 1.0;
  const double scale = std::bit_cast<double>((std::bit_cast<std::uint64_t>(moved) << 52U) + bits_of_one);
  const double result = sum * scale;
  return y < -1021.0 ? 0.0 : (y >= 1023.0 ? std::numeric_limits<double>::infinity() : result);
}

LOADPATH_INLINE void by_products(const Lot& x, unsigned exponent, Lot& result) {
  Lot base = x;
  for (; (exponent & 1U) == 0; exponent >>= 1U) {
    for (std::size_t i = 0; i < lot; ++i) base[i] *= base[i];
  }
  result = base;
  for (exponent >>= 1U; exponent != 0; exponent >>= 1U) {
    for (std::size_t i = 0; i < lot; ++i) base[i] *= base[i];
    if ((exponent & 1U) == 0) continue;
    for (std::size_t i = 0; i < lot; ++i) result[i] *= base[i];
  }
}

LOADPATH_INLINE void by_logarithms(const Lot& x, double exponent, Lot& result) {
  constexpr double least = std::numeric_limits<double>::min();
  for (std::size_t i = 0; i < lot; ++i) {
    const double found = exp2_of(exponent * log2_of(x[i] < least ? least : x[i]));
    result[i] = x[i] < least ? 0.0 : found;
  }
}

}  // namespace power

/// x^exponent for x >= 0 and an exponent >= 1: 0 or infinite beyond the range of numbers. By products if the exponent
/// is an integer up to 64, else by logarithms, to 1e-12 of the value for exponents up to 64.
LOADPATH_INLINE void powers(const Lot& x, double exponent, Lot& result) {
  constexpr double most_products = 64.0;
  if (exponent <= most_products && exponent == std::floor(exponent))
    power::by_products(x, static_cast<unsigned>(exponent), result);
  else
    power::by_logarithms(x, exponent, result);
}

}  // namespace loadpath::rainflow
