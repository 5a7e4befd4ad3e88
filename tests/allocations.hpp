// Counts heap allocations of the tests' process: hot paths must not allocate.
#pragma once

#include <cstddef>

namespace loadpath::tests {

/// The number of calls of `operator new` so far.
std::size_t allocations();

}  // namespace loadpath::tests
