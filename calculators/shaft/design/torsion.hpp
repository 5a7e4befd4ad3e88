// The shaft as it swings about its axis with what sits on it: natural frequencies in torsion, and how far what comes h
// times in a turn stays from them.
#pragma once

#include "calculators/shaft/design/stretches.hpp"

#include <optional>

namespace loadpath::shaft {

/// Nothing where the inertia of a seat, or the density, is not known.
std::optional<beam::Swing> swing_of(const Design::Input& in);

/// Of the lowest frequency, and of each order at the speed of the shaft.
template <class Tracer>
void judge_torsion(const Design::Input& in, Design::Result& r, Tracer& trace);

}  // namespace loadpath::shaft
