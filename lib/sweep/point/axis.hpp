// The values that a variable of a grid takes.
#pragma once

#include "lib/text/issue.hpp"

#include <cstdint>
#include <vector>

namespace loadpath::sweep {

class Axis {
 public:
  /// One value, zero.
  Axis() = default;

  static Outcome<Axis> list(std::vector<double> values);
  /// from, from + step, ..., with `to` itself where it is met within rounding; downwards with a step below zero.
  static Outcome<Axis> by_step(double from, double to, double step);
  /// `count` values at equal distances, the ends among them.
  static Outcome<Axis> by_count(double from, double to, std::uint64_t count);
  /// `count` values at equal ratios, the ends among them; both are of one sign.
  static Outcome<Axis> logarithmic(double from, double to, std::uint64_t count);

  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// The value of 0 <= i < size(), a function of i only.
  [[nodiscard]] double at(std::uint64_t i) const;

 private:
  std::vector<double> values_;  // values of a list; empty if they are computed
  double from_ = 0.0, to_ = 0.0;
  double step_ = 0.0;  // zero if the ends and the number are given
  double last_ = 0.0;  // the value at size - 1
  std::uint64_t size_ = 1;
};

}  // namespace loadpath::sweep
