// Instantaneous centres: the instantaneous centre of rotation of a link against the ground or another link.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <vector>

namespace loadpath::mechanism {

struct InstantCentre {
  /// `at_infinity`: the links do not turn against each other, all points move alike; `at_rest`: nor do they move.
  enum class Kind { point, at_infinity, at_rest };
  Kind kind = Kind::at_rest;
  Vec at;         // global, m: where there is one
  Vec direction;  // unit vector towards the centre at infinity: square to the motion
};

/// The centre of link i against link j: the point where both have the same velocity. It does not depend on the speed
/// of the one drive, but there must be one. `size`: of the mechanism, m; a centre more than 1e9 of it away is at
/// infinity. Technical mechanics (in Bulgarian), chapter 29.
InstantCentre instant_centre(const Position& at, int i, int j, double size);

/// The centres of all pairs of links, the ground last: three of them are collinear for any three links (Aronhold and
/// Kennedy).
struct CentreOfPair {
  int i = 0, j = ground;
  InstantCentre centre;
};
std::vector<CentreOfPair> instant_centres(const Position& at, double size);

}  // namespace loadpath::mechanism
