// The peak of a function between two places.
#pragma once

namespace loadpath::numerics {

/// A place, and the value of a function there.
struct Peak {
  double t = 0.0, f = -1.0;
};

/// The largest value of f between two places, by the golden section, which keeps a single peak between its ends.
template <class Function>
Peak peak_between(const Function& f, double low, double high) {
  constexpr double part = 0.6180339887498949;
  constexpr int steps = 32;
  Peak left{high - part * (high - low)}, right{low + part * (high - low)};
  left.f = f(left.t), right.f = f(right.t);
  for (int i = 0; i < steps; ++i) {
    if (left.f < right.f) {
      low = left.t, left = right;
      right = {low + part * (high - low)}, right.f = f(right.t);
    } else {
      high = right.t, right = left;
      left = {high - part * (high - low)}, left.f = f(left.t);
    }
  }
  return left.f < right.f ? right : left;
}

}  // namespace loadpath::numerics
