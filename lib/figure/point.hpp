// Points as vectors of the plane.
#pragma once

#include "lib/figure/figure.hpp"

#include <cmath>

namespace loadpath::figure {

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(double k, Point a) { return {k * a.x, k * a.y}; }
inline double length(Point a) { return std::hypot(a.x, a.y); }
inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
inline double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
inline Point across(Point a) { return {-a.y, a.x}; }
inline Point unit(Point a) { return length(a) > 0.0 ? 1.0 / length(a) * a : Point{1.0, 0.0}; }

}  // namespace loadpath::figure
