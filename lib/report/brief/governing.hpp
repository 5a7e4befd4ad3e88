// The failure modes that govern, with demand, capacity and safety factors.
#pragma once

#include "lib/report/document.hpp"
#include "lib/report/summary/summary.hpp"

#include <optional>
#include <string>
#include <vector>

namespace loadpath::report {

/// A failure mode in the table of page 1.
struct Governing {
  std::string component;
  account::Mode mode;
};
/// The governing mode of each component, then the next modes by utilisation; the failing ones on top.
std::vector<Governing> governing_modes(const project::Project& project, const Summary& summary, std::size_t most);

/// How far a part is from its limit: "2.54 / 1.5", or where the margin is included: "in sigma_adm".
std::string safety_text(const project::Project& project, const account::Mode& mode);

/// The table of page 1, with the titles of steps or their names.
Table governing_table(const project::Project& project, const std::vector<Governing>& rows, bool has_titles);

/// "10 of 28 with a utilisation": the share of the modes that the table shows.
Message share_shown(const Summary& summary, std::size_t shown);

/// The title of a mode without parentheses, and where it governs: "fatigue of sections and notches, key end".
std::string mode_name(const account::Mode& mode);

}  // namespace loadpath::report
