// The source of samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace loadpath::sweep {

/// Fills columns with the values of the samples first, first + 1, ...: a pure function of the number of the sample.
/// Samples are independent of one another.
using Sampler = std::function<void(std::uint64_t first, std::size_t n, std::span<double* const> columns)>;

}  // namespace loadpath::sweep
