// The level of detail of a report.
#pragma once

namespace loadpath::report {

enum class Detail {
  brief,   // the answer: what was chosen, what governs, what is not assessed
  normal,  // with what each part was given, what decides over it, worked out, and its results
  full     // with all lists, every formula, and the input as it was
};

}  // namespace loadpath::report
