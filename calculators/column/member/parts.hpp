// What the inputs of a compressed bar stand for.
#pragma once

#include "calculators/column/codes/curves.hpp"
#include "calculators/column/member/member.hpp"

namespace loadpath::column {

/// The curves' constants as the input gives them; lambda_T by the transition that it chooses.
Material material_of(const Member& in);
Ends ends_of(const Member& in, AxisName axis);
const Member::Supports& supports_of(const Member& in, AxisName axis);
/// The bar between its ends with the supports that hinder bending about the axis.
Bar bar_of(const Member& in, AxisName axis);
/// Whether its modulus is that of steel, as far as it is known.
bool has_modulus_of_steel(const Member& in);
/// Whether the codes for steel structures hold for the material.
bool is_steel(const Member& in);

}  // namespace loadpath::column
