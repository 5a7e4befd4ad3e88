// The intersection of the path of a pin on one side of a dyad with its path on the other: circles and straight lines.
#pragma once

#include "lib/mechanism/model/vec.hpp"

#include <cmath>

namespace loadpath::mechanism {

/// A circle about `at`, or the straight line through it along the unit vector `direction`.
struct Locus {
  bool straight = false;
  Vec at;
  Vec direction;        // direction of a straight line
  double radius = 0.0;  // radius of a circle
};

/// `sine`: of the angle at which the loci cross; near 0 the two points where they meet fall together. Not positive (or
/// no number) where they do not meet.
struct Meeting {
  Vec at;
  double sine = 0.0;
};

/// Among the two intersections of a circle with a line or another circle, the one on the side `branch`, +1 or -1; two
/// lines have one.
Meeting meet(const Locus& a, const Locus& b, double branch);

/// The side on which a point of both lies: +1 or -1.
double branch_of(const Locus& a, const Locus& b, Vec meeting);

/// The unit vector n with dot(n, d) = c, on the side `branch` of d; returned in `at`.
Meeting unit_vector_with_projection(Vec d, double c, double branch);

}  // namespace loadpath::mechanism
