// Numbers rounded to a power of ten, since further digits are rounding errors: fewer digits, all significant, and
// formatting as fast as for integers.
#pragma once

#include <span>
#include <string>

namespace loadpath {

/// Multiples of a power of ten.
class Decimals {
 public:
  /// The coarsest power of ten that changes no number by more than half of `rounding`. For 0, all digits are kept.
  static Decimals within(double rounding);
  /// The finest power of ten that is not below `rounding`.
  static Decimals beyond(double rounding);

  /// The multiple nearest to a number; the number itself if a double has no more digits than that, or it is NaN.
  [[nodiscard]] double nearest(double value) const;
  /// The same of each; those up to `zero` become 0.
  void round(std::span<double> values, double zero) const;
  /// The text of that: "-27.35", "30", "1.2e-07"; of a finite number.
  void append_nearest(double value, std::string& text) const;
  /// A text that reads back to the same finite double: of a multiple its own digits, else the shortest.
  void append_exact(double value, std::string& text) const;

 private:
  explicit Decimals(int power) : power_(power) {}
  int power_;
};

}  // namespace loadpath
