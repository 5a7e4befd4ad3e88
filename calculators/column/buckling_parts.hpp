// What the sources of column.buckling share.
#pragma once

#include "calculators/column/buckling.hpp"
#include "calculators/column/codes/eurocode.hpp"
#include "calculators/column/member/parts.hpp"

namespace loadpath::column {

/// With what its section adds.
Material material_of(const Buckling::Input& in);
/// The type of section of SP 16.13330; unset for a kind that is none of them.
const Sp16Type& sp16_type(Profile kind);
Plates plates_of(const Buckling::Input& in);
/// Its distance from the axis: as given, else half the side of a section that is symmetric to the axis; unset of a
/// channel about z, of a tee about y, of an angle.
Length extreme_fibre(const Buckling::Input& in, AxisName axis);
/// Whether it is for every eccentricity.
bool fibre_known(const Buckling::Input& in);
/// About an axis: as given, else by the kind of section.
Curve curve_of(const Buckling::Input& in, AxisName axis);

}  // namespace loadpath::column
