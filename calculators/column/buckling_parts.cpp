#include "calculators/column/buckling_parts.hpp"

namespace loadpath::column {

/// By its kind; without one a bar of d, or of h and b, is known too, and what is full by its area and moments.
Outline Buckling::outline_of(const Input& in) {
  switch (in.kind) {
    case Profile::rolled_I:
    case Profile::welded_I:
      return Outline::two_flanges;
    case Profile::channel:
    case Profile::tee:
    case Profile::angle:
      return Outline::open;
    case Profile::hot_hollow:
    case Profile::cold_hollow:
    case Profile::welded_box:
      return Outline::closed;
    case Profile::solid:
      return Outline::solid;
    case Profile::unsaid:
      break;
  }
  if (is_set(in.d)) return is_set(in.A) || in.d_bore > 0.0 * mm ? Outline::closed : Outline::solid;
  return is_set(in.A) && !is_full(in) ? Outline::unknown : Outline::solid;
}

Plates plates_of(const Buckling::Input& in) {
  const Length wall = is_set(in.t_w) ? in.t_w : 0.5 * (in.d - in.d_bore);
  return {in.kind, in.grade, in.h, in.b, in.t_f, wall, in.r, in.d};
}

Length extreme_fibre(const Buckling::Input& in, AxisName axis) {
  const bool about_y = axis == AxisName::y;
  const Length given = about_y ? in.c_y : in.c_z;
  if (is_set(given)) return given;
  const bool lopsided = in.kind == Profile::angle || in.kind == (about_y ? Profile::tee : Profile::channel);
  if (lopsided) return unset<Length>;
  return 0.5 * (is_set(in.d) ? in.d : about_y ? in.h : in.b);
}

bool fibre_known(const Buckling::Input& in) {
  const auto known = [&](Length e, AxisName axis) { return !(e > 0.0 * mm) || is_set(extreme_fibre(in, axis)); };
  return known(in.e_y, AxisName::y) && known(in.e_z, AxisName::z);
}

Curve curve_of(const Buckling::Input& in, AxisName axis) {
  const Curve given = axis == AxisName::y ? in.curve_y : in.curve_z;
  return given != Curve::by_kind ? given : buckling_curve(plates_of(in), axis);
}

}  // namespace loadpath::column
