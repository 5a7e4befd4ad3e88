// A planar mechanism as lib/draw shows it.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/input/points.hpp"
#include "calculators/mechanism/pictures/extents.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::planar {

/// Drawn content: forces that are zero at this position too, where the drawing moves.
enum class Shown { at_rest, moving };

/// The scheme at a position, as `still`, and by which links its parts are carried. A joint's arrow is the force of its
/// first link on its second.
/// `points`: named where no joint has them.
figure::Motion scheme_at(const mechanism::Model& model, const mechanism::Position& at, const Extents& extents,
                         const std::vector<TracedPoint>& points, Shown shown);

/// The paths of moving points over the positions, with a dozen of these on each; `cyclic`: they end where they began.
void add_paths(const std::vector<TracedPoint>& points, const Cycle& cycle, bool cyclic, figure::Scheme& scheme);

}  // namespace loadpath::planar
