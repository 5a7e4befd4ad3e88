// What a report does not decide: outside the scope, accepted, not assessed, not considered; and its assumptions.
#pragma once

#include "lib/report/document.hpp"
#include "lib/report/summary/summary.hpp"

#include <vector>

namespace loadpath::report {

Panel outside_scope(const Summary& summary);
/// Accepted failure modes, and values with a reason.
Panel accepted_by_user(const Summary& summary, const project::Project& project);
Panel not_assessed(const Summary& summary);
Panel not_considered(const Summary& summary);
/// Factors with the place where each is applied, defaults, values not checked against a source, warnings.
Panel assumptions(const project::Project& project);

}  // namespace loadpath::report
