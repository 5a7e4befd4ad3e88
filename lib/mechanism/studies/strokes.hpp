// Reciprocating motions at a continuous motion of the drive: extreme positions, strokes, time ratio.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// A reversal: a dead point, from which the part cannot drive the mechanism.
struct Reversal {
  double drive = 0.0;       // on the axis of the positions, rad or m
  double coordinate = 0.0;  // angle of the link, rad, or position of the pin along its guide, m
};

struct Stroke {
  enum class Of { link, guide };
  Of of = Of::link;
  std::size_t index = 0;                 // index of the link, or of the joint
  std::vector<Reversal> reversals = {};  // in the order of the positions
  double range = 0.0;                    // from one extreme to the other, rad or m
  /// The ratio of the longer to the shorter interval between two extremes, in angles of the drive: at least 1; equal
  /// to the ratio of times at constant drive speed. 0 unless there are exactly two extremes per revolution.
  double time_ratio = 0.0;
};

/// Positions in order and their coordinates; `period` of a full revolution, signed, else 0.
struct Course {
  std::span<const double> at;  // rad or m
  double period = 0.0;
  std::span<const Position> derivatives;  // as PositionFunctions derives them
  std::vector<bool> known;                // validity of each
};

/// First of all rotating links, then of all slots and slides whose pins move. Extremes are found between the
/// positions where the first derivative changes sign. The model has one driver.
std::vector<Stroke> strokes(const Model& model, const Course& course);

}  // namespace loadpath::mechanism
