// Properties of every section: area, centroid, second moments, radii of gyration, moduli and principal axes.
//
// Axes as in EN 1993: y to the right, z upwards, in the plane of the section. I_y is about the axis y through the
// centroid, I_yz the integral of y z; a part of the section on the upper right and one on the lower left make it
// positive. The principal axis u has the largest second moment; alpha turns y to u, counter-clockwise.
#pragma once

#include "calculators/load/section_record.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/trace.hpp"

#include <cmath>

namespace loadpath::section {

struct Properties {
  Area A = unset<Area>;
  Length y_S = unset<Length>, z_S = unset<Length>;
  SecondMoment I_y = unset<SecondMoment>, I_z = unset<SecondMoment>, I_yz = unset<SecondMoment>;
  Length i_y = unset<Length>, i_z = unset<Length>;
  SectionModulus W_y_top = unset<SectionModulus>, W_y_bottom = unset<SectionModulus>;
  SectionModulus W_z_left = unset<SectionModulus>, W_z_right = unset<SectionModulus>;
  double alpha = unset<double>;
  SecondMoment I_max = unset<SecondMoment>, I_min = unset<SecondMoment>;
  Length i_min = unset<Length>;
  SectionModulus W_max = unset<SectionModulus>, W_min = unset<SectionModulus>;
  SecondMoment I_t = unset<SecondMoment>;
  SectionModulus W_t = unset<SectionModulus>;
  SectionRecord section;
};

/// Properties of a section whose centroid is the origin of the sketch and whose axes are principal.
inline Properties centred() {
  Properties p;
  p.y_S = p.z_S = from_si<Length>(0.0);
  p.I_yz = from_si<SecondMoment>(0.0);
  return p;
}

namespace detail {

template <class Result, class Quantity>
constexpr auto property(Quantity Properties::*at, const char* key, Unit<Quantity> unit, const char* doc) {
  Quantity Result::*const own = at;
  return Field{own, key, unit, doc};
}

template <class Result>
constexpr auto section_group() {
  SectionRecord Result::*const own = &Properties::section;
  return Group<Result, SectionRecord>{own, "section",
                                      "the section with its walls, for column.buckling and link.member: "
                                      "section"}
      .handed_over();
}

}  // namespace detail

/// The section as a record, with what the properties give; the dimensions follow from the shape.
inline SectionRecord record_of(const Properties& p) {
  SectionRecord record;
  record.A = p.A, record.I_y = p.I_y, record.I_z = p.I_z;
  if (p.I_yz != from_si<SecondMoment>(0.0)) record.I_min = p.I_min;
  record.c_y = p.I_y / min(p.W_y_top, p.W_y_bottom);
  record.c_z = p.I_z / min(p.W_z_left, p.W_z_right);
  return record;
}

/// The fields of Properties in a result that is Properties or derives from it.
template <class Result>
constexpr auto property_fields() {
  using P = Properties;
  constexpr auto field = [](auto... arguments) { return detail::property<Result>(arguments...); };
  return Fields{
      field(&P::A, "A", mm2, "area"),
      field(&P::y_S, "y_S", mm, "centroid, from the origin of the sketch to the right"),
      field(&P::z_S, "z_S", mm, "centroid, from the origin of the sketch upwards"),
      field(&P::I_y, "I_y", mm4, "second moment of area about the axis y through the centroid"),
      field(&P::I_z, "I_z", mm4, "second moment of area about the axis z through the centroid"),
      field(&P::I_yz, "I_yz", mm4, "product of area about these axes, the integral of y z"),
      field(&P::i_y, "i_y", mm, "radius of gyration about y"),
      field(&P::i_z, "i_z", mm, "radius of gyration about z"),
      field(&P::W_y_top, "W_y_top", mm3, "elastic section modulus I_y over the distance of the uppermost fibre"),
      field(&P::W_y_bottom, "W_y_bottom", mm3, "elastic section modulus I_y over the distance of the lowest fibre"),
      field(&P::W_z_left, "W_z_left", mm3, "elastic section modulus I_z over the distance of the leftmost fibre"),
      field(&P::W_z_right, "W_z_right", mm3, "elastic section modulus I_z over the distance of the rightmost fibre"),
      field(&P::alpha, "alpha", deg, "angle from y to the principal axis of the maximum second moment"),
      field(&P::I_max, "I_max", mm4, "maximum second moment of area, about a principal axis"),
      field(&P::I_min, "I_min", mm4, "minimum second moment of area: about the other principal axis"),
      field(&P::i_min, "i_min", mm, "minimum radius of gyration"),
      field(&P::W_max, "W_max", mm3,
            "elastic section modulus about the principal axis of I_max, minimum of both sides"),
      field(&P::W_min, "W_min", mm3,
            "elastic section modulus about the principal axis of I_min, minimum of both sides"),
      field(&P::I_t, "I_t", mm4, "torsion constant of Saint-Venant"),
      field(&P::W_t, "W_t", mm3, "torsional section modulus: torque / maximum shear stress"),
      detail::section_group<Result>()};
}

inline constexpr auto results_of_properties = property_fields<Properties>();

/// A corner of the contour, or the centre of a round part of it: what the distances of extreme fibres follow from.
struct Extreme {
  Length y = unset<Length>, z = unset<Length>;
  Length radius = from_si<Length>(0.0);
};
using Extremes = List<Extreme, 160>;

/// How far the contour reaches from a point: along a direction, against it, and to both sides.
struct Extent {
  Length ahead, behind, left, right;

