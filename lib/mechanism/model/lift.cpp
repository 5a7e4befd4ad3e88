#include "lib/mechanism/model/lift.hpp"

#include "lib/mechanism/model/whole_turn.hpp"
#include "lib/numerics/dual.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loadpath::mechanism {

using numerics::Dual;

namespace {

using std::cos, std::sin;
using std::numbers::pi;

/// The first half of the law, x up to 1/2.
template <class Scalar>
BasicLift<Scalar> modified_sine(Scalar x) {
  constexpr double part = 1.0 / (4.0 + pi);
  if (numerics::value_of(x) < 0.125) {
    const Scalar wave = 4.0 * pi * x;
    return {part * (pi * x - 0.25 * sin(wave)), part * pi * (1.0 - cos(wave)), part * 4.0 * pi * pi * sin(wave)};
  }
  const Scalar wave = (4.0 * pi * x + pi) / 3.0;
  return {part * (2.0 + pi * x - 2.25 * sin(wave)), part * pi * (1.0 - 3.0 * cos(wave)),
          part * 4.0 * pi * pi * sin(wave)};
}

template <class Scalar>
BasicLift<Scalar> modified_trapezoid(Scalar x) {
  constexpr double part = 1.0 / (2.0 + pi);
  if (numerics::value_of(x) < 0.125) {
    const Scalar wave = 4.0 * pi * x;
    return {part * (2.0 * x - sin(wave) / whole_turn), part * 2.0 * (1.0 - cos(wave)), part * 8.0 * pi * sin(wave)};
  }
  if (numerics::value_of(x) < 0.375) {
    const Scalar past = x - 0.125;
    return {part * (4.0 * pi * past * past + 2.0 * x - 1.0 / whole_turn), part * (8.0 * pi * past + 2.0),
            Scalar(part * 8.0 * pi)};
  }
  const Scalar wave = 4.0 * pi * (x - 0.375);
  return {part * (2.0 * (pi + 1.0) * x - 0.5 * pi - cos(wave) / whole_turn), part * 2.0 * (pi + 1.0 + sin(wave)),
          part * 8.0 * pi * cos(wave)};
}

/// A law whose second half is its first in reverse.
template <class Scalar, class Half>
BasicLift<Scalar> there_and_back(Scalar x, Half half) {
  if (numerics::value_of(x) <= 0.5) return half(x);
  const BasicLift<Scalar> back = half(Scalar(1.0 - x));
  return {1.0 - back.s, back.first, -back.second};
}

/// A law over its own segment: a rise of 1 while x goes from 0 to 1.
template <class Scalar>
BasicLift<Scalar> unit_rise(LiftLaw law, Scalar x) {
  switch (law) {
    case LiftLaw::dwell:
      break;
    case LiftLaw::harmonic:
      return {0.5 - 0.5 * cos(pi * x), 0.5 * pi * sin(pi * x), 0.5 * pi * pi * cos(pi * x)};
    case LiftLaw::cycloidal:
      return {x - sin(whole_turn * x) / whole_turn, 1.0 - cos(whole_turn * x), whole_turn * sin(whole_turn * x)};
    case LiftLaw::polynomial_345:
      return {x * x * x * (10.0 + x * (-15.0 + 6.0 * x)), 30.0 * x * x * (1.0 + x * (-2.0 + x)),
              60.0 * x * (1.0 + x * (-3.0 + 2.0 * x))};
    case LiftLaw::polynomial_4567:
      return {x * x * x * x * (35.0 + x * (-84.0 + x * (70.0 - 20.0 * x))),
              140.0 * x * x * x * (1.0 + x * (-3.0 + x * (3.0 - x))),
              420.0 * x * x * (1.0 + x * (-4.0 + x * (5.0 - 2.0 * x)))};
    case LiftLaw::modified_sine:
      return there_and_back(x, modified_sine<Scalar>);
    case LiftLaw::modified_trapezoid:
      return there_and_back(x, modified_trapezoid<Scalar>);
  }
  return {};
}

}  // namespace

Lift::Lift(std::span<const LiftSegment> segments) {
  double start = 0.0, from = 0.0;
  for (const LiftSegment& segment : segments) {
    pieces_.push_back({segment.law, start, segment.angle, from, segment.rise});
    start += segment.angle;
    from += segment.rise;
  }
  if (pieces_.empty()) pieces_.push_back({LiftLaw::dwell, 0.0, whole_turn, 0.0, 0.0});
}

template <class Scalar>
BasicLift<Scalar> Lift::of(const Piece& piece, Scalar angle) {
  const double pace = 1.0 / piece.angle;
  const BasicLift<Scalar> unit = unit_rise<Scalar>(piece.law, pace * (angle - piece.start));
  return {piece.from + piece.rise * unit.s, piece.rise * pace * unit.first, piece.rise * pace * pace * unit.second};
}

template <class Scalar>
BasicLift<Scalar> Lift::at(Scalar angle) const {
  const double turns = std::floor(numerics::value_of(angle) / whole_turn);
  const Scalar within = angle - whole_turn * turns;
  auto piece = pieces_.begin();
  while (piece + 1 != pieces_.end() && numerics::value_of(within) >= (piece + 1)->start) ++piece;
  return of<Scalar>(*piece, within);
}

std::vector<double> Lift::jumps() const {
  constexpr double rounding = 1e-9;
  double most = 0.0;
  for (const Piece& piece : pieces_) most = std::max(most, std::abs(piece.rise) / (piece.angle * piece.angle));
  std::vector<double> angles;
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const Piece &before = pieces_[k], &after = pieces_[(k + 1) % pieces_.size()];
    const double end = of(before, before.start + before.angle).second, begin = of(after, after.start).second;
    if (std::abs(end - begin) > rounding * most) angles.push_back(after.start);
  }
  return angles;
}

template BasicLift<double> Lift::at(double) const;
template BasicLift<Dual> Lift::at(Dual) const;

}  // namespace loadpath::mechanism
