// Area and its moments of a polygon, by Green's theorem: exact.
#pragma once

#include "calculators/section/outline.hpp"

#include <cstddef>

namespace loadpath::section {

/// About the axes of the sketch.
struct Moments {
  Area A = from_si<Area>(0.0);
  SectionModulus S_y = from_si<SectionModulus>(0.0), S_z = from_si<SectionModulus>(0.0);
  SecondMoment I_yy = from_si<SecondMoment>(0.0), I_zz = from_si<SecondMoment>(0.0), I_yz = from_si<SecondMoment>(0.0);
};

/// Positive whatever the sense in which the points go round.
template <class Places>
Moments polygon_moments(const Places& places) {
  double A = 0.0, S_y = 0.0, S_z = 0.0, I_yy = 0.0, I_zz = 0.0, I_yz = 0.0;
  const std::size_t n = places.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto &p = places[i], &q = places[(i + 1) % n];
    const double a = in_si(p.y), b = in_si(p.z), c = in_si(q.y), d = in_si(q.z), cross = a * d - c * b;
    A += cross / 2.0;
    S_z += cross * (a + c) / 6.0;
    S_y += cross * (b + d) / 6.0;
    I_yy += cross * (b * b + b * d + d * d) / 12.0;
    I_zz += cross * (a * a + a * c + c * c) / 12.0;
    I_yz += cross * (a * d + 2.0 * a * b + 2.0 * c * d + c * b) / 24.0;
  }
  const double sense = A < 0.0 ? -1.0 : 1.0;
  return {from_si<Area>(sense * A),
          from_si<SectionModulus>(sense * S_y),
          from_si<SectionModulus>(sense * S_z),
          from_si<SecondMoment>(sense * I_yy),
          from_si<SecondMoment>(sense * I_zz),
          from_si<SecondMoment>(sense * I_yz)};
}

inline void add(Moments& sum, const Moments& part, double sign) {
  sum.A += sign * part.A;
  sum.S_y += sign * part.S_y, sum.S_z += sign * part.S_z;
  sum.I_yy += sign * part.I_yy, sum.I_zz += sign * part.I_zz, sum.I_yz += sign * part.I_yz;
}

/// Area, centroid and second moments about it, from moments about the axes of the sketch.
template <class Tracer>
Properties centroidal(const Moments& about_sketch, Tracer& trace) {
  const auto& [A, S_y, S_z, I_yy, I_zz, I_yz_0] = about_sketch;
  STEP(y_S, S_z / A, "first moment about z over the area");
  STEP(z_S, S_y / A, "first moment about y over the area");
  STEP(I_y, I_yy - A * z_S * z_S, "brought to the centroid by Steiner, [Garrison]");
  STEP(I_z, I_zz - A * y_S * y_S, "brought to the centroid by Steiner, [Garrison]");
  STEP(I_yz_S, I_yz_0 - A * y_S * z_S, "brought to the centroid by Steiner");
  Properties r;
  r.A = A, r.y_S = y_S, r.z_S = z_S, r.I_y = I_y, r.I_z = I_z;
  r.I_yz = without_rounding(I_yz_S, I_y, I_z);
  trace.value("I_yz", r.I_yz, "product of area about the centroid; what is only rounding is zero");
  return r;
}

template <class Tracer>
void tell(const Moments& about_sketch, Tracer& trace) {
  trace.value("A", about_sketch.A, "sum of the areas");
  trace.value("S_y", about_sketch.S_y, "first moment about the axis y of the sketch");
  trace.value("S_z", about_sketch.S_z, "first moment about the axis z of the sketch");
  trace.value("I_yy", about_sketch.I_yy, "second moment about the axis y of the sketch");
  trace.value("I_zz", about_sketch.I_zz, "second moment about the axis z of the sketch");
  trace.value("I_yz_0", about_sketch.I_yz, "product of area about the axes of the sketch");
}

}  // namespace loadpath::section
