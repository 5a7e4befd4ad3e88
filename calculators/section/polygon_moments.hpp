// Area and its moments of a polygon, by Green's theorem: exact.
#pragma once

#include "calculators/section/properties/outline.hpp"

#include <cstddef>

namespace loadpath::section {

/// About axes through an origin of the sketch.
struct Moments {
  Area A = from_si<Area>(0.0);
  SectionModulus S_y = from_si<SectionModulus>(0.0), S_z = from_si<SectionModulus>(0.0);
  SecondMoment I_yy = from_si<SecondMoment>(0.0), I_zz = from_si<SecondMoment>(0.0), I_yz = from_si<SecondMoment>(0.0);
};

/// About axes through an origin near the points, which keeps all digits. Positive whatever the sense in which the
/// points go round.
template <class Places>
Moments polygon_moments(const Places& places, const Place& origin) {
  double A = 0.0, S_y = 0.0, S_z = 0.0, I_yy = 0.0, I_zz = 0.0, I_yz = 0.0;
  const std::size_t n = places.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto &p = places[i], &q = places[(i + 1) % n];
    const double a = in_si(p.y - origin.y), b = in_si(p.z - origin.z);
    const double c = in_si(q.y - origin.y), d = in_si(q.z - origin.z), cross = a * d - c * b;
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

/// Area, centroid and second moments about it, from moments about axes through the origin.
template <class Tracer>
Properties centroidal(const Moments& sum, const Place& origin, Tracer& trace) {
  const auto& [A, S_y, S_z, I_yy, I_zz, I_yz_0] = sum;
  const auto& [y_0, z_0] = origin;
  Properties r;
  trace.value("y_0", y_0, "axes to sum about: through this position of the sketch");
  trace.value("z_0", z_0, "axes to sum about: through this position of the sketch");
  r.A = trace.value("A", A, "sum of the areas");
  trace.value("S_y", S_y, "sum of the first moments about the axis y there");
  trace.value("S_z", S_z, "sum of the first moments about the axis z there");
  trace.value("I_yy", I_yy, "sum of the second moments about the axis y there");
  trace.value("I_zz", I_zz, "sum of the second moments about the axis z there");
  trace.value("I_yz_0", I_yz_0, "sum of the products of area about both");
  STEP(e_y, S_z / A, "first moment about z over the area");
  STEP(e_z, S_y / A, "first moment about y over the area");
  STEP_TO(r, y_S, y_0 + e_y, "in the sketch");
  STEP_TO(r, z_S, z_0 + e_z, "in the sketch");
  STEP_TO(r, I_y, I_yy - A * e_z * e_z, "brought to the centroid by Steiner, [Garrison]");
  STEP_TO(r, I_z, I_zz - A * e_y * e_y, "brought to the centroid by Steiner, [Garrison]");
  STEP(I_yz_S, I_yz_0 - A * e_y * e_z, "brought to the centroid by Steiner");
  r.I_yz = without_rounding(I_yz_S, I_y, I_z);
  trace.value("I_yz", r.I_yz, "product of area about the centroid; rounding errors set to zero");
  return r;
}

}  // namespace loadpath::section
