// The short answer: verdict, components, next sizes, what is not assessed, in at most 25 lines.
#pragma once

#include "lib/report/summary/summary.hpp"
#include "lib/report/terminal/look.hpp"

#include <string>

namespace loadpath::terminal {

/// The short answer for a project file.
std::string short_answer(const report::Summary& summary, const Look& look);
/// The short answer for one calculator on the shell: with the formulas of the governing check.
std::string short_answer(const report::Summary& summary, const project::Step& step, const Look& look);

/// Of one step: what governs it with all its formulas and the inputs that they start from.
std::string why_answer(const report::Summary& summary, const project::Step& step, const Look& look);

}  // namespace loadpath::terminal
