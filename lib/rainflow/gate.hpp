// Omits ranges that are too small to be counted, before counting.
#pragma once

#include <cstddef>
#include <cstdint>

namespace loadpath::rainflow {

/// A hysteresis gate: an extreme becomes a turning point once the series has reversed from it by `width` or more.
/// Cycles of at least that range are those of the full series; its ends are omitted if the series moves by less before
/// them.
class Gate {
 public:
  /// In the unit of the series, 0 or more.
  explicit Gate(double width) : width_(width) {}

  /// Filters turning points in their place; how many are left of them. `at` may be null.
  std::size_t pass(double* values, std::uint64_t* at, std::size_t count) {
    std::size_t left = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Point point{values[i], at == nullptr ? 0 : at[i]};
      Point turned;
      if (!turns(point, turned)) continue;
      values[left] = turned.value;
      if (at != nullptr) at[left] = turned.at;
      ++left;
    }
    return left;
  }
  /// The last turning point; none if the full series moves by less than the width.
  std::size_t finish(double* value, std::uint64_t* at) const {
    if (course_ == Course::none) return 0;
    const Point& last = course_ == Course::rising ? high_ : low_;
    *value = last.value;
    if (at != nullptr) *at = last.at;
    return 1;
  }

 private:
  struct Point {
    double value = 0.0;
    std::uint64_t at = 0;
  };
  enum class Course { empty, none, rising, falling };

  bool turns(const Point& point, Point& turned) {
    if (course_ == Course::empty) {
      low_ = high_ = point, course_ = Course::none;
      return false;
    }
    const bool higher = point.value > high_.value, lower = point.value < low_.value;
    if (course_ != Course::falling && higher) high_ = point;
    if (course_ != Course::rising && lower) low_ = point;
    if (course_ != Course::rising && point.value > low_.value && point.value - low_.value >= width_) {
      turned = low_, high_ = point, course_ = Course::rising;
      return true;
    }
    if (course_ != Course::falling && point.value < high_.value && high_.value - point.value >= width_) {
      turned = high_, low_ = point, course_ = Course::falling;
      return true;
    }
    return false;
  }

  double width_;
  Course course_ = Course::empty;
  Point low_, high_;  // the one that a course goes to may still move
};

}  // namespace loadpath::rainflow
