// Values derived from the inputs of a column.
#pragma once

#include "calculators/column/codes/curves.hpp"
#include "calculators/column/member/member.hpp"

#include <cmath>

namespace loadpath::column {

/// The curves' constants as the input gives them; lambda_T by the transition that it chooses.
inline Material material_of(const Member& in) {
  Material material;
  material.E = in.E, material.R_e = in.R_e;
  material.a_T = in.a_T, material.b_T = in.b_T;
  if (is_set(in.c_T)) material.c_T = in.c_T;
  if (is_set(in.lambda_0)) material.lambda_0 = in.lambda_0;
  material.sigma_c = in.sigma_c, material.a_R = in.a_R;
  if (is_set(in.a_T) && is_set(in.b_T) && is_set(in.E))
    material.lambda_T = in.transition == Transition::published ? in.lambda_1 : tetmajer_transition(material);
  material.lambda_1 = is_set(in.sigma_P) ? pi * std::sqrt(in_si(in.E) / in_si(in.sigma_P)) : material.lambda_T;
  return material;
}
inline Ends ends_of(const Member& in, AxisName axis) {
  const Ends own = axis == AxisName::y ? in.ends_y : in.ends_z;
  return own != Ends::unsaid ? own : in.ends;
}

inline const Member::Supports& supports_of(const Member& in, AxisName axis) {
  return axis == AxisName::y ? in.supports_y : in.supports_z;
}
/// The bar between its ends with the supports that hinder bending about the axis.
Bar bar_of(const Member& in, AxisName axis);
/// Whether its modulus is that of steel, as far as it is known.
bool has_modulus_of_steel(const Member& in);
/// Whether the codes for steel structures apply to the material.
bool is_steel(const Member& in);

/// Default method: tetmajer with the constants of a set; ec3 for a steel section with a buckling curve, unless a safety
/// factor n_st is given, which it does not use; Johnson's parabola, and Euler above it, for any other bar with known
/// yield strength; Euler if only a proportional limit is known.
inline Method default_method(const Member& in, bool is_structural) {
  if (is_set(in.a_T)) return Method::tetmajer;
  const bool by_factor = is_set(in.n_st) && !is_set(in.gamma_M1) && !is_set(in.gamma_F);
  if (is_set(in.R_e)) return is_structural && is_steel(in) && !by_factor ? Method::ec3 : Method::johnson;
  return is_set(in.sigma_P) ? Method::euler : Method::unsaid;
}

}  // namespace loadpath::column
