// The outcome of all checks in words, and the numbers of headings, tables and figures.
#pragma once

#include <string>

#include "lib/report/document.hpp"

namespace loadpath::report {

/// "pass", "not covered".
Message word(State state);

/// The outcome of all rows: the worst of them.
State outcome(const Verdicts& verdicts);

/// What decides: how many rows hold, and the highest utilisation.
std::vector<Message> reasons(const Verdicts& verdicts);

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
