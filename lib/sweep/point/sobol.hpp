// Samples that fill the space evenly: Sobol's sequence with the direction numbers of Joe and Kuo 2008, which
// Boost.Random has, scrambled at random (Matousek 1998: a triangular matrix and a shift), so that means over it are
// free of bias.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace loadpath::sweep {

class Sobol {
 public:
  static constexpr std::size_t most_variables = 3667;
  static constexpr std::uint64_t most_samples = std::uint64_t{1} << 52;

  Sobol() = default;
  Sobol(std::size_t variables, std::uint64_t seed);

  /// The samples first, first + 1... of a variable, 0 < u < 1; another `shift` gives other samples.
  void fill(std::size_t variable, std::uint64_t first, std::uint64_t shift, std::span<double> column) const;

 private:
  using Directions = std::array<std::uint64_t, 52>;  // flips by each bit of the index

  std::uint64_t seed_ = 0;
  std::vector<Directions> directions_;  // directions of each variable
};

/// The flips by the bits 0 ... 51 of an index, as published, for a variable; the highest bit of a number is 1/2.
std::vector<std::array<std::uint64_t, 52>> sobol_directions(std::size_t variables);

}  // namespace loadpath::sweep
