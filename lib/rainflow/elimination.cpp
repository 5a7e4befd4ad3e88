#include "lib/rainflow/elimination.hpp"

#include "lib/rainflow/bits.hpp"

#include <algorithm>

namespace loadpath::rainflow {

namespace {

constexpr std::size_t bits = 64;
constexpr std::uint64_t all = ~std::uint64_t{0};

std::size_t words_of(std::size_t count) { return (count + bits - 1) / bits; }

}  // namespace

Elimination::Elimination(std::size_t largest, Instructions instructions)
    : instructions_(instructions), smaller_(words_of(largest) + 1), closed_(largest / 2 + 4) {}

std::size_t Elimination::pass(double* points, std::size_t count) {
  const std::size_t words = words_of(count), known = count - 2;  // bit i is of ranges i and i + 1
  std::fill(points + count, points + bits * words + 2, 0.0);
  compare_ranges(points, words, smaller_.data(), points[0] < points[1], instructions_);
  // Beyond the end all are marked as smaller, so that nothing is eliminated before its successors are known.
  smaller_[words] = all;
  smaller_[known / bits] |= all << (known % bits);
  if (known / bits + 1 < words) smaller_[known / bits + 1] = all;

  std::size_t left = 0;
  std::uint64_t carried = 0;  // points that go with a range of the word before
  for (std::size_t w = 0; w < words; ++w) {
    double* const x = points + bits * w;
    const std::uint64_t closing = smaller_[w] & ~(smaller_[w] >> 1U | smaller_[w + 1] << (bits - 1));
    Loop* const closed = closed_.data() + closed_count_;
    closed_count_ += put_places(closing, [&](std::size_t i, std::size_t k) { closed[i] = {x[k + 1], x[k + 2]}; });
    std::uint64_t staying = ~(closing << 1U | closing << 2U | carried);
    carried = closing >> (bits - 1) | closing >> (bits - 2);
    if (w + 1 == words && count % bits != 0) staying &= ~(all << (count % bits));
    double* const stay = points + left;
    left += put_places(staying, [&](std::size_t i, std::size_t k) { stay[i] = x[k]; });
  }
  return left;
}

std::size_t Elimination::reduce(double* points, std::size_t count) {
  // For independent peaks a pass leaves a third; the remainder after ten passes, or after one that removes little, is
  // for a stack.
  constexpr int most_passes = 10;
  constexpr std::size_t fewest_points = 128, smallest_share = 8;
  closed_count_ = 0;
  for (int passes = 0; passes < most_passes && count >= fewest_points; ++passes) {
    const std::size_t left = pass(points, count);
    const bool little = (count - left) * smallest_share < count;
    count = left;
    if (little) break;
  }
  return count;
}

}  // namespace loadpath::rainflow
