// Vectors in the plane.
#pragma once

#include <cmath>

namespace loadpath::mechanism {

struct Vec {
  double x = 0.0;
  double y = 0.0;
};

constexpr Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec operator-(Vec a) { return {-a.x, -a.y}; }
constexpr Vec operator*(double s, Vec a) { return {s * a.x, s * a.y}; }
constexpr double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
/// Turned by a right angle, counter-clockwise.
constexpr Vec normal(Vec a) { return {-a.y, a.x}; }
inline double length(Vec a) { return std::hypot(a.x, a.y); }

/// A rotation, by the cosine and sine of its angle.
struct Turn {
  double cosine = 1.0;
  double sine = 0.0;
  [[nodiscard]] constexpr Vec operator()(Vec a) const { return {cosine * a.x - sine * a.y, sine * a.x + cosine * a.y}; }
  [[nodiscard]] constexpr Turn back() const { return {cosine, -sine}; }
};

/// One turn after another.
constexpr Turn operator*(Turn a, Turn b) {
  return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

inline Turn turn(double angle) { return {std::cos(angle), std::sin(angle)}; }
/// The turn that takes the direction of `from` to that of `to`, which is as long.
constexpr Turn turn(Vec from, Vec to) {
  const double inverse = 1.0 / dot(from, from);
  return {dot(from, to) * inverse, cross(from, to) * inverse};
}
/// Between -pi and pi.
inline double angle_of(Turn turned) { return std::atan2(turned.sine, turned.cosine); }

}  // namespace loadpath::mechanism
