// Failure modes of a mechanism from the verdicts of its aspects.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/account/mode.hpp"
#include "lib/project/step.hpp"

namespace loadpath::planar {

/// Modes of a step whose account has its verdicts. A mode without a verdict does not concern the mechanism, except
/// modes outside the scope: the strength of links and pins that `wanted` does not name as taken by another step.
account::Modes modes_of(const project::Step& step, const Mechanism::Input& in, const project::Wanted& wanted);

}  // namespace loadpath::planar
