// The solution of a project: its numbers by name, and the states of its parts. Numbers are SI.
#pragma once

#include <limits>
#include <loadpath/error.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::api {

/// The state of a part, a failure mode or a check. Columns of sweeps contain the number.
enum class State {
  absent = -1,  // the mode does not concern the part
  pass = 0,
  accepted,       // by the user, with a reason
  open,           // may concern the part, but nothing states whether it does
  not_judged,     // concerns the part, and has not been assessed
  not_covered,    // outside the validity of the method
  not_available,  // a value is missing
  fail,
  refused  // the point of the sweep violates an input rule: it is invalid
};
/// "not covered"
std::string word_of(State state);

enum class Role { input, result, check, limit };

/// A value with its unit; an input or a result of a step.
struct Quantity {
  std::string name;     // "crankshaft.d_min"
  std::string meaning;  // "least diameter"
  Role role = Role::result;
  std::string kind;                                         // "stress", "moment"
  std::string si_unit;                                      // "Pa"; "1" of a number
  std::string unit;                                         // display unit: "MPa"
  double value = std::numeric_limits<double>::quiet_NaN();  // not available; of a series NaN
  std::vector<double> series;                               // over the cycle; empty if there is one value
  std::string axis;                                         // axis of the series: "lever: crank angle"
  std::vector<double> positions;                            // positions along the axis
  std::string word;                                         // choices and names: instead of a number
  std::string text;                                         // "12.5 mm"
  std::string reason;                                       // reason for a missing value
};

struct Mode {
  std::string step, id, meaning;
  State state = State::not_judged;
  /// "fails", "needs_input", "outside_scope", "not_considered", "accepted" or "passes".
  std::string group;
  double utilisation = std::numeric_limits<double>::quiet_NaN();  // NaN if there is none
  std::string governs;                                            // the check that decides
  std::string reason;
};

struct Check {
  std::string step, name, meaning;
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string bound;  // "passes at 1 or less"
  State state = State::not_available;
};

struct Solution {
  std::vector<Quantity> quantities;  // inputs, then results, step by step
  std::vector<Mode> modes;           // failure modes, the worst first
  std::vector<Check> checks;
  std::vector<Issue> warnings;
  State state = State::open;
  std::string headline;  // "PASS", "FAIL", "NO SOLUTION" or "INCOMPLETE"
  std::string verdict;   // "fail: rod.buckling; not assessed: rod.bending"

  /// Whether every mode that applies passes, or is accepted: exit code 0 of the program.
  bool passes = false;

  /// Null if there is none of the name.
  [[nodiscard]] const Quantity* find(std::string_view name) const;
  /// An Error with the nearest name if there is none.
  const Quantity& operator[](std::string_view name) const;
};

}  // namespace loadpath::api
