#include "lib/sweep/point/uniform.hpp"

#include "lib/simd/attributes.hpp"

#include <Random123/philox.h>
#include <algorithm>
#include <cstddef>
#include <utility>

namespace loadpath::sweep {

namespace {

using Philox = r123::Philox4x32;

constexpr std::uint64_t low = 0xffffffff;
constexpr std::size_t chunk = 64;

std::uint64_t joined(std::uint32_t lower, std::uint32_t upper) { return lower | std::uint64_t{upper} << 32; }

/// Data common to a column.
struct Place {
  std::uint64_t seed, variable, purpose;
};

/// A round of Philox on words of 32 bits in lanes of 64: four products fit into a register of 256 bits.
struct Words {
  std::uint64_t a, b, c, d;

  void round(std::uint64_t first_key, std::uint64_t second_key) {
    const std::uint64_t p = a * 0xd2511f53, q = c * 0xcd9e8d57;
    *this = {(q >> 32) ^ b ^ first_key, q & low, (p >> 32) ^ d ^ second_key, p & low};
  }
};

template <std::size_t... round>
inline Words after_rounds(Words words, std::uint64_t seed, std::index_sequence<round...>) {
  (words.round((seed + round * 0x9e3779b9) & low, ((seed >> 32) + round * 0xbb67ae85) & low), ...);
  return words;
}

/// The numbers of points 2 group, 2 group + 1 ... of n groups.
LOADPATH_COLUMNS void fill_groups(const Place& place, std::uint64_t group, double* column, std::size_t n) {
  double even[chunk], odd[chunk];
  for (std::size_t begin = 0; begin < n; begin += chunk) {
    const std::size_t count = std::min(chunk, n - begin);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint64_t at = group + begin + i;
      const Words words = after_rounds({at & low, at >> 32, place.variable & low, place.purpose}, place.seed,
                                       std::make_index_sequence<10>{});
      even[i] = unit(words.a | words.b << 32);
      odd[i] = unit(words.c | words.d << 32);
    }
    for (std::size_t i = 0; i < count; ++i) {
      column[2 * (begin + i)] = even[i];
      column[2 * (begin + i) + 1] = odd[i];
    }
  }
}

}  // namespace

std::array<std::uint64_t, 2> random_bits(std::uint64_t seed, std::uint64_t index, std::uint64_t variable,
                                         Purpose purpose) {
  const auto word = [](std::uint64_t number) { return static_cast<std::uint32_t>(number & low); };
  const auto bits =
      Philox()(Philox::ctr_type{{word(index), word(index >> 32), word(variable), static_cast<std::uint32_t>(purpose)}},
               Philox::key_type{{word(seed), word(seed >> 32)}});
  return {joined(bits[0], bits[1]), joined(bits[2], bits[3])};
}

double uniform(std::uint64_t seed, std::uint64_t index, std::uint64_t variable, Purpose purpose) {
  return unit(random_bits(seed, index >> 1, variable, purpose)[index & 1]);
}

void uniform(std::uint64_t seed, std::uint64_t first, std::uint64_t variable, std::span<double> column,
             Purpose purpose) {
  if (column.empty()) return;
  if ((first & 1) != 0) {
    column.front() = uniform(seed, first++, variable, purpose);
    column = column.subspan(1);
  }
  fill_groups({seed, variable, static_cast<std::uint64_t>(purpose)}, first >> 1, column.data(), column.size() / 2);
  if (column.size() % 2 != 0) column.back() = uniform(seed, first + column.size() - 1, variable, purpose);
}

}  // namespace loadpath::sweep
