// Values derived from the input of a bar with bending, shared by both codes.
#pragma once

#include "calculators/column/bending/input.hpp"
#include "calculators/column/buckling_parts.hpp"
#include "calculators/column/member/length_factor.hpp"
#include "lib/text/issue.hpp"

namespace loadpath::column {

constexpr bool is_I(SectionKind kind) { return kind == SectionKind::rolled_I || kind == SectionKind::welded_I; }
constexpr bool is_hollow(SectionKind kind) {
  return kind == SectionKind::hot_hollow || kind == SectionKind::cold_hollow || kind == SectionKind::welded_box;
}

/// By its word, or by its outline: a bar given by d, or by h and b, without a kind.
SectionKind kind_of(const BeamColumnInput& in);

/// With its kind, and with the wall of a tube that is given by its bore.
BeamColumnInput completed(const BeamColumnInput& in);

/// The moments in both planes, without the factor of the actions.
Moments moments_about_y(const BeamColumnInput& in);
Moments moments_about_z(const BeamColumnInput& in);

/// Whether the effective length about this axis is longer than the bar: an end that is free, or sways.
bool sways(const BeamColumnInput& in, AxisName axis);

/// The length between supports against twisting; of a bar with a free end its effective length.
Length lateral_length(const BeamColumnInput& in);

/// Whether the moments between these supports are those of all the bar; otherwise they count as uniform.
bool is_one_segment(const BeamColumnInput& in);

/// From the shear centre to the load along z.
Length load_height(const BeamColumnInput& in);

/// What the plates give where neither the row nor the input does: without fillets, which is on the safe side.
struct Geometry {
  Area A = unset<Area>, A_vz = unset<Area>, A_vy = unset<Area>;
  SectionModulus W_y = unset<SectionModulus>, W_z = unset<SectionModulus>;
  SectionModulus W_pl_y = unset<SectionModulus>, W_pl_z = unset<SectionModulus>;
  SecondMoment I_y = unset<SecondMoment>, I_z = unset<SecondMoment>, I_t = unset<SecondMoment>;
  Warping I_w = unset<Warping>;
};

/// A typed plastic section modulus above that of the plates; without a path if there is none.
FieldFault plastic_beyond_plates(const BeamColumnInput& in);

Geometry geometry_of(const BeamColumnInput& in);

/// The section in lateral-torsional buckling; the shear modulus of a metal, ν = 0.3.
Lateral lateral_of(const BeamColumnInput& in, const Geometry& s);

/// Whether the bar bends about its stronger axis and can turn over.
inline bool can_turn_over(const Geometry& s) { return s.I_y > 1.001 * s.I_z; }

/// The largest moment about y at buckling under moments that are not all zero.
Moment critical_moment(const BeamColumnInput& in, const Geometry& s);

}  // namespace loadpath::column
