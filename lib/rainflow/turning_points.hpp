// The turning points of a series that comes in chunks: its first and last value, and those between where it turns. A
// plateau is one point, at its first sample (ASTM E1049-85(2017), 3.1: a reversal is where the slope changes sign).
#pragma once

#include "lib/rainflow/comparisons.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace loadpath::rainflow {

/// Why this sample, counted from 0, cannot be counted; `at` is its place. None if it can.
std::optional<Fault> refusal(double sample, std::uint64_t at);

class TurningPoints {
 public:
  explicit TurningPoints(Instructions instructions = best_instructions()) : instructions_(instructions) {}

  /// The turning points decided by these samples, independent of the division of the series. `values` has room for
  /// samples.size() + 4 of them, and `at`, if given, for their places in the series, counted from 0. Returns their
  /// number; a Fault whose `at` is the sample, if one is not finite or beyond 8e307: the series then ends.
  Outcome<std::size_t> feed(std::span<const double> samples, double* values, std::uint64_t* at = nullptr);

  /// The last value of the series; none of an empty series, and none if all of it was one plateau.
  std::size_t finish(double* value, std::uint64_t* at = nullptr) const;

  /// Samples so far.
  [[nodiscard]] std::uint64_t samples() const { return samples_; }

 private:
  struct Out {
    double* values;
    std::uint64_t* at;
    std::size_t count = 0;
    void put(double value, std::uint64_t place) {
      values[count] = value;
      if (at != nullptr) at[count] = place;
      ++count;
    }
  };
  enum class Course { none, rising, falling };

  /// One after the other, the first included; how many were good.
  std::size_t step(std::span<const double> samples, Out& out);
  void turn(const double* x, const Moves& moves, Out& out);

  Instructions instructions_;
  Course course_ = Course::none;
  double last_ = 0.0;        // the latest sample
  std::uint64_t since_ = 0;  // start of its plateau
  std::uint64_t samples_ = 0;
};

}  // namespace loadpath::rainflow
