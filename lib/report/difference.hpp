// The differences between two solved projects: inputs, choices, verdicts.
#pragma once

#include "lib/project/project.hpp"

#include <optional>
#include <string>
#include <vector>

namespace loadpath::report {

/// One difference, before and after. Numbers are in one unit; empty if there was none.
struct Difference {
  enum class Kind { heading, given, taken, chosen, state, decides, utilisation, result };
  Kind kind = Kind::given;
  std::string name;  // "tau_adm", "segments[1].M", of a mode its id
  std::string before, after;
  std::optional<double> relative;  // change relative to the previous value; nothing for words, and for zero
  bool brief = true;               // worth a line where there is little room
};

/// "input", "chosen", "verdict", as it is shown.
std::string word(Difference::Kind kind);

struct StepDifference {
  enum class Change { changed, added, removed };
  Change change = Change::changed;
  std::string name;
  std::string title;  // "Shaft in torsion"
  std::string calculator;
  std::string state;  // state of an added or a removed one
  std::vector<Difference> differences;
};

struct ProjectDifference {
  std::string before, after;  // the state of all modes together
  std::vector<Difference> heading;
  std::vector<StepDifference> steps;  // differing ones, in the order of the later project

  [[nodiscard]] bool none() const { return before == after && heading.empty() && steps.empty(); }
};

/// Both are solved. Numbers that differ by less than a part in 10^12 are alike.
ProjectDifference difference_of(const project::Project& before, const project::Project& after);

}  // namespace loadpath::report
