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
    case Profile::rolled_I:
      return rolled_I(s.h / s.b, t_f, about_y);
    case Profile::welded_I:
      return welded_I(t_f, about_y);
    case Profile::hot_hollow:
      return {a, a0};
    case Profile::cold_hollow:
    case Profile::channel:
    case Profile::tee:
    case Profile::solid:
      return {c, c};
    case Profile::welded_box:
    case Profile::angle:
      return {b, b};
    case Profile::unsaid:
      return {by_kind, by_kind};
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

/// The limits of the table are recalled; E7 agrees with a published 60.0 of the web of a W16X36.
double slender_ratio(const Plates& s, Stress E, Stress R_e, Stress sigma_cr) {
  const double root = std::sqrt(E / R_e), raised = root * std::sqrt(R_e / sigma_cr);
  const Length r = is_set(s.r) ? s.r : 0.0 * mm;
  const Length web = is_set(s.t_w) ? s.t_w : s.t_f;
  const double outstand = 0.56 * raised, internal = 1.49 * raised;
  const double tube = s.d / web / (0.11 * root * root);
  const double flange = s.b / s.t_f;
  const double stem = s.h / s.t_w;
  const double h_w = (s.h - 2.0 * (s.t_f + r)) / s.t_w;
  switch (s.kind) {
    case Profile::rolled_I:
      return std::max(0.5 * flange / outstand, h_w / internal);
    case Profile::welded_I: {
      const double k_c = std::clamp(4.0 / std::sqrt(h_w), 0.35, 0.76);
      return std::max(0.5 * flange / (0.64 * std::sqrt(k_c) * raised), h_w / internal);
    }
    case Profile::channel:
      return std::max(flange / outstand, h_w / internal);
    case Profile::tee:
      return std::max(0.5 * flange / outstand, stem / (0.75 * raised));
    case Profile::welded_box:
    case Profile::hot_hollow:
    case Profile::cold_hollow:
      if (is_set(s.d)) return tube;
      return (max(s.h, s.b) - 3.0 * web) / web / (1.40 * raised);
    case Profile::angle:
      return max(s.h, s.b) / web / (0.45 * raised);
    case Profile::solid:
      return 0.0;
    case Profile::unsaid:
      return tube;
  }
  return unset<double>;
}

double class_ratio(const Plates& s, Stress R_e) {
  const double epsilon = std::sqrt(235e6 / in_si(R_e));
  const Length r = is_set(s.r) ? s.r : 0.0 * mm;
  const Length web = is_set(s.t_w) ? s.t_w : s.t_f;
  const double outstand = 14.0 * epsilon, internal = 42.0 * epsilon;
  const double tube = s.d / web / (90.0 * epsilon * epsilon);  // hot finished or cold formed alike
  switch (s.kind) {
    case Profile::rolled_I:
    case Profile::welded_I:
      return std::max((s.b - s.t_w - 2.0 * r) / (2.0 * s.t_f) / outstand, (s.h - 2.0 * (s.t_f + r)) / s.t_w / internal);
    case Profile::channel:
      return std::max((s.b - s.t_w - r) / s.t_f / outstand, (s.h - 2.0 * (s.t_f + r)) / s.t_w / internal);
    case Profile::tee:
      return std::max((s.b - s.t_w - 2.0 * r) / (2.0 * s.t_f) / outstand, (s.h - s.t_f - r) / s.t_w / outstand);
    case Profile::welded_box: {
      if (is_set(s.d)) return tube;
      const Length flange = is_set(s.t_f) ? s.t_f : web;
      return std::max((s.b - 2.0 * web) / flange, (s.h - 2.0 * flange) / web) / internal;
    }
    case Profile::hot_hollow:
    case Profile::cold_hollow:
      if (is_set(s.d)) return tube;
      return (max(s.h, s.b) - 3.0 * web) / web / internal;
    case Profile::angle:
      return std::max(max(s.h, s.b) / web / (15.0 * epsilon), (s.h + s.b) / (2.0 * web) / (11.5 * epsilon));
    case Profile::solid:
      return 0.0;
    case Profile::unsaid:
      return tube;
  }
  return unset<double>;
}

}  // namespace loadpath::column
