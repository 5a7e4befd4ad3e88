#include "calculators/mechanism/input/point_masses.hpp"

#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/input/points.hpp"

namespace loadpath::planar {

using mechanism::PointMass;
using mechanism::Vec;

static const planar::Point* point_of(const planar::Link& link, const Name& name) {
  return find_named(link.points, name);
}

mechanism::Link own_of(const planar::Link& l) {
  mechanism::Link link;
  link.mass = in_si(l.mass);
  link.inertia = in_si(l.J);
  if (!l.S.empty()) link.centre = vector_of(*point_of(l, l.S));
  return link;
}

std::vector<PointMass> masses_of(const planar::Link& l, const mechanism::Link& link) {
  const Vec a = vector_of(*point_of(l, l.mass_points.first)), b = vector_of(*point_of(l, l.mass_points.second));
  if (l.masses == Masses::two_points) {
    const auto masses = mechanism::statically_equivalent(link, a, b);
    return masses ? std::vector(masses->begin(), masses->end()) : std::vector<PointMass>{};
  }
  const auto masses = mechanism::dynamically_equivalent(link, a, b);
  return masses ? std::vector(masses->begin(), masses->end()) : std::vector<PointMass>{};
}

double reduced_inertia(const planar::Link& l, const mechanism::Link& own) {
  if (l.masses != Masses::two_points) return own.inertia;
  const auto masses = masses_of(l, own);
  return masses.empty() ? own.inertia : own.inertia - mechanism::missing_inertia(own, masses);
}

}  // namespace loadpath::planar
