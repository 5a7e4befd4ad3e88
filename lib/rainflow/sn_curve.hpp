// S-N curves of straight branches in a log-log plot (Basquin), and their extension below the knee by Miner's rule.
// Lives are in cycles, never in reversals; stresses in the unit of the history.
#pragma once

#include "lib/text/issue.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace loadpath::rainflow {

/// The stress measure of the curve for a cycle.
enum class Measure { amplitude, range };

class SnCurve {
 public:
  struct Point {
    double stress = 0.0, cycles = 0.0;  // both > 0
  };
  /// N is proportional to S^-slope, up to a life where the next branch begins, or beyond which nothing fails.
  struct Branch {
    double slope = 0.0;                    // 1 to 64
    double until = endless;                // cycles, rising from branch to branch
    static constexpr double endless = -1;  // last branch only: it continues to the smallest stress
  };
  /// A branch in stresses: down to `from`, which is still on it, through `point`.
  struct Segment {
    double from = 0.0;
    double slope = 0.0;
    Point point;
  };

  /// One without branches: nothing fails.
  SnCurve() = default;
  /// A curve whose first branch goes through `point`: EN 1993-1-9 is {category, 2e6}, {{3, 5e6}, {5, 1e8}}. A Fault
  /// names an invalid number.
  static Outcome<SnCurve> make(Measure measure, Point point, std::span<const Branch> branches);

  [[nodiscard]] Measure measure() const { return measure_; }
  /// From the highest stresses down.
  [[nodiscard]] std::span<const Segment> segments() const { return segments_; }

  /// The share of the life that one cycle of this stress (>= 0) takes, 1 / N; 0 if it never fails; finite.
  [[nodiscard]] double damage(double stress) const;
  /// Cycles to failure; none if it never fails, or beyond the range of numbers.
  [[nodiscard]] std::optional<double> cycles(double stress) const;
  /// The stress that fails after so many cycles; none if none does.
  [[nodiscard]] std::optional<double> stress(double cycles) const;

 private:
  Measure measure_ = Measure::amplitude;
  std::vector<Segment> segments_;
};

/// The contribution of cycles below the fatigue limit, the end of the single branch of a curve, to the damage sum.
enum class Miner {
  original,    // not at all
  elementary,  // by the same slope k, without a limit
  modified,    // by the slope 2 k - 1, Haibach
  liu_zenner,  // all by the slope (k + 3.6) / 2 from the largest cycle on, down to half of the limit; recalled
};

/// The curve for a damage sum by this rule. `largest` is the stress of the largest cycle, only for Liu-Zenner; if it
/// is below the limit, there is no damage by that rule. A Fault unless the curve has one branch with an end: a curve
/// with more branches defines its own continuation.
Outcome<SnCurve> by_miner(const SnCurve& curve, Miner rule, double largest);

/// A stress with its number of cycles.
struct Level {
  double stress = 0.0;
  double count = 0.0;
};

/// The damage of a spectrum by Miner's consistent rule: the fatigue limit falls with the damage D as (1 - D)^(1/q), q
/// = k - 1 (Haibach, recalled), so that small cycles begin to count. It is the reciprocal of the allowable
/// repetitions of the spectrum; for the same levels always between `original` and `elementary`. A Fault as in
/// by_miner.
Outcome<double> consistent_damage(const SnCurve& curve, std::vector<Level> collective);

}  // namespace loadpath::rainflow
