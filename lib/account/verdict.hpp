// A check or a limit and how it came out.
#pragma once

#include "lib/account/cell.hpp"
#include "lib/account/state.hpp"
#include "lib/text/issue.hpp"

#include <optional>
#include <string>
#include <vector>

namespace loadpath::account {

/// The values compared by a check, in one unit: its utilisation is their ratio.
struct Compared {
  Quantity demand, capacity;
};

/// The writer draws a bar for a utilisation.
struct Verdict {
  std::string step;    // "crankshaft"
  std::string symbol;  // "u_tau"
  Message meaning;
  std::optional<double> utilisation = {};  // none for a limit
  Cell value = {};                         // compared quantity
  Message bound;                           // "passes at 1 or less", "0 to 0.9"
  State state = State::not_available;
  Message note = {};                      // for the governing row, the reason why it is not covered; may be empty
  std::optional<Compared> compared = {};  // if the formula of the check is one value over another
  std::optional<Quantity> at = {};        // the position of a series where it governs
};
struct Verdicts {
  std::vector<Verdict> rows;
};
/// The state of all of them: the worst.
State worst(const std::vector<Verdict>& verdicts);

}  // namespace loadpath::account
