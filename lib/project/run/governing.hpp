// Results of the calculation at the governing position.
#pragma once

#include "lib/project/run/compared.hpp"

namespace loadpath::project {

/// The position where the largest check is largest, or the first that is available.
struct Governing {
  std::size_t position = 0;
  bool is_evaluated = false;     // otherwise there are no results
  Trace trace;                   // empty if no words are wanted
  ComparedValues compared = {};  // of every check, at the position of its maximum; empty if no words are wanted
};

/// Leaves the evaluation at the governing position. `in_words`: with the lines of the calculation, which are moved out
/// of the results if they are there.
Governing evaluate_governing(Evaluation& evaluation, Results& results, bool in_words);

}  // namespace loadpath::project
