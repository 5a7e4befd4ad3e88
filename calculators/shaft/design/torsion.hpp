// Torsional vibration of the shaft with its mounted components: natural frequencies, and their distance from an
// excitation that occurs h times per revolution.
#pragma once

#include "calculators/shaft/design/model/result.hpp"
#include "calculators/shaft/design/model/stretches.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"

#include <optional>

namespace loadpath::shaft {

/// Nothing where the inertia of a seat, or the density, is not known.
std::optional<beam::Swing> swing_of(const DesignInput& in);

/// Whether an order h passes more than the lowest frequency on the run-up to the speed of the shaft.
Applies resonance_on_the_way(const DesignInput& in);

/// Check of the lowest frequency, and of each order at the speed of the shaft.
template <class Tracer>
void judge_torsion(const DesignInput& in, DesignResult& r, Tracer& trace);

}  // namespace loadpath::shaft
