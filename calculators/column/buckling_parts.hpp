// What the sources of column.buckling share.
#pragma once

#include "calculators/column/buckling.hpp"
#include "calculators/column/curves.hpp"
#include "calculators/column/eurocode.hpp"

namespace loadpath::column {

/// The curves' constants as the input gives them; lambda_T by the transition that it chooses.
Material material_of(const Buckling::Input& in);
Plates plates_of(const Buckling::Input& in);
/// About an axis: as given, else by the kind of section.
Curve curve_of(const Buckling::Input& in, AxisName axis);
Ends ends_of(const Buckling::Input& in, AxisName axis);
const Buckling::Supports& supports_of(const Buckling::Input& in, AxisName axis);
/// The bar between its ends with the supports that hinder bending about the axis.
Bar bar_of(const Buckling::Input& in, AxisName axis);
/// Whether the codes for steel structures hold for the material.
bool is_steel(const Buckling::Input& in);

}  // namespace loadpath::column
