#include "calculators/column/buckling_parts.hpp"

namespace loadpath::column {

Plates plates_of(const BucklingInput& in) {
  const Length wall = is_set(in.t_w) ? in.t_w : 0.5 * (in.d - in.d_bore);
  return {in.kind, in.grade, in.h, in.b, in.t_f, wall, in.r, in.d};
}

Length extreme_fibre(const BucklingInput& in, AxisName axis) {
  const bool about_y = axis == AxisName::y;
  const Length given = about_y ? in.c_y : in.c_z;
  if (is_set(given)) return given;
  const bool lopsided = in.kind == Profile::angle || in.kind == (about_y ? Profile::tee : Profile::channel);
  if (lopsided) return unset<Length>;
  return 0.5 * (is_set(in.d) ? in.d : about_y ? in.h : in.b);
}

bool fibre_known(const BucklingInput& in) {
  const auto known = [&](Length e, AxisName axis) { return !(e > 0.0 * mm) || is_set(extreme_fibre(in, axis)); };
  return known(in.e_y, AxisName::y) && known(in.e_z, AxisName::z);
}

Curve curve_of(const BucklingInput& in, AxisName axis) {
  const Curve given = axis == AxisName::y ? in.curve_y : in.curve_z;
  return given != Curve::by_kind ? given : buckling_curve(plates_of(in), axis);
}

}  // namespace loadpath::column
