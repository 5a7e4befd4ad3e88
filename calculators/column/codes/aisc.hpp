// Wall slenderness of a section in compression by AISC 360.
#pragma once

#include "calculators/column/codes/eurocode.hpp"

namespace loadpath::column {

/// The largest width-to-thickness ratio of the parts over the limit of full effectiveness under the critical stress
/// F_cr, E7: above 1 the area has to be reduced. NaN if the thicknesses are unknown.
double slender_ratio(const Plates& section, Stress E, Stress R_e, Stress F_cr);

}  // namespace loadpath::column
