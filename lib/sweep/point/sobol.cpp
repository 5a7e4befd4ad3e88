#include "lib/sweep/point/sobol.hpp"

#include "lib/sweep/point/uniform.hpp"

#include <boost/random/sobol.hpp>

#include <bit>

namespace loadpath::sweep {

namespace {

constexpr unsigned digits = 52;

/// Each digit of a number becomes the sum of itself and some of those above it.
std::array<std::uint64_t, digits> triangle(std::uint64_t seed, std::uint64_t variable) {
  std::array<std::uint64_t, digits> rows{};
  for (unsigned row = 0; row < digits; ++row) {
    const std::uint64_t own = std::uint64_t{1} << (63 - row), above = ~(own | (own - 1));
    rows[row] = own | (random_bits(seed, row, variable, Purpose::triangle)[0] & above);
  }
  return rows;
}

std::uint64_t scrambled(std::uint64_t number, const std::array<std::uint64_t, digits>& rows) {
  std::uint64_t found = 0;
  for (unsigned row = 0; row < digits; ++row)
    found |= static_cast<std::uint64_t>(std::popcount(number & rows[row]) & 1) << (63 - row);
  return found;
}

}  // namespace

// Boost steps from point to point by Gray's code and omits the first: its point 2^bit - 1 has the flips of this bit
// and the one below it.
std::vector<std::array<std::uint64_t, digits>> sobol_directions(std::size_t variables) {
  std::vector<std::array<std::uint64_t, digits>> found(variables);
  if (variables == 0) return found;
  boost::random::sobol engine(variables);
  for (unsigned bit = 0; bit < digits; ++bit) {
    engine.seed((std::uint64_t{1} << bit) - 1);
    for (auto& directions : found) directions[bit] = engine() ^ (bit > 0 ? directions[bit - 1] : 0);
  }
  return found;
}

Sobol::Sobol(std::size_t variables, std::uint64_t seed) : seed_(seed), directions_(sobol_directions(variables)) {
  for (std::size_t k = 0; k < variables; ++k) {
    const auto rows = triangle(seed, k);
    for (std::uint64_t& direction : directions_[k]) direction = scrambled(direction, rows);
  }
}

void Sobol::fill(std::size_t variable, std::uint64_t first, std::uint64_t shift, std::span<double> column) const {
  const Directions& directions = directions_[variable];
  Directions up_to;  // bits flipped by counting up: a bit and all below it
  std::uint64_t flipped = 0, x = random_bits(seed_, shift, variable, Purpose::shift)[0];
  for (unsigned bit = 0; bit < digits; ++bit) {
    up_to[bit] = flipped ^= directions[bit];
    if ((first >> bit & 1) != 0) x ^= directions[bit];
  }
  for (double& u : column) {
    u = unit(x);
    x ^= up_to[static_cast<unsigned>(std::countr_zero(++first)) % digits];
  }
}

}  // namespace loadpath::sweep
