// All results of a step at all positions, and the findings of their evaluation.
#pragma once

#include "lib/project/run/evaluation/evaluation.hpp"

#include <optional>
#include <string>
#include <vector>

namespace loadpath::project {

/// A number of the result at every position.
struct ResultSeries {
  std::string path;
  const FieldInfo* field;
  Value value;
};

struct Results {
  std::vector<ResultSeries> series;  // empty if no position is available
  std::vector<Applies> applies;      // applicability of every mode, over the positions
  std::optional<Trace> trace = {};   // lines of the calculation, if there is one position
};

/// At the sizes that follow from the values of rows. `in_words`: with the lines of the calculation.
Results evaluate_all(Evaluation& evaluation, bool in_words = false);

/// Whether a result is requested, and not left unset by the calculator.
bool is_reported(const Evaluation& evaluation, const ResultSeries& series);

}  // namespace loadpath::project
