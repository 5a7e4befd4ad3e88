#include "lib/draw/canvas/thin.hpp"

namespace loadpath::draw {
namespace {

/// The directions from a point in which all later points are met within the tolerance.
class Cone {
 public:
  Cone(Point apex, double tolerance) : apex_(apex), tolerance_(tolerance) {}

  /// Narrows the cone to the point; false if it is outside.
  bool admits(Point p) {
    const Point d = p - apex_;
    const double distance = std::sqrt(dot(d, d));
    if (distance < reach_ - tolerance_) return false;
    if (distance > tolerance_) {
      if (open_ && (cross(low_, d) < 0.0 || cross(d, high_) < 0.0)) return false;
      const double sine = tolerance_ / distance, cosine = std::sqrt(1.0 - sine * sine);
      const Point low = cosine * d - sine * across(d), high = cosine * d + sine * across(d);
      if (!open_ || cross(low_, low) > 0.0) low_ = low;
      if (!open_ || cross(high, high_) > 0.0) high_ = high;
      open_ = true;
    }
    reach_ = std::max(reach_, distance);
    return true;
  }

 private:
  Point apex_, low_, high_;  // the sides of the cone: less than half a turn from one to the other
  double tolerance_, reach_ = 0.0;
  bool open_ = false;
};

std::vector<Point> without_straight_parts(const std::vector<Point>& points, double tolerance) {
  std::vector<Point> kept{points.front()};
  Cone cone(points.front(), tolerance);
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (cone.admits(points[i])) continue;
    kept.push_back(points[i - 1]);
    cone = Cone(points[i - 1], tolerance);
    cone.admits(points[i]);
  }
  kept.push_back(points.back());
  return kept;
}

/// First, lowest, highest and last of the points from `begin` to `end`, in their order.
void append_extremes(std::vector<Point>& kept, const std::vector<Point>& points, std::size_t begin, std::size_t end) {
  std::size_t low = begin, high = begin;
  for (std::size_t i = begin; i < end; ++i) {
    if (points[i].y < points[low].y) low = i;
    if (points[i].y > points[high].y) high = i;
  }
  std::size_t order[] = {begin, std::min(low, high), std::max(low, high), end - 1};
  for (std::size_t k = 0; k < 4; ++k) {
    if (k == 0 || order[k] != order[k - 1]) kept.push_back(points[order[k]]);
  }
}

std::vector<Point> extremes_of_columns(const std::vector<Point>& points, double width) {
  std::vector<Point> kept;
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    const double column = std::floor(points[begin].x / width);
    while (end < points.size() && std::floor(points[end].x / width) == column) ++end;
    append_extremes(kept, points, begin, end);
  }
  return kept;
}

}  // namespace

std::vector<Point> thin(const std::vector<Point>& points, double tolerance) {
  constexpr std::size_t many = 800;
  if (points.size() < 3) return points;
  std::vector<Point> kept = without_straight_parts(points, tolerance);
  for (double width = 2.0; kept.size() > many; width *= 2.0) kept = extremes_of_columns(kept, width);
  return kept;
}

std::vector<Point> simplified(const std::vector<Point>& points, double tolerance) {
  return points.size() < 3 ? points : without_straight_parts(points, tolerance);
}

}  // namespace loadpath::draw
