// The profile of a cam: a closed curve in the cam's own axes, its origin the cam's axis.
//
// It is defined by a curve, traversed counter-clockwise, and lies inside it by `inset`: a lift function gives the
// path of the roller's centre, from which the flank of the cam is offset by the roller's radius. Tangent and
// curvature are exact, so that the follower's acceleration is that of the lift function.
#pragma once

#include "lib/mechanism/model/lift.hpp"
#include "lib/mechanism/model/vec.hpp"
#include "lib/numerics/periodic_spline.hpp"

#include <limits>
#include <span>
#include <variant>

namespace loadpath::mechanism {

/// A point of the curve at a parameter that grows by 2 pi all round.
template <class Scalar>
struct BasicCurvePoint {
  BasicVec<Scalar> at;       // m
  BasicVec<Scalar> tangent;  // unit
  Scalar pace = 0.0;         // m of the curve for 1 of the parameter
  Scalar turning = 0.0;      // rad of the tangent for 1 of the parameter
};
using CurvePoint = BasicCurvePoint<double>;

/// The direction of rotation of the cam against the frame of its follower along the law.
enum class CamSense { counter_clockwise, clockwise };

/// The path of a roller's centre on a straight guide: at the cam's angle 0 the guide points along the x axis, at the
/// distance `offset` to the left of the cam's axis; without lift the centre is `distance` away from that axis.
struct SlidingFollower {
  Lift lift;  // m
  CamSense sense = CamSense::counter_clockwise;
  double distance = 0.0;  // m, > |offset|
  double offset = 0.0;    // m
};

/// The same on an arm about a pivot, which at the cam's angle 0 lies on the x axis; `side`: +1 if the roller is to
/// the left of the line from the axis to the pivot, -1 to the right.
struct SwingingFollower {
  Lift lift;  // rad, away from the cam
  CamSense sense = CamSense::counter_clockwise;
  double distance = 0.0;  // m, of the roller's centre from the axis without lift
  double pivot = 0.0;     // m, from the axis
  double arm = 0.0;       // m
  double side = 1.0;
  /// The angle of the arm against the line to the axis, at zero lift, rad.
  [[nodiscard]] double base_angle() const;
};

/// The flank that carries a flat face which does not turn, square to its guide.
struct FlatFollower {
  Lift lift;  // m
  CamSense sense = CamSense::counter_clockwise;
  double base = 0.0;  // m, radius of the base circle
};

/// The flank for a flat face that swings about a pivot, on the x axis at the cam's angle 0; `side` as of an arm: where
/// the face extends from the pivot. Its normal must rotate with the cam: CurvePoint::turning > 0.
struct SwingingFace {
  Lift lift;  // rad, away from the cam
  CamSense sense = CamSense::counter_clockwise;
  double base = 0.0;    // m, radius of the base circle
  double pivot = 0.0;   // m, from the axis
  double offset = 0.0;  // m, of the face from its pivot, towards the cam
  double side = 1.0;
  /// The angle of the face against the line to the axis, at zero lift, rad.
  [[nodiscard]] double base_angle() const;
};

struct Circle {
  Vec centre;           // m
  double radius = 0.0;  // m
};

/// Smooth through given points, at least four, that run round counter-clockwise.
class SplineCurve {
 public:
  explicit SplineCurve(std::span<const Vec> points);
  [[nodiscard]] const numerics::PeriodicSpline& x() const { return x_; }
  [[nodiscard]] const numerics::PeriodicSpline& y() const { return y_; }

 private:
  SplineCurve(std::span<const Vec> points, std::span<const double> parameters);
  numerics::PeriodicSpline x_, y_;
};

class Profile {
 public:
  using Curve = std::variant<SlidingFollower, SwingingFollower, FlatFollower, SwingingFace, Circle, SplineCurve>;
  explicit Profile(Curve curve, double inset = 0.0) : curve_(std::move(curve)), inset_(inset) {}

  /// The offset of the profile inside the curve, m.
  [[nodiscard]] double inset() const { return inset_; }
  [[nodiscard]] const Curve& curve() const { return curve_; }
  template <class Scalar>
  [[nodiscard]] BasicCurvePoint<Scalar> at(Scalar parameter) const;

  static constexpr double anywhere = std::numeric_limits<double>::quiet_NaN();
  /// The parameter where the curve comes nearest to a point: next to `start`, or of all the curve.
  [[nodiscard]] double nearest(Vec point, double start = anywhere) const;
  /// The parameter where the curve's outward normal has this direction, a unit vector.
  [[nodiscard]] double facing(Vec normal, double start = anywhere) const;
  /// The point of the profile itself.
  [[nodiscard]] Vec flank(double parameter) const;

 private:
  Curve curve_;
  double inset_;
};

/// Out of the cam, where the tangent runs counter-clockwise.
template <class Scalar>
BasicVec<Scalar> outward(BasicVec<Scalar> tangent) {
  return -normal(tangent);
}

/// The tightest bends of a profile, and where, by the curve's parameter.
struct Bends {
  /// The minimum radius of curvature of convex parts, m; undercut unless positive. Infinite without convex parts.
  double bulge = std::numeric_limits<double>::infinity(), bulge_at = 0.0;
  /// The same where it is hollow: no roller of a larger radius reaches in. Infinite where it is convex all round.
  double hollow = std::numeric_limits<double>::infinity(), hollow_at = 0.0;
};
Bends bends_of(const Profile& profile);

}  // namespace loadpath::mechanism
