// Vectors in the plane, of numbers or of numbers with their derivatives (lib/numerics/dual.hpp).
#pragma once

#include <cmath>
#include <type_traits>

namespace loadpath::mechanism {

template <class Scalar>
struct BasicVec {
  Scalar x = 0.0;
  Scalar y = 0.0;
};
using Vec = BasicVec<double>;

template <class Scalar>
constexpr BasicVec<Scalar> operator+(BasicVec<Scalar> a, BasicVec<Scalar> b) {
  return {a.x + b.x, a.y + b.y};
}
template <class Scalar>
constexpr BasicVec<Scalar> operator-(BasicVec<Scalar> a, BasicVec<Scalar> b) {
  return {a.x - b.x, a.y - b.y};
}
template <class Scalar>
constexpr BasicVec<Scalar> operator-(BasicVec<Scalar> a) {
  return {-a.x, -a.y};
}
template <class Scalar>
constexpr BasicVec<Scalar> operator*(std::type_identity_t<Scalar> s, BasicVec<Scalar> a) {
  return {s * a.x, s * a.y};
}
template <class Scalar>
constexpr Scalar dot(BasicVec<Scalar> a, BasicVec<Scalar> b) {
  return a.x * b.x + a.y * b.y;
}
template <class Scalar>
constexpr Scalar cross(BasicVec<Scalar> a, BasicVec<Scalar> b) {
  return a.x * b.y - a.y * b.x;
}
/// Turned by a right angle, counter-clockwise.
template <class Scalar>
constexpr BasicVec<Scalar> normal(BasicVec<Scalar> a) {
  return {-a.y, a.x};
}
template <class Scalar>
Scalar length(BasicVec<Scalar> a) {
  if constexpr (std::is_same_v<Scalar, double>) {
    return std::sqrt(a.x * a.x + a.y * a.y);  // sizes stay far from where squares leave the range of numbers
  } else {
    return hypot(a.x, a.y);
  }
}

/// A rotation, by the cosine and sine of its angle.
template <class Scalar>
struct BasicTurn {
  Scalar cosine = 1.0;
  Scalar sine = 0.0;
  [[nodiscard]] constexpr BasicVec<Scalar> operator()(BasicVec<Scalar> a) const {
    return {cosine * a.x - sine * a.y, sine * a.x + cosine * a.y};
  }
  [[nodiscard]] constexpr BasicTurn back() const { return {cosine, -sine}; }
};
using Turn = BasicTurn<double>;

/// One turn after another.
template <class Scalar>
constexpr BasicTurn<Scalar> operator*(BasicTurn<Scalar> a, BasicTurn<Scalar> b) {
  return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

template <class Scalar>
BasicTurn<Scalar> turn(Scalar angle) {
  using std::cos;
  using std::sin;
  return {cos(angle), sin(angle)};
}
/// The turn that takes the direction of `from` to that of `to`, which is as long.
constexpr Turn turn(Vec from, Vec to) {
  const double inverse = 1.0 / dot(from, from);
  return {dot(from, to) * inverse, cross(from, to) * inverse};
}
/// Between -pi and pi.
inline double angle_of(Turn turned) { return std::atan2(turned.sine, turned.cosine); }

}  // namespace loadpath::mechanism
