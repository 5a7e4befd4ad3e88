// The storage format of reductions between shards and ranks: integers and doubles to the bit, lowest byte first.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace loadpath::sweep {

class Writer {
 public:
  void put(std::uint64_t number) {
    for (int byte = 0; byte < 8; ++byte) bytes_ += static_cast<char>(number >> (8 * byte) & 0xff);
  }
  void put(double number) { put(std::bit_cast<std::uint64_t>(number)); }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Gives zeros once the text has ended, and reports it.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t number() {
    if (bytes_.size() < 8) return fail();
    std::uint64_t found = 0;
    for (int byte = 0; byte < 8; ++byte)
      found |= std::uint64_t{static_cast<unsigned char>(bytes_[static_cast<std::size_t>(byte)])} << (8 * byte);
    bytes_.remove_prefix(8);
    return found;
  }
  double real() { return std::bit_cast<double>(number()); }
  /// How many things of so many numbers each follow; none if there is no room for them.
  std::uint64_t count(std::uint64_t numbers_each) {
    const std::uint64_t found = number();
    return found <= bytes_.size() / 8 / numbers_each ? found : fail();
  }
  /// Whether so many numbers are left.
  [[nodiscard]] bool has(std::uint64_t numbers) const { return numbers <= bytes_.size() / 8; }
  std::uint64_t fail() {
    failed_ = true;
    bytes_ = {};
    return 0;
  }
  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] bool at_end() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
  bool failed_ = false;
};

}  // namespace loadpath::sweep
