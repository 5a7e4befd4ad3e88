// Rows of the terminal's columns: values, lines of a calculation, failure modes.
#pragma once

#include "lib/account/account.hpp"

#include <string>
#include <vector>

namespace loadpath::terminal {

using Row = std::vector<std::string>;

/// A word, a quantity, the extremes of a series with their places; or the reason for a missing value.
std::string value_text(const account::Entry& entry);

/// "u = F / A", its value and its source; `in_element`: behind the name of the element that it belongs to.
Row line_row(const account::Derived& line, bool in_element);

/// The state of a mode, with its name in context: "rod.yield" for a project, "yield" for a step.
Row mode_row(const account::Mode& mode, const std::string& name);

/// The modes as columns, first those that need action; modes that no input would permit to assess share a line for
/// each reason. `of_project`: named with their steps.
std::string mode_columns(const account::Modes& modes, bool of_project);

}  // namespace loadpath::terminal
