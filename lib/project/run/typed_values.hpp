// Typed values compared with table rows, records, strengths that bound them, and usual ranges. A value of another part
// is an error; a more favourable value holds back the modes that it decides until the user justifies it
// (lib/project/run/beside.hpp).
#pragma once

#include "lib/project/modes.hpp"
#include "lib/project/run/evaluation/results.hpp"

#include <map>
#include <string>
#include <vector>

namespace loadpath::project {

/// Typed values that are bolder than what stands beside them, and what they decide.
struct WeighedValues {
  std::map<std::string, Bolder> decided;   // by the check or limit that such a value decides
  std::vector<Bolder> handed_on;           // without a reason, and no check of the step sees them: others do
  std::map<std::string, Message> reasons;  // by the input: how it is bolder, and why
  std::vector<std::string> compared;       // typed inputs that something stands beside
  bool compared_by_size = false;           // whether what stands beside one of them depends on a size
  bool holds_back = false;                 // whether modes are held back
};

/// An issue for everything typed that says of the part what the row or the record beside it does not: what was typed
/// may not make another part of it.
bool refuse_other_parts(const Evaluation& evaluation, const Known& known, std::vector<Issue>& issues);

/// Keeps the justification of each more favourable value, or holds back the modes that it decides. An unnecessary
/// justification is an issue where unused inputs are reported.
WeighedValues weigh_typed_values(Evaluation& evaluation, const Results& results, const Known& known,
                                 const Wanted& wanted, std::vector<Issue>& issues);

}  // namespace loadpath::project
