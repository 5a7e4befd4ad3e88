// The mechanism through its positions, as a drawing that moves, with the force plan of every link.
#pragma once

#include "calculators/mechanism/input/points.hpp"
#include "calculators/mechanism/pictures/scheme.hpp"
#include "calculators/mechanism/results/results.hpp"

#include <vector>

namespace loadpath::planar {

struct AnimationSubject {
  const mechanism::Model& model;
  const Cycle& cycle;
  const Extents& extents;
  const std::vector<TracedPoint>& points;
  const Results& results;
  const Axis& axis;
  std::size_t governing = 0;  // a position with forces: the one that is printed
  bool statics = false;
};

/// Frames are all positions that have forces, or every second, third... where they are very many.
figure::Figure animation(const AnimationSubject& subject);

/// The positions that become frames, the governing one among them.
std::vector<std::size_t> frames_of(const Cycle& cycle, std::size_t governing, std::size_t most);

}  // namespace loadpath::planar
