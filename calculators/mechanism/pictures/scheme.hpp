// A planar mechanism as lib/draw shows it.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/words/points.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::planar {

/// How far a pin goes along its guide or slot, or a contact along a flat face: from its own point, m.
struct Stroke {
  double from = 0.0, to = 0.0;
};
/// What a drawing that moves needs room for at every position.
struct Extents {
  std::vector<Stroke> strokes;               // of every joint; of joints without a line empty
  std::vector<bool> loads_push, loads_turn;  // somewhere in the cycle
};
Extents extents_of(const mechanism::Model& model, const Cycle& cycle);

/// What is drawn: forces that are zero at this position too, where the drawing moves.
enum class Shown { at_rest, moving };

/// The scheme at a position, as `still`, and by which links its parts are carried. A joint's arrow is the force of its
/// first link on its second.
/// `points`: named where no joint has them.
draw::Motion scheme_at(const mechanism::Model& model, const mechanism::Position& at, const Extents& extents,
                       const std::vector<TracedPoint>& points, Shown shown);

/// The paths of moving points over the positions, with a dozen of these on each; `cyclic`: they end where they began.
void add_paths(const std::vector<TracedPoint>& points, const Cycle& cycle, bool cyclic, draw::Scheme& scheme);

}  // namespace loadpath::planar
