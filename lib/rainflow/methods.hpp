// Three closing conditions of a loop. They compare values of the series, not ranges, so that nothing is rounded.
#pragma once

#include "lib/rainflow/loops.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace loadpath::rainflow {

/// The four-point method: the inner range of four points closes if it is not larger than either neighbour. The
/// residue grows and then shrinks. FVA-Richtlinie Zaehlverfahren (2010), as recalled.
template <bool placed>
class FourPoint {
 public:
  void push(const Points& points, Loops& loops) {
    wait_.make_room(points.values.size());
    for (std::size_t i = 0; i < points.values.size(); ++i) {
      const double next = points.values[i];
      while (wait_.size() >= 3 && closes(wait_.top(3), wait_.top(2), wait_.top(1), next)) {
        loops.put<placed>(wait_.loop(wait_.size() - 2), wait_.where(wait_.size() - 2));
        wait_.drop(2);
      }
      wait_.push(next, placed ? points.at[i] : 0);
    }
  }
  [[nodiscard]] Points residue() const { return wait_.points(); }

 private:
  static bool closes(double a, double b, double c, double d) {
    return std::min(b, c) >= std::min(a, d) && std::max(b, c) <= std::max(a, d);
  }

  Waiting<placed> wait_;
};

/// HCM, the hysteresis counting of Clormann and Seeger (1985): a loop closes where the material returns to its start,
/// and the first load starts from zero on a branch of its own, which closes nothing. The variables of the publication
/// are IZ, points on the stack, and IR, those of them on that branch.
template <bool placed>
class Hcm {
 public:
  void push(const Points& points, Loops& loops) {
    wait_.make_room(points.values.size());
    for (std::size_t i = 0; i < points.values.size(); ++i) {
      settle(points.values[i], loops);
      wait_.push(points.values[i], placed ? points.at[i] : 0);
    }
  }
  [[nodiscard]] Points residue() const { return wait_.points(); }

 private:
  void settle(double next, Loops& loops) {
    while (wait_.size() > first_branch_) {
      const double start = wait_.top(2), turn = wait_.top(1);
      if (turn < start ? next < start : next > start) return;
      loops.put<placed>(wait_.loop(wait_.size() - 2), wait_.where(wait_.size() - 2));
      wait_.drop(2);
    }
    if (wait_.size() < first_branch_) return;
    const double turn = wait_.top(1);
    if (turn == 0.0 || (next > turn) == (turn > 0.0)) return wait_.drop(1);  // still moving away from zero
    if (std::abs(next) > std::abs(turn)) ++first_branch_;
  }

  Waiting<placed> wait_;
  std::size_t first_branch_ = 1;
};

/// The count of a range that includes the start of the history by ASTM E1049.
enum class AtStart { nothing, half, whole };

/// ASTM E1049-85(2017), 5.4.4: the last range but one is a cycle if the last is not smaller; half a cycle, and only
/// its first point is removed, if it includes the start of the history. In a repeating history, begun at its largest
/// magnitude, it is a full cycle: 5.4.5.
template <bool placed>
class Astm {
 public:
  explicit Astm(AtStart at_start) : at_start_(at_start) {}

  void push(const Points& points, Loops& loops) {
    wait_.make_room(points.values.size());
    for (std::size_t i = 0; i < points.values.size(); ++i) {
      wait_.push(points.values[i], placed ? points.at[i] : 0);
      settle(loops);
    }
  }
  [[nodiscard]] Points residue() const { return wait_.points(); }

 private:
  void settle(Loops& loops) {
    while (wait_.size() >= 3) {
      const double start = wait_.top(3), turn = wait_.top(2), next = wait_.top(1);
      if (turn < start ? next < start : next > start) return;
      const std::size_t last_but_one = wait_.size() - 3;
      const bool whole = last_but_one != 0 || at_start_ == AtStart::whole;
      if (whole || at_start_ == AtStart::half)
        loops.put<placed>(wait_.loop(last_but_one), wait_.where(last_but_one), whole ? 1.0 : 0.5);
      whole ? wait_.drop_below_top() : wait_.drop_first();
    }
  }

  Waiting<placed> wait_;
  AtStart at_start_;
};

}  // namespace loadpath::rainflow