  /// Along the direction that was to the left.
  [[nodiscard]] Extent turned_left() const { return {left, right, behind, ahead}; }
};

inline Extent reach(const Extremes& extremes, Length y, Length z, double towards_y, double towards_z) {
  const Length none = from_si<Length>(-std::numeric_limits<double>::infinity());
  Extent r{none, none, none, none};
  for (const Extreme& e : extremes) {
    const Length along = (e.y - y) * towards_y + (e.z - z) * towards_z;
    const Length across = (e.z - z) * towards_y - (e.y - y) * towards_z;
    r.ahead = max(r.ahead, e.radius + along), r.behind = max(r.behind, e.radius - along);
    r.left = max(r.left, e.radius + across), r.right = max(r.right, e.radius - across);
  }
  return r;
}

/// A product of area that is nothing but rounding counts as zero: y and z are principal axes then.
inline SecondMoment without_rounding(SecondMoment I_yz, SecondMoment I_y, SecondMoment I_z) {
  return abs(I_yz) <= 1e-11 * (I_y + I_z) ? from_si<SecondMoment>(0.0) : I_yz;
}

/// Principal second moments and their axis.
template <class Tracer>
void turn_to_principal_axes(Properties& r, Tracer& trace) {
  if (r.I_yz == from_si<SecondMoment>(0.0)) {
    STEP_TO(r, I_max, max(r.I_y, r.I_z), "y and z are principal axes: the product of area is zero");
    STEP_TO(r, I_min, min(r.I_y, r.I_z), "the other one");
    r.alpha = r.I_y >= r.I_z ? 0.0 : 0.5 * pi;
    trace.angle("alpha", r.alpha, "I_max is about y where I_y is the larger, else about z");
    return;
  }
  STEP(I_R, sqrt(pow<2>((r.I_y - r.I_z) / 2.0) + r.I_yz * r.I_yz), "radius of Mohr's circle");
  STEP_TO(r, I_max, (r.I_y + r.I_z) / 2.0 + I_R, "maximum, by Mohr's circle");
  STEP_TO(r, I_min, (r.I_y + r.I_z) / 2.0 - I_R, "minimum, by Mohr's circle");
  STEP_TO(r, alpha, atan(-2.0 * r.I_yz / (r.I_y - r.I_z + 2.0 * I_R)), "half the angle on Mohr's circle");
}

/// Results that follow from A, the centroid, I_y, I_z, I_yz and the contour.
template <class Tracer>
void complete(Properties& r, const Extremes& extremes, Tracer& trace) {
  STEP_TO(r, i_y, sqrt(r.I_y / r.A), "radius of gyration");
  STEP_TO(r, i_z, sqrt(r.I_z / r.A), "radius of gyration");
  const Extent along_y = reach(extremes, r.y_S, r.z_S, 1.0, 0.0);
  const auto [e_right, e_left, e_top, e_bottom] = along_y;
  trace.value("e_top", e_top, "from the centroid to the uppermost fibre");
  STEP_TO(r, W_y_top, r.I_y / e_top, "bending about y, upper side");
  trace.value("e_bottom", e_bottom, "from the centroid to the lowest fibre");
  STEP_TO(r, W_y_bottom, r.I_y / e_bottom, "bending about y, lower side");
  trace.value("e_left", e_left, "from the centroid to the leftmost fibre");
  STEP_TO(r, W_z_left, r.I_z / e_left, "bending about z, left side");
  trace.value("e_right", e_right, "from the centroid to the rightmost fibre");
  STEP_TO(r, W_z_right, r.I_z / e_right, "bending about z, right side");
  turn_to_principal_axes(r, trace);
  STEP_TO(r, i_min, sqrt(r.I_min / r.A), "minimum radius of gyration");
  const Extent from_axis = r.alpha == 0.0 ? along_y
                           : r.I_yz == from_si<SecondMoment>(0.0)
                               ? along_y.turned_left()
                               : reach(extremes, r.y_S, r.z_S, std::cos(r.alpha), std::sin(r.alpha));
  const auto [ahead, behind, left, right] = from_axis;
  const Length e_max = trace.value("e_max", max(left, right), "farthest fibre from the principal axis of I_max");
  STEP_TO(r, W_max, r.I_max / e_max, "bending about the principal axis of I_max");
  const Length e_min = trace.value("e_min", max(ahead, behind), "farthest fibre from the principal axis of I_min");
  STEP_TO(r, W_min, r.I_min / e_min, "bending about the principal axis of I_min");
}

template <class Result, class Tracer>
Result completed(Result r, const Extremes& extremes, Tracer& trace) {
  complete(r, extremes, trace);
  r.section = record_of(r);
  return r;
}

}  // namespace loadpath::section
