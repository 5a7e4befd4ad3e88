// The S-N curves that a history is held against, as lib/rainflow has them. Stresses in MPa.
#pragma once

#include "calculators/fatigue/history/types.hpp"
#include "lib/rainflow/sn_curve.hpp"

#include <optional>

namespace loadpath::fatigue {

/// The chosen curve as it is given: of a part one branch down to its knee, of a detail its branches.
rainflow::SnCurve curve_of(const HistoryTypes::Input& in);

/// With the rule for small cycles, and for `largest`, the stress of the largest cycle. The consistent rule, which has
/// no curve, has none; below the limit of its constant amplitude a detail of EN 1993-1-9 has none either: nothing
/// fails.
rainflow::SnCurve curve_by(HistoryTypes::MinerRule rule, const HistoryTypes::Input& in, double largest);

/// The range of a detail of EN 1993-1-9 below which nothing fails where no cycle is larger, MPa.
double constant_amplitude_limit(const HistoryTypes::Input& in);

}  // namespace loadpath::fatigue
