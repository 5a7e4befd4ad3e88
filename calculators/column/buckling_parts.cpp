#include "calculators/column/buckling_parts.hpp"

namespace loadpath::column {

Plates plates_of(const Buckling::Input& in) { return {in.kind, in.grade, in.h, in.b, in.t_f, in.t_w, in.r, in.d}; }

Curve curve_of(const Buckling::Input& in, AxisName axis) {
  const Curve given = axis == AxisName::y ? in.curve_y : in.curve_z;
  return given != Curve::by_kind ? given : buckling_curve(plates_of(in), axis);
}

}  // namespace loadpath::column
