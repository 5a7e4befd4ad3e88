// The summary of a report: the choices, the governing verdicts, and the loads.
#pragma once

#include "lib/project/project.hpp"
#include "lib/report/document.hpp"

#include <optional>
#include <string>
#include <vector>

namespace loadpath::report {

/// A part that has a size, or a failure mode with a utilisation.
struct ChosenPart {
  std::string step;  // or the body that several steps describe
  std::string body = {};
  std::string sizes;              // "d = 45 mm", "IPE 200"; may be empty
  std::string reasons;            // "smallest of R40 with which no assessed mode fails; 42.5 mm fails: u_theta = 1.065"
  std::optional<Mode> governing;  // governing mode with a utilisation
  State state = State::open;      // combined state of all its modes
};
std::vector<ChosenPart> chosen_parts(const project::Project& project);

/// The same as a table.
Table chosen_table(const project::Project& project);

/// The flow of results between steps as loads, with the numbers; empty if no step takes from another.
draw::Flow load_path(const project::Project& project);

}  // namespace loadpath::report
