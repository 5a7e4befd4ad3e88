// The effective length factor beta = s/l of a column: the cases of its ends, on the basis that is chosen, or the
// characteristic equation where supports stand between the ends.
#pragma once

#include "calculators/column/codes/choices.hpp"
#include "calculators/column/member/stability.hpp"

namespace loadpath::column {

/// The ends of a case as springs; both hinged for Ends::unsaid.
Bar bar_of(Ends ends);

/// Of a case; NaN for Ends::unsaid.
double length_factor(Ends ends, Basis basis);
const char* length_factor_reason(Basis basis);

}  // namespace loadpath::column
