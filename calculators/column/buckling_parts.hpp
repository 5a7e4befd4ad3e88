// What the sources of column.buckling share.
#pragma once

#include "calculators/column/buckling.hpp"
#include "calculators/column/eurocode.hpp"
#include "calculators/column/member_parts.hpp"

namespace loadpath::column {

/// With what its section adds.
Material material_of(const Buckling::Input& in);
/// The type of section of SP 16.13330; unset for a kind that is none of them.
const Sp16Type& sp16_type(Profile kind);
Plates plates_of(const Buckling::Input& in);
/// About an axis: as given, else by the kind of section.
Curve curve_of(const Buckling::Input& in, AxisName axis);

}  // namespace loadpath::column
