// What AISC 360 says of the walls of a section in compression.
#pragma once

#include "calculators/column/codes/eurocode.hpp"

namespace loadpath::column {

/// The largest width-to-thickness ratio of the parts over that up to which their whole area counts under the critical
/// stress F_cr, E7: above 1 the area has to be reduced. NaN where the thicknesses are not known.
double slender_ratio(const Plates& section, Stress E, Stress R_e, Stress F_cr);

}  // namespace loadpath::column
