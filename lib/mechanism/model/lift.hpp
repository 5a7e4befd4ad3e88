// The lift of a cam's follower over a turn of the cam: segments of rise, dwell and fall, each by a law of motion.
//
// The laws, for a part x of the segment's angle: harmonic (1 - cos pi x)/2, cycloidal x - sin(2 pi x)/(2 pi), the
// polynomials that rest at both ends with (3-4-5) the acceleration zero there and (4-5-6-7) the jerk too, and two by
// the pieces of their acceleration: modified sine, a quarter wave over 1/8, half a wave over 3/4, a quarter over 1/8;
// modified trapezoid, a quarter wave up over 1/8, constant over 1/4, half a wave down over 1/4, and the same back.
#pragma once

#include <span>
#include <vector>

namespace loadpath::mechanism {

enum class LiftLaw { dwell, harmonic, cycloidal, polynomial_345, polynomial_4567, modified_sine, modified_trapezoid };

struct LiftSegment {
  LiftLaw law = LiftLaw::dwell;
  double angle = 0.0;  // angle of the cam, rad, > 0
  double rise = 0.0;   // m, or rad of an arm; a fall is negative
};

/// A lift and its derivatives with respect to the cam's angle.
template <class Scalar>
struct BasicLift {
  Scalar s = 0.0, first = 0.0, second = 0.0;
};

class Lift {
 public:
  /// Segments whose angles add up to a full revolution and whose rises cancel; it begins at zero. Without segments it
  /// rests.
  explicit Lift(std::span<const LiftSegment> segments);

  /// At this angle of the cam, rad, any number of turns.
  template <class Scalar>
  [[nodiscard]] BasicLift<Scalar> at(Scalar angle) const;

  /// Boundaries of two segments with a jump of the acceleration: angles of the cam, rad. A follower knocks there.
  [[nodiscard]] std::vector<double> jumps() const;

 private:
  struct Piece {
    LiftLaw law;
    double start, angle, from, rise;
  };
  template <class Scalar>
  static BasicLift<Scalar> of(const Piece& piece, Scalar angle);

  std::vector<Piece> pieces_;
};

}  // namespace loadpath::mechanism
