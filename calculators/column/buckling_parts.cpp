#include "calculators/column/buckling_parts.hpp"

namespace loadpath::column {

Material material_of(const Buckling::Input& in) {
  Material material = material_of(static_cast<const Member&>(in));
  material.sp16 = sp16_type(in.kind);
  return material;
}

const Sp16Type& sp16_type(Profile kind) {
  static constexpr Sp16Type a{0.03, 0.06, 0.6}, b{0.04, 0.09, 0.6}, c{0.04, 0.14, 0.4}, none{};
  switch (kind) {
    case Profile::hot_hollow:
    case Profile::cold_hollow:
    case Profile::welded_box:
      return a;
    case Profile::rolled_I:
    case Profile::welded_I:
      return b;
    case Profile::channel:
    case Profile::tee:
    case Profile::angle:
      return c;
    case Profile::solid:
    case Profile::unsaid:
      return none;
  }
  return none;
}

Plates plates_of(const Buckling::Input& in) { return {in.kind, in.grade, in.h, in.b, in.t_f, in.t_w, in.r, in.d}; }

Curve curve_of(const Buckling::Input& in, AxisName axis) {
  const Curve given = axis == AxisName::y ? in.curve_y : in.curve_z;
  return given != Curve::by_kind ? given : buckling_curve(plates_of(in), axis);
}

}  // namespace loadpath::column
