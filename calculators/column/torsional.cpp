#include "calculators/column/torsional.hpp"

namespace loadpath::column {

namespace {

/// By the middle lines of web and flanges.
Twisting of_channel(const BucklingInput& in) {
  const Length b = in.b - 0.5 * in.t_w, h = in.h - in.t_f;
  const Length whole = 6.0 * b + h * (in.t_w / in.t_f);  // of flanges and web, over the thickness of a flange
  const Length e = 3.0 * b * (b / whole);                // from the middle line of the web, outwards
  const Length web = in.h - 2.0 * in.t_f;
  const Length y_S = (in.b * in.b * in.t_f + 0.5 * web * in.t_w * in.t_w) / (2.0 * in.b * in.t_f + web * in.t_w);
  Twisting twist;
  twist.I_t = (2.0 * in.b * pow<3>(in.t_f) + web * pow<3>(in.t_w)) / 3.0;
  twist.I_w = in.t_f * pow<3>(b) * pow<2>(h) / 12.0 * ((3.0 * b + 2.0 * h * (in.t_w / in.t_f)) / whole);
  twist.e = e + y_S - 0.5 * in.t_w;
  return twist;
}

/// Walls that meet in one line do not warp along it, and turn about it.
Twisting of_tee(const BucklingInput& in) {
  const Length web = in.h - in.t_f;
  const Length z_S =
      (0.5 * in.b * in.t_f * in.t_f + in.t_w * web * 0.5 * (in.h + in.t_f)) / (in.b * in.t_f + in.t_w * web);
  return {(in.b * pow<3>(in.t_f) + web * pow<3>(in.t_w)) / 3.0, 0.0 * mm6.one, z_S - 0.5 * in.t_f};
}

Twisting of_angle(const BucklingInput& in) {
  const Length t = flange_of(in), leg = in.h - t;
  const Length c = (0.5 * in.h * in.h + 0.5 * leg * t) / (in.h + leg);  // of the centroid from the back of a leg
  return {(in.h + leg) * pow<3>(t) / 3.0, 0.0 * mm6.one, std::sqrt(2.0) * (c - 0.5 * t)};
}

SecondMoment moment_about(const BucklingInput& in, AxisName axis) {
  const SecondMoment I = axis == AxisName::y ? in.I_y : in.I_z;
  const Length i = axis == AxisName::y ? in.i_y : in.i_z;
  return is_set(I) ? I : in.A * i * i;
}

}  // namespace

Twisting twisting_by_walls(const BucklingInput& in) {
  const bool sides = is_set(in.h) && is_set(in.b);
  if (in.kind == SectionKind::angle)
    return sides && is_set(flange_of(in)) && in_si(in.h) == in_si(in.b) ? of_angle(in) : Twisting{};
  if (!sides || !is_set(in.t_f) || !is_set(in.t_w)) return {};
  if (in.kind == SectionKind::channel) return of_channel(in);
  return in.kind == SectionKind::tee ? of_tee(in) : Twisting{};
}

Twisting twisting_of(const BucklingInput& in) {
  if (!is_set(in.A)) return {};
  Twisting twist = twisting_by_walls(in);
  const bool known = in.kind == SectionKind::channel || in.kind == SectionKind::tee || is_set(twist.e);
  if (!known) return {};
  if (is_set(in.I_t)) twist.I_t = in.I_t;
  if (is_set(in.I_w)) twist.I_w = in.I_w;
  if (is_set(in.y_M)) twist.e = in.y_M;
  return twist;
}

Length twisting_length(const BucklingInput& in) {
  if (is_set(in.l_T)) return in.l_T;
  const auto is_loose = [&](AxisName axis) {
    const double beta = axis == AxisName::y ? in.beta_y : in.beta_z;
    if (is_set(beta)) return beta > 1.0;
    const Ends ends = ends_of(in, axis);
    return ends == Ends::fixed_free || ends == Ends::fixed_guided || ends == Ends::pinned_guided;
  };
  return is_loose(AxisName::y) || is_loose(AxisName::z) ? 2.0 * in.l : in.l;
}

SecondMoment polar_moment(const BucklingInput& in) {
  return moment_about(in, AxisName::y) + moment_about(in, AxisName::z);
}

SecondMoment moment_of_symmetry(const BucklingInput& in) {
  if (in.kind == SectionKind::channel) return moment_about(in, AxisName::y);
  if (in.kind == SectionKind::tee) return moment_about(in, AxisName::z);
  return in.kind == SectionKind::angle && is_set(in.I_min) ? polar_moment(in) - in.I_min : unset<SecondMoment>;
}

Length length_of_symmetry(const BucklingInput& in, const MemberResult& r) {
  if (in.kind == SectionKind::channel) return r.axes[0].s;
  return in.kind == SectionKind::tee ? r.axes[1].s : max(r.axes[0].s, r.axes[1].s);
}

}  // namespace loadpath::column
