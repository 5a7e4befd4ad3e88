// Numbers that are told to a power of ten, since what lies beyond is rounding: fewer digits, none of them noise, and
// text at the price of an integer's.
#pragma once

#include <string>

namespace loadpath {

/// Multiples of a power of ten.
class Decimals {
 public:
  /// The coarsest that tell everything larger than `rounding`: nothing moves by more than half of that. Of 0, all there
  /// are.
  static Decimals within(double rounding);
  /// The finest that tell nothing smaller than `rounding`.
  static Decimals beyond(double rounding);

  /// The multiple nearest to a number; the number itself where a double has no more digits than that, or it is none.
  [[nodiscard]] double nearest(double value) const;
  /// The text of that: "-27.35", "30", "1.2e-07"; of a finite number.
  void append_nearest(double value, std::string& text) const;
  /// A text that reads back to the same finite double: of a multiple its own digits, else the shortest.
  void append_exact(double value, std::string& text) const;

 private:
  explicit Decimals(int power) : power_(power) {}
  int power_;
};

}  // namespace loadpath
