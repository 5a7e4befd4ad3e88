#include "calculators/column/bending/classes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::column {

namespace {

/// Limits of c/t over epsilon, of the classes 1 to 3.
using Limits = std::array<double, 3>;
constexpr Limits outstand{9.0, 10.0, 14.0}, internal{33.0, 38.0, 42.0}, tube{50.0, 70.0, 90.0};

struct Part {
  double slenderness;  // c/t over epsilon
  Limits limits;
};

/// The part of the web in compression when the section is fully plastic: N and M_y have grown alike until
/// M_y = M_pl - N^2/(4 t f_y).
double plastic_share(const Plates& s, Stress R_e, const WebStress& web, Length c) {
  if (!(in_si(web.N) > 0.0)) return 0.5;
  const double e = in_si(web.M_y) / in_si(web.N), strip = in_si(s.t_w * R_e);
  const double N = 2.0 * strip * (std::sqrt(e * e + in_si(web.M_pl) / strip) - e);
  return std::min(1.0, 0.5 * (1.0 + N / (in_si(c) * strip)));
}

/// Between even compression and pure bending.
Limits web_limits(double alpha, double psi) {
  const auto plastic = [&](double high, double low) { return alpha > 0.5 ? high / (13.0 * alpha - 1.0) : low / alpha; };
  return {plastic(396.0, 36.0), plastic(456.0, 41.5),
          psi > -1.0 ? 42.0 / (0.67 + 0.33 * psi) : 62.0 * (1.0 - psi) * std::sqrt(-psi)};
}

Part web_of_I(const Plates& s, Stress R_e, const WebStress& web, double epsilon) {
  const Length r = is_set(s.r) ? s.r : 0.0 * mm;
  const Length c = s.h - 2.0 * (s.t_f + r);
  const double mean = std::max(in_si(web.mean), 0.0), bending = in_si(web.bending), both = mean + bending;
  const double psi = both > 0.0 ? (mean - bending) / both : 1.0;
  const double alpha = both > 0.0 ? plastic_share(s, R_e, web, c) : 1.0;
  return {c / s.t_w / epsilon, web_limits(alpha, psi)};
}

SectionClass of_parts(const Part& first, const Part& second) {
  SectionClass result{1, 0.0};
  for (const Part& part : {first, second}) {
    int number = 1;
    for (const double limit : part.limits) number += part.slenderness <= limit ? 0 : 1;
    result.number = std::max(result.number, number);
    result.ratio = std::max(result.ratio, part.slenderness / part.limits[2]);
  }
  return result;
}

}  // namespace

SectionClass section_class(const Plates& s, Stress R_e, const WebStress& web) {
  const double epsilon = std::sqrt(235e6 / in_si(R_e));
  const Length r = is_set(s.r) ? s.r : 0.0 * mm, wall = is_set(s.t_w) ? s.t_w : s.t_f;
  const Length flange = is_set(s.t_f) ? s.t_f : wall;
  switch (s.kind) {
    case SectionKind::rolled_I:
    case SectionKind::welded_I:
      return of_parts({(s.b - s.t_w - 2.0 * r) / (2.0 * s.t_f) / epsilon, outstand}, web_of_I(s, R_e, web, epsilon));
    case SectionKind::hot_hollow:
    case SectionKind::cold_hollow:
    case SectionKind::welded_box: {
      if (is_set(s.d)) {
        const Part round{s.d / wall / (epsilon * epsilon), tube};
        return of_parts(round, round);
      }
      const bool is_welded = s.kind == SectionKind::welded_box;
      const Length corners = is_welded ? 2.0 * wall : 3.0 * wall, ends = is_welded ? 2.0 * flange : 3.0 * wall;
      return of_parts({(s.b - corners) / flange / epsilon, internal}, {(s.h - ends) / wall / epsilon, internal});
    }
    case SectionKind::solid:
      return {1, 0.0};
    default:
      return {};
  }
}

}  // namespace loadpath::column
