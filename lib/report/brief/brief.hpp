// The first pages of a report: page 1 suffices to decide, page 2 to check, page 3 to recompute.
#pragma once

#include "lib/project/project.hpp"
#include "lib/report/appendix.hpp"
#include "lib/report/document.hpp"
#include "lib/report/summary/summary.hpp"

#include <string>
#include <vector>

namespace loadpath::report {

/// `input`: the identification of the input, of which the block shows the beginning.
TitleBlock title_block(const project::Project& project, const Summary& summary, const std::string& input);

/// The headline, the modes that it is about, the number that pass, and the highest utilisation.
Finding finding_of(const Summary& summary);

struct Brief {
  std::vector<Page> pages;
  ShownFigures shown;  // in full
};
/// At most three pages; a project of one step with a short derivation has one.
Brief brief_of(const project::Project& project, const Summary& summary);

}  // namespace loadpath::report
