// The position that reports show.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/results/results.hpp"

#include <cstddef>

namespace loadpath::planar {

/// The position nearest to the largest moment of the drive, or force of the first cylinder; else the first that has
/// forces; one past the last where none has.
std::size_t governing_position(const Cycle& cycle, const Results& results);

}  // namespace loadpath::planar
