#include "calculators/column/member/section.hpp"

namespace loadpath::column {

namespace {

/// Within the walls of a section given by its sizes; nothing within a solid one.
struct Hollow {
  Length d, h, b;
};

Hollow hollow_of(const Section& in) {
  const Length none = 0.0 * mm, bore = bore_of(in);
  if (is_set(in.d)) return {is_set(bore) ? bore : none, none, none};
  if (!is_walled(in)) return {none, none, none};
  return {none, in.h - 2.0 * flange_of(in), in.b - 2.0 * in.t_w};
}

}  // namespace

Area area_of(const Section& in) {
  if (is_set(in.A)) return in.A;
  const Hollow within = hollow_of(in);
  if (is_set(in.d)) return pi / 4.0 * (pow<2>(in.d) - pow<2>(within.d));
  return in.b * in.h - within.b * within.h;
}

SecondMoment moment_of_sizes(const Section& in, bool about_y) {
  const Hollow within = hollow_of(in);
  if (is_set(in.d)) return pi / 64.0 * (pow<4>(in.d) - pow<4>(within.d));
  if (about_y) return (in.b * pow<3>(in.h) - within.b * pow<3>(within.h)) / 12.0;
  return (in.h * pow<3>(in.b) - within.h * pow<3>(within.b)) / 12.0;
}

}  // namespace loadpath::column
