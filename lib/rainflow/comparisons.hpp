// The comparisons that counting spends its time on, 64 at once as the bits of a word: by AVX2 where the machine has it,
// else one by one, with the same bits.
#pragma once

#include <cstddef>
#include <cstdint>

namespace loadpath::rainflow {

/// Instructions to use; avx2 only if best_instructions() is that.
enum class Instructions { portable, avx2 };

/// The best instructions of this CPU.
Instructions best_instructions();

/// The maximum value for counting: its ranges are finite.
inline constexpr double largest_value = 8e307;

/// The changes from 64 samples to the next one each.
struct Moves {
  std::uint64_t rising = 0, level = 0;
  bool sound = false;  // all are finite and at most `largest_value`; otherwise the bits are meaningless
};

/// Bit k of word w: the change from x[64 w + k] to x[64 w + k + 1]. x contains 64 * words + 1 values, of which the
/// first is sound.
void compare_neighbours(const double* x, std::size_t words, Moves* moves, Instructions instructions);

/// Bit k of word w, i = 64 w + k: range i + 1, from x[i + 1] to x[i + 2], is smaller than range i before it. x rises
/// and falls in turn, rising first or not, and holds 64 * words + 2 values, of which the last may be anything.
void compare_ranges(const double* x, std::size_t words, std::uint64_t* smaller, bool rising_first,
                    Instructions instructions);

}  // namespace loadpath::rainflow
