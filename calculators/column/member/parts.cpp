#include "calculators/column/member/parts.hpp"

#include "calculators/column/member/length_factor.hpp"
#include "calculators/column/member/result.hpp"

namespace loadpath::column {

Material material_of(const Member& in) {
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

Ends ends_of(const Member& in, AxisName axis) {
  const Ends own = axis == AxisName::y ? in.ends_y : in.ends_z;
  return own != Ends::unsaid ? own : in.ends;
}

const Member::Supports& supports_of(const Member& in, AxisName axis) {
  return axis == AxisName::y ? in.supports_y : in.supports_z;
}

Bar bar_of(const Member& in, AxisName axis) {
  Bar bar = bar_of(ends_of(in, axis));
  for (const auto& support : supports_of(in, axis)) bar.supports.push_back(support.x / in.l);
  return bar;
}

bool has_modulus_of_steel(const Member& in) {
  const double x = in.E / steel_modulus;
  return !(x < least_steel || x > most_steel);
}

bool is_steel(const Member& in) {
  return in.material_class == Class::steel || (in.material_class == Class::unsaid && has_modulus_of_steel(in));
}

}  // namespace loadpath::column
