// The places of the bits of a word, four at once: a loop that ends at the last bit is guessed wrongly at its end.
#pragma once

#include "lib/simd/attributes.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>

namespace loadpath::rainflow {

/// Calls put(i, place) for i = 0, 1, ... with the place of each bit of `word`, the lowest first, and returns their
/// number. Up to three additional calls follow, with places of the word, whose results are to be overwritten.
template <class Put>
LOADPATH_INLINE std::size_t put_places(std::uint64_t word, const Put& put) {
  constexpr std::uint64_t last = std::uint64_t{1} << 63U;  // ensures a lowest bit
  const auto count = static_cast<std::size_t>(std::popcount(word));
  for (std::size_t i = 0; i < count; i += 4) {
    for (std::size_t k = i; k < i + 4; ++k, word &= word - 1)
      put(k, static_cast<std::size_t>(std::countr_zero(word | last)));
  }
  return count;
}

}  // namespace loadpath::rainflow
