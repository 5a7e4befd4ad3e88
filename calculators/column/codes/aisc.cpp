// Table B4.1a: cases 1, 2 and 5 (flanges of rolled and welded I, webs) as applied in public programs; legs of angles,
// stems of tees, walls of tubes and boxes recalled. E7 (2016 and later): a part is fully effective up to lambda_r
// sqrt(F_y/F_cr); a round tube up to 0.11 E/F_y, whatever the stress.
#include "calculators/column/codes/aisc.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::column {

namespace {

double over(Length width, Length thickness) { return width / thickness; }

/// Width-to-thickness ratio of the parts over their lambda_r/sqrt(E/F_y).
double thinness(const Plates& s, Length web) {
  const Length r = is_set(s.r) ? s.r : 0.0 * mm, flange = is_set(s.t_f) ? s.t_f : web;
  const double clear = over(s.h - 2.0 * (s.t_f + r), s.t_w), half = over(0.5 * s.b, s.t_f);
  switch (s.kind) {
    case SectionKind::rolled_I:
      return std::max(half / 0.56, clear / 1.49);
    case SectionKind::welded_I:
      return std::max(half / (0.64 * std::sqrt(std::clamp(4.0 / std::sqrt(clear), 0.35, 0.76))), clear / 1.49);
    case SectionKind::channel:
      return std::max(2.0 * half / 0.56, clear / 1.49);
    case SectionKind::tee:
      return std::max(half / 0.56, over(s.h, s.t_w) / 0.75);
    case SectionKind::angle:
      return over(max(s.h, s.b), web) / 0.45;
    case SectionKind::hot_hollow:
    case SectionKind::cold_hollow:
      return over(max(s.h, s.b) - 3.0 * web, web) / 1.40;
    case SectionKind::welded_box:
      return std::max(over(s.b - 2.0 * web, flange), over(s.h - 2.0 * flange, web)) / 1.40;
    case SectionKind::solid:
      return 0.0;
    case SectionKind::unsaid:
      return unset<double>;
  }
  return unset<double>;
}

}  // namespace

double slender_ratio(const Plates& s, Stress E, Stress R_e, Stress F_cr) {
  const Length web = is_set(s.t_w) ? s.t_w : s.t_f;
  const bool is_open = s.kind == SectionKind::rolled_I || s.kind == SectionKind::welded_I ||
                       s.kind == SectionKind::channel || s.kind == SectionKind::tee || s.kind == SectionKind::angle;
  if (s.kind != SectionKind::solid && !is_open && is_set(s.d)) return s.d / web / (0.11 * (E / R_e));
  return thinness(s, web) * std::sqrt(F_cr / E);
}

}  // namespace loadpath::column
