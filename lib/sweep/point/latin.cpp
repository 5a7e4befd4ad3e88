#include "lib/sweep/point/latin.hpp"

#include "lib/sweep/point/uniform.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace loadpath::sweep {

namespace {

/// The finaliser of splitmix64 (Steele, Lea and Flood 2014): every bit of the result depends on every bit of x.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

}  // namespace

Permutation::Permutation(std::uint64_t size, std::uint64_t seed, std::uint64_t variable, std::uint64_t cube)
    : size_(size), half_(std::max(1U, (static_cast<unsigned>(std::bit_width(size - 1)) + 1) / 2)) {
  const auto bits = random_bits(seed, cube, variable, Purpose::strata);
  for (std::size_t round = 0; round < keys_.size(); ++round) keys_[round] = mixed(bits[round % 2] + round);
}

/// Feistel's network: four rounds permute the numbers of 2 half_ bits (Luby and Rackoff 1988).
std::uint64_t Permutation::shuffle(std::uint64_t i) const {
  const std::uint64_t mask = (std::uint64_t{1} << half_) - 1;
  std::uint64_t left = i >> half_, right = i & mask;
  for (const std::uint64_t key : keys_) {
    const std::uint64_t next = left ^ (mixed(right ^ key) & mask);
    left = right;
    right = next;
  }
  return left << half_ | right;
}

// Numbers beyond the size are sent on until one falls inside: a permutation still, at most four tries in the mean.
std::uint64_t Permutation::operator()(std::uint64_t i) const {
  do i = shuffle(i);
  while (i >= size_);
  return i;
}

}  // namespace loadpath::sweep
