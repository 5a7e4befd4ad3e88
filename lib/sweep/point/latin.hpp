// Latin hypercubes without a table: which part of its range a variable takes in a sample is a permutation by a key.
#pragma once

#include <array>
#include <cstdint>

namespace loadpath::sweep {

/// A permutation of 0 ... size - 1.
class Permutation {
 public:
  Permutation(std::uint64_t size, std::uint64_t seed, std::uint64_t variable, std::uint64_t cube);

  /// The image of i < size.
  [[nodiscard]] std::uint64_t operator()(std::uint64_t i) const;

 private:
  [[nodiscard]] std::uint64_t shuffle(std::uint64_t i) const;

  std::uint64_t size_;
  std::array<std::uint64_t, 4> keys_;  // keys of the rounds
  unsigned half_;                      // bits of each half of a number
};

}  // namespace loadpath::sweep
