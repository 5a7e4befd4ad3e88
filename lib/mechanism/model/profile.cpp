#include "lib/mechanism/model/profile.hpp"

#include "lib/mechanism/model/whole_turn.hpp"
#include "lib/numerics/dual.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace loadpath::mechanism {

using numerics::Dual;

namespace {

using std::cos, std::sin, std::sqrt;

double sign_of(CamSense sense) { return sense == CamSense::counter_clockwise ? -1.0 : 1.0; }

/// In the frame of the cam, the frame of the follower rotates in the opposite direction.
template <class Scalar>
BasicLift<Scalar> lift_at(const Lift& lift, CamSense sense, Scalar parameter) {
  const double sign = sign_of(sense);
  BasicLift<Scalar> s = lift.at(sign * parameter);
  s.first = sign * s.first;
  return s;
}

template <class Scalar>
BasicCurvePoint<Scalar> curve_point(BasicVec<Scalar> at, BasicVec<Scalar> first, BasicVec<Scalar> second) {
  const Scalar pace = sqrt(dot(first, first));
  return {at, (1.0 / pace) * first, pace, cross(first, second) / (pace * pace)};
}

/// A point with these derivatives in a frame that rotates with the parameter.
template <class Scalar>
BasicCurvePoint<Scalar> carried_round(Scalar parameter, BasicVec<Scalar> own, BasicVec<Scalar> first,
                                      BasicVec<Scalar> second) {
  const BasicTurn<Scalar> turned = turn(parameter);
  return curve_point(turned(own), turned(first + normal(own)), turned(second + 2.0 * normal(first) - own));
}

template <class Scalar>
BasicCurvePoint<Scalar> point_of(const SlidingFollower& f, Scalar parameter) {
  const BasicLift<Scalar> s = lift_at(f.lift, f.sense, parameter);
  const double height = std::sqrt(f.distance * f.distance - f.offset * f.offset);
  return carried_round<Scalar>(parameter, {height + s.s, f.offset}, {s.first, 0.0}, {s.second, 0.0});
}

template <class Scalar>
BasicCurvePoint<Scalar> point_of(const SwingingFollower& f, Scalar parameter) {
  const BasicLift<Scalar> s = lift_at(f.lift, f.sense, parameter);
  const Scalar angle = f.base_angle() + s.s;
  const BasicVec<Scalar> arm{-f.arm * cos(angle), f.side * f.arm * sin(angle)};
  const BasicVec<Scalar> across{f.arm * sin(angle), f.side * f.arm * cos(angle)};
  return carried_round<Scalar>(parameter, BasicVec<Scalar>{f.pivot, 0.0} + arm, s.first * across,
                               s.second * across - s.first * s.first * arm);
}

template <class Scalar>
BasicCurvePoint<Scalar> point_of(const FlatFollower& f, Scalar parameter) {
  const BasicLift<Scalar> s = lift_at(f.lift, f.sense, parameter);
  const BasicVec<Scalar> out = turn(parameter)(BasicVec<Scalar>{1.0, 0.0}), tangent = normal(out);
  const Scalar height = f.base + s.s;
  return {height * out + s.first * tangent, tangent, height + s.second, 1.0};
}

/// From the distance of the face from the axis, as a function of the direction of its normal, and its derivatives.
template <class Scalar>
BasicCurvePoint<Scalar> point_of(const SwingingFace& f, Scalar parameter) {
  const BasicLift<Scalar> s = lift_at(f.lift, f.sense, parameter);
  const Scalar angle = f.base_angle() + s.s, turning = 1.0 - f.side * s.first;
  const Scalar height = f.pivot * sin(angle) - f.offset;
  const Scalar first = f.pivot * cos(angle) * s.first;
  const Scalar second = f.pivot * (cos(angle) * s.second - sin(angle) * s.first * s.first);
  const Scalar pace = turning * height + (second * turning + first * f.side * s.second) / (turning * turning);
  const BasicVec<Scalar> out = turn(parameter)(BasicVec<Scalar>{sin(angle), f.side * cos(angle)}),
                         tangent = normal(out);
  return {height * out + (first / turning) * tangent, tangent, pace, turning};
}

template <class Scalar>
BasicCurvePoint<Scalar> point_of(const Circle& circle, Scalar parameter) {
  const BasicVec<Scalar> out = turn(parameter)(BasicVec<Scalar>{1.0, 0.0});
  return {BasicVec<Scalar>{circle.centre.x, circle.centre.y} + circle.radius * out, normal(out), circle.radius, 1.0};
}

template <class Scalar>
BasicCurvePoint<Scalar> point_of(const SplineCurve& curve, Scalar parameter) {
  const auto x = curve.x().at(parameter), y = curve.y().at(parameter);
  return curve_point<Scalar>({x.y, y.y}, {x.first, y.first}, {x.second, y.second});
}

/// Shares of a full revolution by the lengths of the chords.
std::vector<double> chord_parameters(std::span<const Vec> points) {
  std::vector<double> parameters{0.0};
  for (std::size_t k = 1; k < points.size(); ++k) {
    parameters.push_back(parameters.back() + length(points[k] - points[k - 1]));
  }
  const double all = parameters.back() + length(points.front() - points.back());
  for (double& p : parameters) p *= whole_turn / all;
  return parameters;
}

std::vector<double> coordinates(std::span<const Vec> points, double Vec::*coordinate) {
  std::vector<double> values;
  for (const Vec& p : points) values.push_back(p.*coordinate);
  return values;
}

/// The parameter, of some evenly spread ones, where this is least.
template <class Measure>
double best_of_all(Measure measure) {
  constexpr int samples = 360;
  double best = 0.0, least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < samples; ++k) {
    const double parameter = whole_turn * k / samples, here = measure(parameter);
    if (here < least) least = here, best = parameter;
  }
  return best;
}

