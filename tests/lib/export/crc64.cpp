// The checksum of the columns of a sweep: its published check value, and bit by bit as it is defined.
#include "lib/export/sweep/crc64.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>

using loadpath::exports::crc64;

namespace {

std::uint64_t bit_by_bit(std::uint64_t rest, std::string_view bytes) {
  for (const char byte : bytes) {
    rest ^= std::uint64_t{static_cast<unsigned char>(byte)} << 56;
    for (int bit = 0; bit < 8; ++bit) rest = (rest << 1) ^ ((rest >> 63) != 0 ? 0x42F0E1EBA9EA3693 : 0);
  }
  return rest;
}

}  // namespace

TEST_SUITE("checksum of columns") {
  TEST_CASE("its check value is that of CRC-64/ECMA-182") {
    CHECK(crc64(0, "123456789") == 0x6C40DF5F0B497347);  // catalogue of parametrised CRC algorithms, reveng
    CHECK(crc64(0, "") == 0);
    CHECK(crc64(17, "") == 17);
  }

  TEST_CASE("bytes of any number, in any parts, have the remainder of the division") {
    std::mt19937 draw(1);
    std::string bytes;
    for (int i = 0; i < 200; ++i) bytes += static_cast<char>(draw() & 255);
    for (std::size_t n = 0; n <= bytes.size(); ++n) {
      const std::string_view first = std::string_view(bytes).substr(0, n), rest = std::string_view(bytes).substr(n);
      CAPTURE(n);
      CHECK(crc64(0, first) == bit_by_bit(0, first));
      CHECK(crc64(crc64(0, first), rest) == bit_by_bit(0, bytes));
    }
  }
}
