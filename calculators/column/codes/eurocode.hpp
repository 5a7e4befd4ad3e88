// Sections in compression by EN 1993-1-1:2005: buckling curves and limits of the plate slenderness.
#pragma once

#include "calculators/column/codes/choices.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath::column {

/// Dimensions of a section, as far as known.
struct Plates {
  SectionKind kind = SectionKind::unsaid;
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

/// The largest width-to-thickness ratio of the parts over the limit of class 3, table 5.2: above 1 the section
/// buckles locally. For a round tube of any kind d over its wall; for a welded box between its plates. NaN if the
/// thicknesses are unknown.
double class_ratio(const Plates& section, Stress R_e);

}  // namespace loadpath::column
