#include "calculators/mechanism/pictures/extents.hpp"

#include "calculators/mechanism/cycle/point_motion.hpp"
#include "calculators/mechanism/pictures/forces.hpp"

#include <algorithm>

namespace loadpath::planar {

using mechanism::JointKind;
using mechanism::Position;
using mechanism::Vec;

bool has_line(JointKind kind) { return kind == JointKind::prismatic || kind == JointKind::slot; }

bool has_face(const mechanism::Joint& j) {
  return j.kind == JointKind::cam && j.contact == mechanism::CamContact::flat;
}

Vec face_of(const mechanism::Joint& j, const Position& p) {
  return mechanism::turn(angle_of(p, j.i) + j.angle)({1.0, 0.0});
}

/// Position of the pin on the line of its guide or slot.
static double reach(const mechanism::Joint& j, const Position& p) {
  return mechanism::dot(on_paper(p, j.i, j.point_i) - on_paper(p, j.j, j.point_j), line_of(j, p));
}

/// Where the cam touches along a flat face.
static double reach_on_face(const mechanism::Joint& j, std::size_t n, const Position& p) {
  return mechanism::dot(p.reactions[n].at - on_paper(p, j.i, j.point_i), face_of(j, p));
}

Extents extents_of(const mechanism::Model& model, const Cycle& cycle) {
  Extents all{std::vector<Stroke>(model.joints.size()), std::vector<bool>(model.loads.size()),
              std::vector<bool>(model.loads.size())};
  bool first = true;
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    if (!cycle.closed[k]) continue;
    const Position& p = cycle.positions[k];
    for (std::size_t n = 0; n < model.joints.size(); ++n) {
      const mechanism::Joint& j = model.joints[n];
      if (!has_line(j.kind) && !has_face(j)) continue;
      const double at = has_face(j) ? reach_on_face(j, n, p) : reach(j, p);
      Stroke& stroke = all.strokes[n];
      stroke = first ? Stroke{at, at} : Stroke{std::min(stroke.from, at), std::max(stroke.to, at)};
    }
    for (std::size_t n = 0; n < model.loads.size(); ++n) {
      all.loads_push[n] = all.loads_push[n] || mechanism::length(p.loads[n].force) > 0.0;
      all.loads_turn[n] = all.loads_turn[n] || p.loads[n].moment != 0.0;
    }
    first = false;
  }
  return all;
}

}  // namespace loadpath::planar
