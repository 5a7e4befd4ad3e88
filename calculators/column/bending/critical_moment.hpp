// Elastic lateral-torsional buckling of a bar of doubly symmetric section: the critical moment by the energy method.
//
// The ends are held against twisting and against moving across, and are free to warp and to turn about z (fork ends).
// The moment may vary along the bar in any way; a transverse load acts at a distance from the shear centre.
#pragma once

#include "calculators/column/bending/moments.hpp"
#include "calculators/column/member/section.hpp"

namespace loadpath::column {

/// Stiffness of the section against moving across and twisting.
struct Lateral {
  Stress E = unset<Stress>, G = unset<Stress>;
  SecondMoment I_z = unset<SecondMoment>, I_t = unset<SecondMoment>;
  Warping I_w = unset<Warping>;
};

/// Under a moment that is uniform over the length.
Moment critical_uniform_moment(const Lateral& section, Length l);

/// The largest moment of the bar at buckling. `z_g`: from the shear centre to the load, positive where the load pushes
/// towards the shear centre.
Moment critical_moment(const Lateral& section, const Moments& moments, Length z_g);

}  // namespace loadpath::column
