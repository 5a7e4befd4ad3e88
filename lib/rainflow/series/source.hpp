// The source of a series' bytes: a file or the standard input, of any length.
#pragma once

#include "lib/text/issue.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace loadpath::rainflow {

class Source {
 public:
  Source() = default;
  Source(Source&&) = delete;
  virtual ~Source() = default;
  /// Fills `room` from its start with the next bytes; returns their number, less than its size only at the end. A
  /// Fault if reading fails.
  virtual Outcome<std::size_t> read(std::span<char> room) = 0;
};

/// A file, or the standard input for "-". A Fault with the reason of the system where it cannot be read.
Outcome<std::unique_ptr<Source>> open_source(const std::string& path);

}  // namespace loadpath::rainflow
