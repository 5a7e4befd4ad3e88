// The checks that a candidate of a search fails, and its distance from passing.
#pragma once

#include "lib/project/run/search/passing.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

namespace loadpath::project {

/// How badly a candidate misses the criteria of its neighbours; unequal: one of sizes that must be equal, as a bore and
/// its seat.
enum class Misfit { none, beyond, unequal };

/// The largest check, and the factor by which limits are exceeded; 1 passes.
struct Shortfall {
  double check = 1.0, limit = 1.0;
  Misfit misfit = Misfit::none;
  /// Nearer to passing: the largest of both decides, then the check.
  [[nodiscard]] bool is_less_than(const Shortfall& other) const {
    const double own = std::max(check, limit), others = std::max(other.check, other.limit);
    return own < others || (own == others && check < other.check);
  }
  /// The same for rows of a table: one that does not fit is never nearer than one that fits.
  [[nodiscard]] bool is_nearer_row_than(const Shortfall& other) const {
    return misfit != other.misfit ? misfit < other.misfit : is_less_than(other);
  }
};
/// At the settled sizes.
Shortfall shortfall_of_candidate(Evaluation& evaluation, Passing& passing);

/// Checks and limits that a candidate fails, in lists too, and with which value.
using FailedValues = std::map<Row, double>;
FailedValues failed_values(Evaluation& evaluation, Passing& passing);
/// Whether a row outside its bounds means that the part fails: a check, or a requirement, not the range of a method.
inline bool is_failure(const FieldInfo& row) { return row.role == Role::check || row.is_criterion; }
/// The values that fail with a smaller and with a larger candidate, and do not improve with the larger.
FailedValues unmoved_values(const FailedValues& smaller, const FailedValues& larger);

/// The reason for refusing a candidate.
struct CandidateFault {
  Message text;                       // "u_theta = 1.055"
  std::string row = {};               // the check or the limit; empty: a rule, or a size that does not settle
  std::optional<double> number = {};  // the utilisation, or the value of the limit
  std::string unit = {};              // unit of that value
};
/// At the sizes that follow from it.
CandidateFault fault_of_candidate(Evaluation& evaluation, Passing& passing);
/// "u_1 = 3.2 (shaft keyway: bearing pressure / allowable pressure)"; of a criterion the sizes that it compares, too:
/// "x_a = 1.04: must be at most 1 (least diameter / diameter of the shoulder: d_a = 49 mm, d_f = 47 mm)"
Message fault_in_full(const Evaluation& evaluation, const CandidateFault& fault);

/// A candidate that was not taken, by its fault.
account::TriedSize tried_size(const Calculator& calculator, std::string name, std::optional<double> si,
                              CandidateFault fault);

}  // namespace loadpath::project
