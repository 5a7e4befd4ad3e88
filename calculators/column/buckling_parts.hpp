// What the sources of column.buckling share.
#pragma once

#include "calculators/column/buckling.hpp"
#include "calculators/column/eurocode.hpp"
#include "calculators/column/member_parts.hpp"

namespace loadpath::column {

Plates plates_of(const Buckling::Input& in);
/// About an axis: as given, else by the kind of section.
Curve curve_of(const Buckling::Input& in, AxisName axis);

}  // namespace loadpath::column
