// An axis: the range shown, the positions of its ticks and their labels.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::draw {

struct Range {
  double low = 0.0;
  double high = 0.0;
};

struct Axis {
  Range range;                // display units
  std::vector<double> ticks;  // inside the range
  double step = 1.0;
  int power = 0;             // ticks are written in units of 10^power
  bool logarithmic = false;  // then without that unit

  [[nodiscard]] double fraction(double value) const;
  [[nodiscard]] std::string text(double tick) const;
};

/// Steps of 1, 2 or 5 times a power of ten; of angles in degrees 30, 45, 60, 90...
enum class Steps { decimal, degrees };
enum class Ends { data, ticks };  // the range ends where the data end (or at a tick that is almost there), or at ticks

/// At most about `most` ticks. A range without extent is opened around its value and zero.
Axis axis(Range data, int most, Steps steps, Ends ends);

/// An axis of positive values, with ticks at powers of ten, and between them where these are few.
Axis logarithmic_axis(Range data, Ends ends);

/// The largest of 1, 2, 5 times a power of ten that is not above `value`.
double round_below(double value);

}  // namespace loadpath::draw
