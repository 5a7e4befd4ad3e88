// The pairs nearest to passing of a range in which none passes, without a rating of each.
#pragma once

#include "calculators/gear/sizing/load_bound.hpp"
#include "calculators/gear/sizing/rated.hpp"

#include <vector>

namespace loadpath::gear::sizing {

/// The bounds of all numbers of a range; none if they do not apply to it.
class Bounds {
 public:
  Bounds() = default;
  explicit Bounds(const Range& range);

  [[nodiscard]] bool empty() const { return bounds_.empty(); }
  /// Of the largest check of an option at a width in mm; zero if unknown.
  [[nodiscard]] double at(const Option& option, double b) const;
  /// Whether a limit rejects the option at any width.
  [[nodiscard]] bool reject(const Option& option) const;
  /// Of the widths of an option that are rated: the first one if a limit rejects it, else all.
  [[nodiscard]] double least(const Input& in, const Option& option) const;

 private:
  struct OfNumbers {
    LoadBound load;
    double d_1;  // reference diameter of gear 1 in modules
  };
  std::vector<OfNumbers> bounds_;
};

struct Nearest {
  bool one_passes = false;
  std::vector<Found> found;  // the nearest first
};

/// The nearest by the limits that they leave and their largest check. Stops where one passes.
Nearest nearest_of(const Input& in, const Range& range, const Bounds& bounds);

}  // namespace loadpath::gear::sizing
