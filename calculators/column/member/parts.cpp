#include "calculators/column/member/parts.hpp"

#include "calculators/column/member/length_factor.hpp"
#include "calculators/column/member/result.hpp"

namespace loadpath::column {

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
