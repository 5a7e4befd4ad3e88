// The level of detail of a report.
#pragma once

namespace loadpath::report {

enum class Detail {
  brief,   // the answer: choices, governing modes, modes not assessed
  normal,  // with the inputs of each part, its governing checks, worked out, and its results
  full     // with all lists, every formula, and the unchanged input
};

}  // namespace loadpath::report
