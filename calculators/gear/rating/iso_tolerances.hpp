// Tolerances of [ISO1328-1], edition 1995, which ISO 6336-1 of 2006 presumes: at the geometric means of the ranges of
// diameter, module and face width, rounded as the standard rounds them.
#pragma once

#include "calculators/gear/rating/wheels.hpp"

#include <array>

namespace loadpath::gear::rating {

/// The geometric mean of the range of a size, bounds in mm; beyond the ranges that of the nearest.
template <std::size_t n>
double mean_of_range(double size, const std::array<double, n>& bounds) {
  std::size_t i = 1;
  while (i + 1 < n && size > bounds[i]) ++i;
  return std::sqrt(bounds[i - 1] * bounds[i]);
}

/// Rounding to 1 um above 10 um, to 0.5 um from 5 um on, to 0.1 um below.
inline double rounded_tolerance(double f) {
  return f > 10.0 ? std::round(f) : f >= 5.0 ? std::round(2.0 * f) / 2.0 : std::round(10.0 * f) / 10.0;
}

/// Tolerances of one gear, um.
struct Tolerances {
  double f_pt, f_falpha, f_Hbeta;  // single pitch, profile form, helix slope
};

inline Tolerances tolerances_of(Length d, Length m_n, Length b, double grade) {
  constexpr std::array<double, 13> diameters{5, 20, 50, 125, 280, 560, 1000, 1600, 2500, 4000, 6000, 8000, 10000};
  constexpr std::array<double, 9> modules{0.5, 2, 3.5, 6, 10, 16, 25, 40, 70};
  constexpr std::array<double, 10> widths{4, 10, 20, 40, 80, 160, 250, 400, 650, 1000};
  const double root_d = std::sqrt(mean_of_range(d / mm, diameters)), m = mean_of_range(m_n / mm, modules);
  const double root_b = std::sqrt(mean_of_range(b / mm, widths)), step = std::pow(2.0, 0.5 * (grade - 5.0));
  return {rounded_tolerance(step * (0.3 * (m + 0.4 * root_d) + 4.0)),
          rounded_tolerance(step * (2.5 * std::sqrt(m) + 0.17 * root_d + 0.5)),
          rounded_tolerance(step * (0.07 * root_d + 0.45 * root_b + 3.0))};
}

/// Tolerances of both gears of a pair at one grade.
struct PairTolerances {
  Tolerances one, two;
  [[nodiscard]] double f_pt() const { return std::max(one.f_pt, two.f_pt); }
  [[nodiscard]] double f_falpha() const { return std::max(one.f_falpha, two.f_falpha); }
  [[nodiscard]] double f_Hbeta() const { return std::max(one.f_Hbeta, two.f_Hbeta); }
  /// Both helix slopes together, [ISO6336-1] 2006, 7.5.3.
  [[nodiscard]] double f_ma() const { return std::hypot(one.f_Hbeta, two.f_Hbeta); }
};

inline PairTolerances tolerances_of(const Input& in, const PairResult& g, double grade) {
  return {tolerances_of(g.d_1, in.m_n, in.b, grade), tolerances_of(g.d_2, in.m_n, in.b, grade)};
}

}  // namespace loadpath::gear::rating
