#include "lib/rainflow/comparisons.hpp"

#include "lib/simd/attributes.hpp"

#include <cmath>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace loadpath::rainflow {

namespace {

constexpr std::size_t bits = 64;
constexpr std::uint64_t even = 0x5555555555555555U;

Moves moves_of(const double* x) {
  std::uint64_t rising = 0, falling = 0, unsound = 0;
  for (std::size_t k = 0; k < bits; ++k) {
    rising |= static_cast<std::uint64_t>(x[k] < x[k + 1]) << k;
    falling |= static_cast<std::uint64_t>(x[k] > x[k + 1]) << k;
    unsound |= static_cast<std::uint64_t>(!(std::abs(x[k + 1]) <= largest_value));
  }
  return {rising, ~(rising | falling), unsound == 0};
}

std::uint64_t smaller_ranges(const double* x, std::uint64_t rising) {
  std::uint64_t below = 0, above = 0;
  for (std::size_t k = 0; k < bits; ++k) {
    below |= static_cast<std::uint64_t>(x[k + 2] < x[k]) << k;
    above |= static_cast<std::uint64_t>(x[k + 2] > x[k]) << k;
  }
  // Range i rises: the next one falls, and is smaller where it ends above the start of range i.
  return (above & rising) | (below & ~rising);
}

#if defined(__x86_64__)

/// For a word with equal neighbours or NaN.
LOADPATH_AVX2 void look_closely(const double* x, Moves& moves) {
  __m256d missing = _mm256_setzero_pd();
  for (std::size_t k = 0; k < bits; k += 4) {
    const __m256d here = _mm256_loadu_pd(x + k), next = _mm256_loadu_pd(x + k + 1);
    const auto level = static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(here, next, _CMP_EQ_OQ)));
    moves.level |= static_cast<std::uint64_t>(level) << k;
    missing = _mm256_or_pd(missing, _mm256_cmp_pd(next, next, _CMP_UNORD_Q));
  }
  moves.sound = moves.sound && _mm256_movemask_pd(missing) == 0;
}

LOADPATH_AVX2 void compare_neighbours_avx2(const double* x, std::size_t words, Moves* moves) {
  const __m256d size = _mm256_castsi256_pd(_mm256_set1_epi64x(0x7fffffffffffffff));
  for (std::size_t w = 0; w < words; ++w, x += bits) {
    std::uint64_t rising = 0;
    __m256d level = _mm256_setzero_pd(), largest = _mm256_setzero_pd();
    for (std::size_t k = 0; k < bits; k += 4) {
      const __m256d here = _mm256_loadu_pd(x + k), next = _mm256_loadu_pd(x + k + 1);
      const auto up = static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(here, next, _CMP_LT_OQ)));
      rising |= static_cast<std::uint64_t>(up) << k;
      level = _mm256_or_pd(level, _mm256_cmp_pd(here, next, _CMP_EQ_UQ));  // or one of them is NaN
      largest = _mm256_max_pd(_mm256_and_pd(next, size), largest);         // skipped here
    }
    const __m256d too_large = _mm256_cmp_pd(largest, _mm256_set1_pd(largest_value), _CMP_GT_OQ);
    moves[w] = {rising, 0, _mm256_movemask_pd(too_large) == 0};
    if (_mm256_movemask_pd(level) != 0) look_closely(x, moves[w]);
  }
}

LOADPATH_AVX2 void compare_ranges_avx2(const double* x, std::size_t words, std::uint64_t* smaller,
                                       std::uint64_t rising) {
  for (std::size_t w = 0; w < words; ++w, x += bits) {
    std::uint64_t below = 0, above = 0;
    for (std::size_t k = 0; k < bits; k += 4) {
      const __m256d first = _mm256_loadu_pd(x + k), last = _mm256_loadu_pd(x + k + 2);
      const auto down = static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(last, first, _CMP_LT_OQ)));
      const auto up = static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(last, first, _CMP_GT_OQ)));
      below |= static_cast<std::uint64_t>(down) << k;
      above |= static_cast<std::uint64_t>(up) << k;
    }
    smaller[w] = (above & rising) | (below & ~rising);
  }
}

#endif

}  // namespace

Instructions best_instructions() {
#if defined(__x86_64__)
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  if (has_avx2) return Instructions::avx2;
#endif
  return Instructions::portable;
}

void compare_neighbours(const double* x, std::size_t words, Moves* moves, Instructions instructions) {
#if defined(__x86_64__)
  if (instructions == Instructions::avx2) return compare_neighbours_avx2(x, words, moves);
#endif
  for (std::size_t w = 0; w < words; ++w) moves[w] = moves_of(x + bits * w);
}

void compare_ranges(const double* x, std::size_t words, std::uint64_t* smaller, bool rising_first,
                    Instructions instructions) {
  const std::uint64_t rising = rising_first ? even : ~even;
#if defined(__x86_64__)
  if (instructions == Instructions::avx2) return compare_ranges_avx2(x, words, smaller, rising);
#endif
  for (std::size_t w = 0; w < words; ++w) smaller[w] = smaller_ranges(x + bits * w, rising);
}

}  // namespace loadpath::rainflow
