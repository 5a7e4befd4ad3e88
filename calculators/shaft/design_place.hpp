// The sections of a shaft where something changes, each against yielding and fatigue.
#pragma once

#include "calculators/shaft/design_bending.hpp"

namespace loadpath::shaft {

template <class Tracer>
void judge_places(const Design::Input& in, const Loaded& loaded, Design::Result& r, Tracer& trace);

}  // namespace loadpath::shaft
