// The loops of a sweep over columns of points: which points are out of the ordinary, how modes of failure come out.
//
// States are numbers of account::State, for then a loop has numbers of one width only, and goes through wide registers.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::project {

/// How a point, a part or a mode of failure came out, as a number of a column: that of account::State, or one of these.
constexpr double refused_state =
    7.0;  // the point breaks a rule between inputs, or a value is none that its field takes
constexpr double absent_state = -1.0;  // the mode does not concern the part

/// How one mode of failure came out, point by point: absent_state where it does not concern the point.
struct ModeColumns {
  std::vector<double> state, utilisation;
};

/// Whether every value is a number within the bounds.
bool all_within(const Range& bounds, std::span<const double> si);
/// Whether all are above zero, or all below.
bool all_act(std::span<const double> si);

/// What the rows of a mode come to.
class Fold {
 public:
  void clear(std::size_t n);
  /// A check or a limit: of the worst ones the most utilised governs. What is no number is no row.
  void take_check(std::span<const double> utilisation);
  void take_limit(const Range& bounds, bool is_criterion, std::span<const double> si);

  /// What nothing judges comes out by whether the mode concerns the part.
  struct Unjudged {
    std::array<double, 3> state{};  // by Applies
    bool needs_checks = false;      // limits alone do not judge it
    bool never = false;             // rows that pass do not judge it: a check is missing
  };
  /// As judged() says it of one machine.
  void judge(std::span<const Applies> applies, const Unjudged& unjudged, ModeColumns& mode) const;

 private:
  void take(const Range& closed, double below, double above, bool is_check, std::span<const double> si);

  std::vector<double> worst_;    // a state, below zero where there is no row
  std::vector<double> checked_;  // above zero where there is a check
  std::vector<double> utilisation_;
};

/// A mode that nothing is held against.
void leave_mode(std::span<const Applies> applies, const Fold::Unjudged& unjudged, ModeColumns& mode);

/// What several modes come to together.
class Together {
 public:
  /// `is_strict`: what is open counts as not judged.
  void fold(std::span<const ModeColumns* const> modes, std::size_t n, bool is_strict);

  [[nodiscard]] std::span<const double> utilisation() const { return utilisation_; }
  /// 1 where they pass, or are open, else 0.
  void write_passes(std::span<double> out) const;
  /// `is_whole`: of all modes of a step or of the project, which pass where something was judged.
  void write_state(bool is_whole, std::span<double> out) const;

 private:
  std::vector<double> worst_, judged_, utilisation_;
};

}  // namespace loadpath::project
