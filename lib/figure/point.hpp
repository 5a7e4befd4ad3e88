// Points as vectors of the plane.
#pragma once

#include "lib/figure/figure.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace loadpath::figure {

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(double k, Point a) { return {k * a.x, k * a.y}; }
inline double length(Point a) { return std::hypot(a.x, a.y); }
inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
inline double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
inline Point across(Point a) { return {-a.y, a.x}; }
inline Point unit(Point a) { return length(a) > 0.0 ? 1.0 / length(a) * a : Point{1.0, 0.0}; }

/// By its polar coordinates; the angle in rad from x towards y.
inline Point at_angle(double angle, double radius) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

/// A circle as a polygon.
inline std::vector<Point> polygon_of_circle(Point centre, double radius, int corners) {
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(corners));
  for (int k = 0; k < corners; ++k) points.push_back(centre + at_angle(2.0 * std::numbers::pi * k / corners, radius));
  return points;
}

}  // namespace loadpath::figure
