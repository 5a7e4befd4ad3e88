// The load spectrum of a history next to its S-N curve.
#pragma once

#include "lib/figure/figure.hpp"
#include "lib/rainflow/cycle.hpp"
#include "lib/rainflow/sn_curve.hpp"

#include <string>
#include <vector>

namespace loadpath::fatigue {

/// `stress` of each cycle on the curve, MPa; how many are at least so large, in all `passages`.
std::vector<figure::Figure> spectrum_figure(const std::vector<rainflow::Cycle>& cycles,
                                            const std::vector<double>& stress, const rainflow::SnCurve& curve,
                                            double passages, const std::string& meaning);

}  // namespace loadpath::fatigue
