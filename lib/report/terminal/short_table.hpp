// The components of a project as a table: size, governing failure mode, utilisation.
#pragma once

#include "lib/report/summary/summary.hpp"
#include "lib/report/terminal/look.hpp"

#include <span>
#include <string>
#include <vector>

namespace loadpath::terminal {

/// Lines of the heads and of the components.
std::vector<std::string> component_lines(std::span<const report::Component> components, const Look& look);

/// The components that are shown where there is room for `most`: all that fail, then the most utilised ones, in their
/// order.
std::vector<report::Component> most_telling(const std::vector<report::Component>& components, std::size_t most);

}  // namespace loadpath::terminal
