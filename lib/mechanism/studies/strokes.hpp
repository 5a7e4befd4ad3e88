// What swings and what slides to and fro while the drive goes on: extreme positions, strokes, time ratio.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// Where something reverses: a dead point, from which it cannot drive the mechanism.
struct Reversal {
  double drive = 0.0;       // on the axis of the positions, rad or m
  double coordinate = 0.0;  // of the link, rad, or of the pin along its guide, m
};

struct Stroke {
  enum class Of { link, guide };
  Of of = Of::link;
  std::size_t index = 0;                 // of the link, or of the joint
  std::vector<Reversal> reversals = {};  // in the order of the positions
  double range = 0.0;                    // from one extreme to the other, rad or m
  /// Of the longer way to the shorter one between two extremes, in angles of the drive: at least 1, of times when the
  /// drive turns evenly. 0 where there are not just two extremes in a turn.
  double time_ratio = 0.0;
};

/// Positions in order and what they are at; `period` of a whole turn, signed, else 0.
struct Course {
  std::span<const double> at;  // rad or m
  double period = 0.0;
  std::span<const Position> derivatives;  // as PositionFunctions derives them
  std::vector<bool> known;                // where they hold
};

/// Of all links that turn, then of all slots and slides whose pins move. Extremes are found between the positions where
/// the first derivative goes through zero. The model has one driver.
std::vector<Stroke> strokes(const Model& model, const Course& course);

}  // namespace loadpath::mechanism
