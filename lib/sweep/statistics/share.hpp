// The frequency of an event: the share of points that fail, with its confidence.
#pragma once

#include "lib/sweep/statistics/bytes.hpp"
#include "lib/sweep/statistics/confidence.hpp"

#include <cstdint>
#include <limits>

namespace loadpath::sweep {

/// Points of which it is not known are counted apart.
struct Share {
  std::uint64_t met = 0, count = 0, unknown = 0;

  void merge(const Share& other) {
    met += other.met;
    count += other.count;
    unknown += other.unknown;
  }

  /// NaN if nothing is known.
  [[nodiscard]] double share() const { return static_cast<double>(met) / static_cast<double>(count); }
  [[nodiscard]] Interval bounds(double confidence) const {
    if (count == 0) return {0.0, 1.0};
    return share_bounds(met, count, confidence);
  }

  void store(Writer& writer) const {
    for (const std::uint64_t number : {met, count, unknown}) writer.put(number);
  }
  void load(Reader& reader) {
    for (std::uint64_t* const number : {&met, &count, &unknown}) *number = reader.number();
  }
  bool operator==(const Share&) const = default;
};

}  // namespace loadpath::sweep
