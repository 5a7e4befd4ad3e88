// What EN 1993-1-1:2005 says of a section in compression: its buckling curves and how thin its parts may be.
#pragma once

#include "calculators/column/codes/choices.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath::column {

/// Of a section, as far as it is known.
struct Plates {
  Profile kind = Profile::unsaid;
  Grade grade = Grade::to_S420;
  Length h = unset<Length>, b = unset<Length>, t_f = unset<Length>, t_w = unset<Length>, r = unset<Length>;
  Length d = unset<Length>;
};

/// Table 6.2; Curve::by_kind where the section is not in the table, or too little of it is known.
Curve buckling_curve(const Plates& section, AxisName axis);

/// Table 6.1; NaN for Curve::by_kind.
double imperfection(Curve curve);
/// "curve b, [...] table 6.1" as the reason of a step.
const char* imperfection_reason(Curve curve);

/// The largest width-to-thickness ratio of the parts over the limit of class 3, table 5.2: above 1 the section buckles
/// locally. Of a round tube that of d over its wall, whatever the kind; of a welded box between its plates. NaN where
/// the thicknesses are not known.
double class_ratio(const Plates& section, Stress R_e);
/// The thinnest part over the limit of AISC 360, table B4.1a, raised by the root of R_e over the critical stress as E7
/// says: at 1 or less the whole area counts. Unset where the kind is not known.
double slender_ratio(const Plates& section, Stress E, Stress R_e, Stress sigma_cr);

}  // namespace loadpath::column
