#include "calculators/column/codes/eurocode.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::column {

namespace {

/// The curve for S235 to S420 and that for S460.
struct Pair {
  Curve usual, strong;
};

Pair rolled_I(double h_b, double t_f, bool about_y) {
  using enum Curve;
  if (h_b > 1.2) {
    if (t_f <= 0.040) return about_y ? Pair{a, a0} : Pair{b, a0};
    if (t_f <= 0.100) return about_y ? Pair{b, a} : Pair{c, a};
    return {by_kind, by_kind};
  }
  if (t_f <= 0.100) return about_y ? Pair{b, a} : Pair{c, a};
  return t_f > 0.100 ? Pair{d, c} : Pair{by_kind, by_kind};
}

Pair welded_I(double t_f, bool about_y) {
  using enum Curve;
  if (t_f <= 0.040) return about_y ? Pair{b, b} : Pair{c, c};
  return t_f > 0.040 ? (about_y ? Pair{c, c} : Pair{d, d}) : Pair{by_kind, by_kind};
}

Pair curves_of(const Plates& s, bool about_y) {
  using enum Curve;
  const double t_f = in_si(s.t_f);
  switch (s.kind) {
    case SectionKind::rolled_I:
      return rolled_I(s.h / s.b, t_f, about_y);
    case SectionKind::welded_I:
      return welded_I(t_f, about_y);
    case SectionKind::hot_hollow:
      return {a, a0};
    case SectionKind::cold_hollow:
    case SectionKind::channel:
    case SectionKind::tee:
    case SectionKind::solid:
      return {c, c};
    case SectionKind::welded_box:
    case SectionKind::angle:
      return {b, b};
    case SectionKind::unsaid:  // a tube, hot finished or cold formed: the less favourable curve
      return is_set(s.d) && is_set(s.t_w) ? Pair{c, c} : Pair{by_kind, by_kind};
  }
  return {by_kind, by_kind};
}

}  // namespace

Curve buckling_curve(const Plates& section, AxisName axis) {
  const Pair pair = curves_of(section, axis == AxisName::y);
  return section.grade == Grade::S460 ? pair.strong : pair.usual;
}

double imperfection(Curve curve) {
  switch (curve) {
    case Curve::by_kind:
      return unset<double>;
    case Curve::a0:
      return 0.13;
    case Curve::a:
      return 0.21;
    case Curve::b:
      return 0.34;
    case Curve::c:
      return 0.49;
    case Curve::d:
      return 0.76;
  }
  return unset<double>;
}

const char* imperfection_reason(Curve curve) {
  switch (curve) {
    case Curve::by_kind:
      return "the section is not in table 6.2, [EN1993-1-1-buckling]";
    case Curve::a0:
      return "curve a0, table 6.1, [EN1993-1-1-buckling]";
    case Curve::a:
      return "curve a, table 6.1, [EN1993-1-1-buckling]";
    case Curve::b:
      return "curve b, table 6.1, [EN1993-1-1-buckling]";
    case Curve::c:
      return "curve c, table 6.1, [EN1993-1-1-buckling]";
    case Curve::d:
      return "curve d, table 6.1, [EN1993-1-1-buckling]";
  }
  return "";
}

double class_ratio(const Plates& s, Stress R_e) {
  const double epsilon = std::sqrt(235e6 / in_si(R_e));
  const Length r = is_set(s.r) ? s.r : 0.0 * mm;
  const Length web = is_set(s.t_w) ? s.t_w : s.t_f;
  const double outstand = 14.0 * epsilon, internal = 42.0 * epsilon;
  const double tube = s.d / web / (90.0 * epsilon * epsilon);  // hot finished or cold formed alike
  switch (s.kind) {
    case SectionKind::rolled_I:
    case SectionKind::welded_I:
      return std::max((s.b - s.t_w - 2.0 * r) / (2.0 * s.t_f) / outstand, (s.h - 2.0 * (s.t_f + r)) / s.t_w / internal);
    case SectionKind::channel:
      return std::max((s.b - s.t_w - r) / s.t_f / outstand, (s.h - 2.0 * (s.t_f + r)) / s.t_w / internal);
    case SectionKind::tee:
      return std::max((s.b - s.t_w - 2.0 * r) / (2.0 * s.t_f) / outstand, (s.h - s.t_f - r) / s.t_w / outstand);
    case SectionKind::welded_box: {
      if (is_set(s.d)) return tube;
      const Length flange = is_set(s.t_f) ? s.t_f : web;
      return std::max((s.b - 2.0 * web) / flange, (s.h - 2.0 * flange) / web) / internal;
    }
    case SectionKind::hot_hollow:
    case SectionKind::cold_hollow:
      if (is_set(s.d)) return tube;
      return (max(s.h, s.b) - 3.0 * web) / web / internal;
    case SectionKind::angle:
      return std::max(max(s.h, s.b) / web / (15.0 * epsilon), (s.h + s.b) / (2.0 * web) / (11.5 * epsilon));
    case SectionKind::solid:
      return 0.0;
    case SectionKind::unsaid:
      return tube;
  }
  return unset<double>;
}

}  // namespace loadpath::column
