// Random numbers that are a function of their place: Philox4x32 with ten rounds of Random123 (Salmon et al., SC11).
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

namespace loadpath::sweep {

/// The purpose of random numbers: another use of the same seed gives others.
enum class Purpose : std::uint32_t { samples, strata, triangle, shift, search };

/// The middle of one of 2^52 parts of (0, 1), by the upper bits: they make a number between 1 and 2. There is no
/// rounding.
inline double unit(std::uint64_t bits) {
  return std::bit_cast<double>((bits >> 12) | 0x3ff0000000000000) - (1.0 - 0x1p-53);
}

/// 128 random bits of a place; variables are below 2^32.
std::array<std::uint64_t, 2> random_bits(std::uint64_t seed, std::uint64_t index, std::uint64_t variable,
                                         Purpose purpose);

/// A number of 0 < u < 1 for a variable of a point.
double uniform(std::uint64_t seed, std::uint64_t index, std::uint64_t variable, Purpose purpose = Purpose::samples);

/// The same to the bit for the points first, first + 1... of a column.
void uniform(std::uint64_t seed, std::uint64_t first, std::uint64_t variable, std::span<double> column,
             Purpose purpose = Purpose::samples);

}  // namespace loadpath::sweep
