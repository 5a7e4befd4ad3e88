// The outcome of all failure modes in words, and the numbers of headings, tables and figures.
#pragma once

#include "lib/report/document.hpp"

#include <string>

namespace loadpath::report {

/// The reason for the headline: the failing modes, or a search without result, and the number of modes by state.
Message conclusion_of(const Modes& modes);

/// The number of modes by state: "Of 6 failure modes: 1 not assessed, 4 pass, 1 not considered."
Message tally(const Modes& modes);

/// The mode with the highest utilisation, or none, and its announcement.
const Mode* most_utilised(const Modes& modes);
Message utilisation(const Mode& mode);

/// Whether the mode passes by a proof or a condition, without a utilisation: not worth a line of its own.
bool is_proved(const Mode& mode);
/// The modes with a row of their own, in order: first those that do not pass. Modes that pass by proof, and modes not
/// considered that no calculator assesses, are summarised in a line each, empty if there is none.
Modes doubtful(const Modes& modes);
Modes passing(const Modes& modes);
Message proved(const Modes& modes);
Message remote(const Modes& modes);

/// Counts through a document.
class Numbering {
 public:
  /// "2" or "2.1"; in the appendix "A2" or "A2.1"
  std::string heading(int level);
  /// Headings are counted from 1 again, with an A in front.
  void begin_appendix();
  int table() { return ++tables_; }
  int figure() { return ++figures_; }

 private:
  std::string prefix_;
  int sections_ = 0, parts_ = 0, tables_ = 0, figures_ = 0;
};

}  // namespace loadpath::report
