// Typed values compared with table rows, records, strengths that bound them, and usual ranges. A value of another
// part is an error; a more favourable value holds back the modes that it decides until the user justifies it
// (lib/project/run/field_role.hpp).
#pragma once

#include "lib/project/modes.hpp"
#include "lib/project/run/evaluation/results.hpp"
#include "lib/project/run/field_role.hpp"

#include <map>
#include <string>
#include <vector>

namespace loadpath::project {

/// Typed values more favourable than their neighbours, and the modes that they decide.
struct WeighedValues {
  std::map<std::string, LessConservative> decided;  // by the check or limit that such a value decides
  std::vector<LessConservative> handed_on;          // without a reason, used only by other steps
  std::map<std::string, Message> reasons;           // by the input: how it is bolder, and why
  std::map<std::string, double> compared;  // typed inputs that have a neighbour: safe up to which value (Neighbour)
  std::vector<KeptBound> bounds;           // bounds that typed values keep
  bool compared_by_size = false;           // whether the neighbour of one of them depends on a size
  bool holds_back = false;                 // whether modes are held back
};

/// Reports an issue for each typed identifying value that differs from the row or the record: a typed value must not
/// turn it into another part.
bool refuse_other_parts(const Evaluation& evaluation, const Known& known, std::vector<Issue>& issues);

/// Keeps the justification of each more favourable value, or holds back the modes that it decides. An unnecessary
/// justification is an issue if unused inputs are reported.
WeighedValues weigh_typed_values(Evaluation& evaluation, const Results& results, const Known& known,
                                 const Wanted& wanted, std::vector<Issue>& issues);

}  // namespace loadpath::project
