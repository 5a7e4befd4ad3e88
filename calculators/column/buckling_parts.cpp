#include "calculators/column/buckling_parts.hpp"

namespace loadpath::column {

/// A bar given by d, or by h and b, without a kind is solid.
Plates plates_of(const BucklingInput& in) {
  const Length wall = is_set(in.t_w) ? in.t_w : 0.5 * (in.d - in.d_bore);
  const bool is_plain = in.kind == SectionKind::unsaid && !is_set(in.A) && is_solid(in);
  return {is_plain ? SectionKind::solid : in.kind, in.grade, in.h, in.b, in.t_f, wall, in.r, in.d};
}

bool is_solid(const BucklingInput& in) {
  if (in.kind != SectionKind::unsaid) return in.kind == SectionKind::solid;
  if (is_set(in.d)) return !is_set(in.A) && !(bore_of(in) > 0.0 * mm);
  return is_set(in.A) ? is_full(in) : !is_walled(in);
}

Length extreme_fibre(const BucklingInput& in, AxisName axis) {
  const bool about_y = axis == AxisName::y;
  const Length given = about_y ? in.c_y : in.c_z;
  const bool lopsided = in.kind == SectionKind::angle || in.kind == (about_y ? SectionKind::tee : SectionKind::channel);
  const Length half = 0.5 * (is_set(in.d) ? in.d : about_y ? in.h : in.b);
  if (!is_set(given)) return lopsided ? unset<Length> : half;
  return is_set(half) ? max(given, half) : given;  // no fibre of a side is nearer than half of it
}

bool fibre_known(const BucklingInput& in) {
  const auto known = [&](bool offset, AxisName axis) { return !offset || is_set(extreme_fibre(in, axis)); };
  return known(is_offset_about_y(in), AxisName::y) && known(is_offset_about_z(in), AxisName::z);
}

Curve curve_of(const BucklingInput& in, AxisName axis) {
  const Curve given = axis == AxisName::y ? in.curve_y : in.curve_z;
  return given != Curve::by_kind ? given : buckling_curve(plates_of(in), axis);
}

}  // namespace loadpath::column
