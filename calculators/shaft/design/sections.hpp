// The sections of a shaft where something changes, each against yielding and fatigue.
#pragma once

#include "calculators/shaft/design/model/result.hpp"
#include "calculators/shaft/design/model/turn.hpp"
#include "lib/calculator/trace.hpp"

namespace loadpath::shaft {

/// A section within a piece, where nothing changes.
Section section_within(const DesignInput& in, std::size_t piece, Length x, const InternalForces& forces);

/// All of them quietly, and those again with their lines that decide over yielding and over fatigue.
template <class Tracer>
void judge_sections(const DesignInput& in, const Stations& stations, const Turn& turn, DesignResult& r, Tracer& trace);

}  // namespace loadpath::shaft
