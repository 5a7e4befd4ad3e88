// Damage of cycles by an S-N curve: their sum, the constant range of the same damage, and the most damaging cycles.
#pragma once

#include "lib/rainflow/comparisons.hpp"
#include "lib/rainflow/cycle.hpp"
#include "lib/rainflow/powers.hpp"
#include "lib/rainflow/sn_curve.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace loadpath::rainflow {

/// Palmgren-Miner: the sum of count / N over the cycles, means aside.
class DamageSum : public Consumer {
 public:
  explicit DamageSum(SnCurve curve, Instructions instructions = best_instructions());

  void take(const Batch& batch) override;

  /// A Fault if it is beyond the range of numbers.
  [[nodiscard]] Outcome<double> total() const;
  /// The number of cycles, halves as 0.5.
  [[nodiscard]] double cycles() const { return cycles_; }
  /// The stress of the largest cycle, in the measure of the curve; 0 if there was none.
  [[nodiscard]] double largest_stress() const;
  [[nodiscard]] const SnCurve& curve() const { return curve_; }

  /// Partial sums of every eighth cycle: the order of addition is that of wide registers on every CPU.
  static constexpr std::size_t lanes = 8;
  struct Sums {
    std::array<double, lanes> damage{}, largest{};
  };
  struct Lots {
    Lot stress, scaled, power, damage;
  };

 private:
  SnCurve curve_;
  Instructions instructions_;
  double cycles_ = 0.0;
  Sums sums_;
  Lots lots_{};
};

/// The damage of one cycle of each stress of a lot, 0 or more, into `damage`; finite.
void damages_of(const SnCurve& curve, DamageSum::Lots& lots, Instructions instructions = best_instructions());

/// The stress, in the measure of the curve, that does this damage in so many cycles: with a curve of one endless branch
/// of slope m, (sum of n S^m / cycles)^(1/m), the damage-equivalent range or amplitude of IEC 61400-1. None of no
/// damage.
std::optional<double> equivalent_stress(const SnCurve& curve, double damage, double cycles);

/// A cycle and the damage that it does, with its count.
struct Share {
  Cycle cycle;
  double damage = 0.0;
};

/// Keeps the cycles that do the most damage, the first of those that do the same.
class LargestShares : public Consumer {
 public:
  LargestShares(SnCurve curve, std::size_t how_many)
      : curve_(std::move(curve)), how_many_(how_many > 0 ? how_many : 1) {}

  void take(const Batch& batch) override;
  /// From the largest down.
  [[nodiscard]] const std::vector<Share>& shares() const { return shares_; }

 private:
  SnCurve curve_;
  std::size_t how_many_;
  std::vector<Share> shares_;
};

}  // namespace loadpath::rainflow
