#include "lib/sweep/point/uniform.hpp"

#include <Random123/philox.h>
#include <algorithm>
#include <cstddef>

namespace loadpath::sweep {

namespace {

using Philox = r123::Philox4x64;

/// The four numbers of four points that follow one another, the first a multiple of four.
inline Philox::ctr_type four(std::uint64_t seed, std::uint64_t group, std::uint64_t variable, Purpose purpose) {
  return Philox()(Philox::ctr_type{{group, variable, 0, 0}},
                  Philox::key_type{{seed, static_cast<std::uint64_t>(purpose)}});
}

}  // namespace

std::array<std::uint64_t, 4> random_bits(const std::array<std::uint64_t, 4>& counter,
                                         const std::array<std::uint64_t, 2>& key) {
  const auto bits =
      Philox()(Philox::ctr_type{{counter[0], counter[1], counter[2], counter[3]}}, Philox::key_type{{key[0], key[1]}});
  return {bits[0], bits[1], bits[2], bits[3]};
}

double uniform(std::uint64_t seed, std::uint64_t index, std::uint64_t variable, Purpose purpose) {
  return unit(four(seed, index >> 2, variable, purpose)[index & 3]);
}

void uniform(std::uint64_t seed, std::uint64_t first, std::uint64_t variable, std::span<double> column,
             Purpose purpose) {
  const std::size_t n = column.size(), head = std::min<std::size_t>(n, -first & 3);
  std::size_t i = 0;
  for (; i < head; ++i) column[i] = uniform(seed, first + i, variable, purpose);
  for (; i + 4 <= n; i += 4) {
    const auto bits = four(seed, (first + i) >> 2, variable, purpose);
    for (std::size_t k = 0; k < 4; ++k) column[i + k] = unit(bits[k]);
  }
  for (; i < n; ++i) column[i] = uniform(seed, first + i, variable, purpose);
}

}  // namespace loadpath::sweep
