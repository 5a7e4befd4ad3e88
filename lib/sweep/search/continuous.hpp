// The continuous variables of a design at their best while the discrete ones stay.
#pragma once

#include "lib/sweep/search/trials.hpp"

namespace loadpath::sweep {

enum class Care {
  quick,    // by gradients, and by linear models if that finds no feasible point
  thorough  // by both, and then by polling around the best, as flags and kinks require
};

/// The best point of a descent from `start`, which is included; a local optimum. Gradients are central differences,
/// and steer by the utilisations (SLSQP and COBYLA of NLopt); the best is assessed with all constraints. `scale` is
/// the usual size of the objective.
[[nodiscard]] Trial descended(Trials& trials, const Trial& start, double scale, Care care);

}  // namespace loadpath::sweep
