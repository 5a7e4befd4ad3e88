// Numbers as a machine holds them: NumPy's .npy, and plain float64 or float32.
#pragma once

#include "lib/rainflow/series/reader.hpp"

#include <cstddef>
#include <memory>
#include <string>

namespace loadpath::rainflow {

/// NumPy's format, versions 1 to 3 (numpy.lib.format); `column` is a number counted from 1, or empty if there is
/// one.
Outcome<std::unique_ptr<Reader>> read_npy(std::unique_ptr<Source> source, const std::string& column);

/// Little-endian numbers of `width` bytes, 8 or 4, to the end of the source.
Outcome<std::unique_ptr<Reader>> read_plain(std::unique_ptr<Source> source, std::size_t width);

}  // namespace loadpath::rainflow
