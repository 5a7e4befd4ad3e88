#include "lib/export/sweep/crc64.hpp"

#include <array>
#include <cstddef>

namespace loadpath::exports {

namespace {

constexpr std::uint64_t generator = 0x42F0E1EBA9EA3693;
constexpr std::size_t at_once = 16;  // bytes: a table for each place

using Table = std::array<std::uint64_t, 256>;

/// The remainder of a byte that k zero bytes follow, for each k.
constexpr std::array<Table, at_once> remainders() {
  std::array<Table, at_once> tables{};
  for (std::size_t byte = 0; byte < 256; ++byte) {
    std::uint64_t rest = std::uint64_t{byte} << 56;
    for (int bit = 0; bit < 8; ++bit) rest = (rest << 1) ^ ((rest >> 63) != 0 ? generator : 0);
    tables[0][byte] = rest;
  }
  for (std::size_t k = 1; k < at_once; ++k) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint64_t before = tables[k - 1][byte];
      tables[k][byte] = (before << 8) ^ tables[0][before >> 56];
    }
  }
  return tables;
}

constexpr std::array<Table, at_once> table = remainders();

/// Eight bytes, the first in the highest place.
std::uint64_t word_at(const char* bytes) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < 8; ++i) word = word << 8 | static_cast<unsigned char>(bytes[i]);
  return word;
}

/// The remainder of the eight bytes of a word that `behind` others follow.
std::uint64_t remainder_of(std::uint64_t word, std::size_t behind) {
  std::uint64_t rest = 0;
  for (std::size_t i = 0; i < 8; ++i) rest ^= table[behind + i][word >> 8 * i & 255];
  return rest;
}

}  // namespace

std::uint64_t crc64(std::uint64_t before, std::string_view bytes) {
  std::uint64_t rest = before;
  for (; bytes.size() >= at_once; bytes.remove_prefix(at_once))
    rest = remainder_of(rest ^ word_at(bytes.data()), 8) ^ remainder_of(word_at(bytes.data() + 8), 0);
  for (const char byte : bytes) rest = (rest << 8) ^ table[0][(rest >> 56) ^ static_cast<unsigned char>(byte)];
  return rest;
}

}  // namespace loadpath::exports
