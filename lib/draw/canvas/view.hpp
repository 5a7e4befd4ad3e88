// The plane of the drawing: view units, y downwards.
#pragma once

#include "lib/figure/point.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace loadpath::draw {

using figure::Point;

inline constexpr double view_width = 480.0;  // 350 px on a phone, 560 px on a page: 13 units read well on both
inline constexpr double text_size = 13.0;
inline constexpr double line_height = 16.0;

inline Point along(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Whether a number can be drawn: its magnitude must not overflow in arithmetic on ranges.
inline bool drawable(double v) { return std::fabs(v) < 1e100; }
inline bool drawable(Point p) { return drawable(p.x) && drawable(p.y); }

struct Box {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;

  static Box around(Point centre, double width, double height) {
    return {centre.x - 0.5 * width, centre.y - 0.5 * height, centre.x + 0.5 * width, centre.y + 0.5 * height};
  }
  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
  [[nodiscard]] Point centre() const { return {0.5 * (left + right), 0.5 * (top + bottom)}; }
  [[nodiscard]] Box grown(double by) const { return {left - by, top - by, right + by, bottom + by}; }
  [[nodiscard]] bool contains(const Box& o) const {
    return o.left >= left && o.right <= right && o.top >= top && o.bottom <= bottom;
  }
  [[nodiscard]] bool meets(const Box& o) const {
    return o.left < right && left < o.right && o.top < bottom && top < o.bottom;
  }
  void include(const Box& o) {
    left = std::min(left, o.left), right = std::max(right, o.right);
    top = std::min(top, o.top), bottom = std::max(bottom, o.bottom);
  }
};

}  // namespace loadpath::draw
