// Uniform numbers for tests, as a function of their place.
#pragma once

#include "lib/sweep/sensitivity/sampler.hpp"

#include <cmath>

namespace loadpath::sweep::testing {

/// SplitMix64 (Steele, Lea, Flood 2014, as recalled).
inline std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

inline double uniform_at(std::uint64_t seed, std::uint64_t index, std::uint64_t column) {
  return (static_cast<double>(mixed(mixed(mixed(seed) ^ index) ^ column) >> 12) + 0.5) * 0x1p-52;
}

/// Uniform from `from` to `to` in every column.
inline Sampler uniform_samples(std::uint64_t seed, double from = 0.0, double to = 1.0) {
  return [=](std::uint64_t first, std::size_t n, std::span<double* const> columns) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      for (std::size_t k = 0; k < n; ++k) columns[i][k] = std::lerp(from, to, uniform_at(seed, first + k, i));
    }
  };
}

}  // namespace loadpath::sweep::testing
