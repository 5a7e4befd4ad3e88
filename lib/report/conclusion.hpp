// The outcome of all checks in words, and the numbers of headings, tables and figures.
#pragma once

#include "lib/report/document.hpp"

#include <string>

namespace loadpath::report {

/// How many rows hold, or do not: "1 of 5 checks not met."
Message tally(const Verdicts& verdicts);

/// The row with the highest utilisation, or none, and what it is announced with.
const Verdict* most_utilised(const Verdicts& verdicts);
Message utilisation(const Verdict& row);

/// Counts through a document.
class Numbering {
 public:
  /// "2" or "2.1"
  std::string heading(int level);
  int table() { return ++tables_; }
  int figure() { return ++figures_; }

 private:
  int sections_ = 0, parts_ = 0, tables_ = 0, figures_ = 0;
};

}  // namespace loadpath::report
