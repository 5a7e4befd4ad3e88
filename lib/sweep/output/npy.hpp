// Columns of numbers as numpy reads them, at once or mapped into memory: NAME.npy, version 1.0, little-endian doubles.
#pragma once

#include "lib/text/issue.hpp"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>

namespace loadpath::sweep {

/// Bytes before the first number.
constexpr std::size_t npy_header_size = 128;

/// Numbers are appended; their count is in the header, which `flush` sets.
class NpyColumn {
 public:
  /// A new file, or the first `rows` numbers of an existing one.
  static Outcome<NpyColumn> open(const std::filesystem::path& path, std::uint64_t rows = 0);

  [[nodiscard]] bool append(std::span<const double> values);
  /// Everything that was appended is on the disk afterwards; false if that cannot be.
  [[nodiscard]] bool flush();
  [[nodiscard]] std::uint64_t rows() const { return rows_; }

 private:
  /// With the memory that the file fills before it is written to: blocks of points are small.
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
    std::unique_ptr<char[]> buffer;
  };
  std::unique_ptr<std::FILE, Close> file_;
  std::uint64_t rows_ = 0;
};

/// Everything that was written to the file is on the disk afterwards; false if that cannot be.
bool flush_to_disk(std::FILE* file);

/// Passes on the numbers of such a file, some at a time, until `take` ends it with false. Returns the error in the
/// file, or nothing.
Message read_npy(const std::filesystem::path& path, const std::function<bool(std::span<const double> values)>& take);

}  // namespace loadpath::sweep
