// The two meshes of a planetary set as pairs: sun with planet, and planet with ring at the same centre distance.
#pragma once

#include "calculators/gear/pair.hpp"
#include "calculators/gear/planetary/types.hpp"

namespace loadpath::gear {

struct SetMeshes {
  Pair::Input sun, ring;
  PairResult with_sun, with_ring;
  Length full;  // the tip diameter of the ring with the addendum of the basic rack
};

/// Without a module, of teeth of one millimetre: in modules all is the same.
inline SetMeshes meshes_of(const PlanetaryTypes::Input& in) {
  NoTrace quiet;
  SetMeshes m;
  m.sun.m_n = is_set(in.m_n) ? in.m_n : 1.0 * mm, m.sun.beta = in.beta, m.sun.h_aP = in.h_aP;
  m.ring = m.sun;
  m.sun.z_1 = in.z_s, m.sun.z_2 = in.z_p, m.sun.x_1 = in.x_s, m.sun.x_2 = in.x_p;
  m.with_sun = Pair::evaluate(m.sun, quiet);
  m.ring.mesh = Mesh::internal, m.ring.z_1 = in.z_p, m.ring.z_2 = PlanetaryTypes::ring_teeth(in), m.ring.x_1 = in.x_p;
  m.ring.a_w = m.with_sun.a_w;
  m.with_ring = Pair::evaluate(m.ring, quiet);
  m.full = m.with_ring.d_a2;
  if (is_set(in.h_ar)) {
    m.ring.d_a2 = m.full + 2.0 * (in.h_aP - in.h_ar) * m.ring.m_n;
    m.with_ring = Pair::evaluate(m.ring, quiet);
  }
  return m;
}

}  // namespace loadpath::gear
