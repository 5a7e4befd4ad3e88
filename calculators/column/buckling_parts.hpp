// Declarations shared by the sources of column.buckling.
#pragma once

#include "calculators/column/buckling_input.hpp"
#include "calculators/column/codes/eurocode.hpp"
#include "calculators/column/member/parts.hpp"
#include "calculators/column/member/result.hpp"
#include "lib/figure/figure.hpp"

#include <array>
#include <optional>

namespace loadpath::column {

/// The type of section of SP 16.13330; unset for a kind that is none of them.
inline const Sp16Type& sp16_type(SectionKind kind) {
  static constexpr Sp16Type a{0.03, 0.06}, b{0.04, 0.09}, c{0.04, 0.14}, none{};
  switch (kind) {
    case SectionKind::hot_hollow:
    case SectionKind::cold_hollow:
    case SectionKind::welded_box:
      return a;
    case SectionKind::rolled_I:
    case SectionKind::welded_I:
      return b;
    case SectionKind::channel:
    case SectionKind::tee:
    case SectionKind::angle:
      return c;
    case SectionKind::solid:
    case SectionKind::unsaid:
      return none;
  }
  return none;
}

/// With what its section adds.
inline Material material_of(const BucklingInput& in) {
  Material material = material_of(static_cast<const Member&>(in));
  material.sp16 = sp16_type(in.kind);
  return material;
}

Plates plates_of(const BucklingInput& in);
/// By its kind; without one a bar given by d, or by h and b, and a section whose area and second moments are those of a
/// solid.
bool is_solid(const BucklingInput& in);
/// Its distance from the axis: as given, else half the side of a section that is symmetric to the axis; unset of a
/// channel about z, of a tee about y, of an angle.
Length extreme_fibre(const BucklingInput& in, AxisName axis);
/// Whether it is for every eccentricity and bow.
bool fibre_known(const BucklingInput& in);
/// About an axis: as given, else by the kind of section.
Curve curve_of(const BucklingInput& in, AxisName axis);

/// Whether it is a section of structural steelwork with a buckling curve of EN 1993-1-1: no solid bar.
inline bool is_structural(const BucklingInput& in) {
  if (!is_set(in.A) || in.kind == SectionKind::solid) return false;
  return curve_of(in, AxisName::y) != Curve::by_kind && curve_of(in, AxisName::z) != Curve::by_kind;
}
/// The method that decides: as named, else by what is given.
inline Method method_of(const BucklingInput& in) {
  return in.method != Method::unsaid ? in.method : default_method(in, is_structural(in));
}

/// The buckled bar about each axis with known ends, next to its section; none if no ends are known. `moments`: the
/// largest about y and about z.
std::optional<figure::Figure> bar_figure(const BucklingInput& in, const MemberResult& r,
                                         const std::array<Moment, 2>& moments = {});

}  // namespace loadpath::column
