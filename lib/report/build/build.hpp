// The report of a solved project, as a document: the pages that decide, and the appendix that proves.
#pragma once

#include "lib/project/project.hpp"
#include "lib/report/detail.hpp"
#include "lib/report/document.hpp"

#include <string_view>

namespace loadpath::report {

/// `input`: the text of the project, for its fingerprint, and for the appendix of a full report.
Document build(const project::Project& project, std::string_view program, Detail detail = Detail::normal,
               std::string_view input = {});

}  // namespace loadpath::report
