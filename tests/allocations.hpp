// Counts what the tests' process takes from the heap: hot paths must take nothing.
#pragma once

#include <cstddef>

namespace loadpath::tests {

/// How often `operator new` was called so far.
std::size_t allocations();

}  // namespace loadpath::tests