/// Newton's iteration for a parameter, with steps held short; no number if it finds none, or leads to a place where
/// the curve is farthest.
template <class Step>
double iterate(double parameter, Step step) {
  constexpr int most_steps = 30;
  constexpr double longest = 0.3, exact = 1e-14, quadratic = 1e-8;
  double previous = std::numeric_limits<double>::infinity();
  for (int k = 0; k < most_steps; ++k) {
    const double change = step(parameter);
    if (!std::isfinite(change)) return Profile::anywhere;
    parameter += std::clamp(change, -longest, longest);
    if (std::abs(change) <= exact || previous <= quadratic) return parameter;
    previous = std::abs(change);
  }
  return Profile::anywhere;
}

/// From `start`; if there is none, or nothing is found from there, from the best place of all. No number where that
/// leads nowhere.
template <class Step, class Measure>
double find(double start, Step step, Measure measure) {
  const double next = std::isfinite(start) ? iterate(start, step) : Profile::anywhere;
  if (std::isfinite(next)) return next;
  return iterate(best_of_all(measure), step);
}

}  // namespace

double SwingingFollower::base_angle() const {
  return std::acos((pivot * pivot + arm * arm - distance * distance) / (2.0 * pivot * arm));
}

double SwingingFace::base_angle() const { return std::asin((base + offset) / pivot); }

SplineCurve::SplineCurve(std::span<const Vec> points) : SplineCurve(points, chord_parameters(points)) {}
SplineCurve::SplineCurve(std::span<const Vec> points, std::span<const double> parameters)
    : x_(parameters, coordinates(points, &Vec::x), whole_turn),
      y_(parameters, coordinates(points, &Vec::y), whole_turn) {}

template <class Scalar>
BasicCurvePoint<Scalar> Profile::at(Scalar parameter) const {
  return std::visit([&](const auto& curve) { return point_of(curve, parameter); }, curve_);
}

double Profile::nearest(Vec point, double start) const {
  const auto step = [&](double parameter) {
    const CurvePoint on = at(parameter);
    const Vec away = point - on.at;
    const double slope = on.pace + on.turning * dot(outward(on.tangent), away);
    return slope > 0.0 ? dot(on.tangent, away) / slope : anywhere;
  };
  return find(start, step, [&](double parameter) {
    const Vec away = point - at(parameter).at;
    return dot(away, away);
  });
}

double Profile::facing(Vec normal, double start) const {
  const auto step = [&](double parameter) {
    const CurvePoint on = at(parameter);
    const Vec out = outward(on.tangent);
    return on.turning > 0.0 ? std::atan2(cross(out, normal), dot(out, normal)) / on.turning : anywhere;
  };
  return find(start, step, [&](double parameter) { return -dot(outward(at(parameter).tangent), normal); });
}

Vec Profile::flank(double parameter) const {
  const CurvePoint on = at(parameter);
  return on.at - inset_ * outward(on.tangent);
}

Bends bends_of(const Profile& profile) {
  constexpr int samples = 7200;
  Bends bends;
  for (int k = 0; k < samples; ++k) {
    const double parameter = whole_turn * k / samples;
    const CurvePoint on = profile.at(parameter);
    const double radius = (on.pace - profile.inset() * on.turning) / on.turning;
    if (on.turning > 0.0 && radius < bends.bulge) bends.bulge = radius, bends.bulge_at = parameter;
    if (on.turning < 0.0 && -radius < bends.hollow) bends.hollow = -radius, bends.hollow_at = parameter;
  }
  return bends;
}

template BasicCurvePoint<double> Profile::at(double) const;
template BasicCurvePoint<Dual> Profile::at(Dual) const;

}  // namespace loadpath::mechanism
