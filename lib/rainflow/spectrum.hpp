// Cycles and turning points sorted into classes: the rainflow matrix, range pairs, level crossings.
#pragma once

#include "lib/rainflow/cycle.hpp"
#include "lib/rainflow/sn_curve.hpp"
#include "lib/text/issue.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace loadpath::rainflow {

/// Classes of one width: from a bound up to the next one, which belongs to the next class; the last one holds both.
class Classes {
 public:
  static constexpr std::size_t most = 1024;

  Classes() = default;
  /// `count` classes from `low` on, in the unit of the series. A Fault if the width is not above 0, or there are
  /// more than 1024.
  static Outcome<Classes> make(double low, double width, std::size_t count);

  [[nodiscard]] std::size_t count() const { return count_; }
  /// The lower bound of class i, the upper one of the last for i = count().
  [[nodiscard]] double bound(std::size_t i) const { return low_ + static_cast<double>(i) * width_; }
  /// None outside of all.
  [[nodiscard]] std::optional<std::size_t> of(double x) const;

 private:
  double low_ = 0.0, width_ = 0.0;
  std::size_t count_ = 0;
};

/// The number of cycles between each pair of classes; the two directions of a cycle are distinguished.
class RainflowMatrix : public Consumer {
 public:
  explicit RainflowMatrix(Classes classes);

  void take(const Batch& batch) override;

  [[nodiscard]] const Classes& classes() const { return classes_; }
  [[nodiscard]] double count(std::size_t from, std::size_t to) const { return counts_[from * classes_.count() + to]; }
  /// Cycles with an end that is in no class: in no count of the matrix.
  [[nodiscard]] double outside() const { return outside_; }

 private:
  Classes classes_;
  std::vector<double> counts_;
  double outside_ = 0.0;
};

/// The number of cycles in each class of range.
class RangePairs : public Consumer {
 public:
  explicit RangePairs(Classes classes) : classes_(classes), counts_(classes.count(), 0.0) {}

  void take(const Batch& batch) override;

  [[nodiscard]] const Classes& classes() const { return classes_; }
  [[nodiscard]] std::span<const double> counts() const { return counts_; }
  [[nodiscard]] double outside() const { return outside_; }
  /// The number of cycles in this class of range or above: the spectrum as it is drawn.
  [[nodiscard]] std::vector<double> exceedances() const;
  /// The classes as levels of stress, each at its upper bound, so that damage is not underestimated.
  [[nodiscard]] std::vector<Level> levels(Measure measure) const;

 private:
  Classes classes_;
  std::vector<double> counts_;
  double outside_ = 0.0;
};

/// The number of crossings of each level: upwards from below to the level or above, downwards back. For the turning
/// points, after the omission of small ranges.
class LevelCrossings : public Consumer {
 public:
  /// Levels in any order; those that are not finite are left out.
  explicit LevelCrossings(std::vector<double> levels);

  void take(const Batch& /*batch*/) override {}
  void pass(std::span<const double> turning_points) override;

  struct Crossing {
    double level = 0.0;
    std::uint64_t up = 0, down = 0;
  };
  /// By rising levels.
  [[nodiscard]] std::vector<Crossing> crossings() const;

 private:
  [[nodiscard]] std::size_t below(double x) const;

  std::vector<double> levels_;
  std::vector<std::int64_t> up_, down_;  // how many more than of the level before
  std::optional<std::size_t> last_;      // how many levels are not above the latest point
};

}  // namespace loadpath::rainflow
