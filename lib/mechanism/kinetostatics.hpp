// Forces at one position: what the constraints must supply, and how it is shared by the joints.
#pragma once

#include "lib/mechanism/kinematics.hpp"
#include "lib/mechanism/model.hpp"
#include "lib/mechanism/point_motion.hpp"
#include "lib/mechanism/position.hpp"

#include <span>

namespace loadpath::mechanism {

/// A force and a moment on a link, about its frame's origin.
struct Wrench {
  Vec force;            // N
  double moment = 0.0;  // N m
  /// What acts about another origin, which lies `lever` away from this one.
  void add(const Wrench& other, Vec lever) {
    force = force + other.force;
    moment += other.moment + cross(lever, other.force);
  }
  void subtract(const Wrench& other) {
    force = force - other.force;
    moment -= other.moment;
  }
};

/// Of a link: its frame's origin and its turning.
struct Acceleration {
  Vec origin;  // m/s^2
  double omega = 0.0, epsilon = 0.0;
};

/// What it takes to move a link so, m a and J epsilon, less its weight.
inline Wrench inertia_less_weight(const Link& link, const Turn& turned, const Acceleration& a, Vec gravity) {
  const Vec arm = turned(link.centre);
  const Vec centre = point_acceleration({a.origin.x, a.origin.y, a.epsilon}, a.omega, arm);
  const Vec force = link.mass * (centre - gravity);
  return {force, link.inertia * a.epsilon + cross(arm, force)};
}

inline Wrench wrench_of(const Load& load, const Turn& turned) {
  const Vec force = global_force(load, load.force, turned);
  return {force, load.moment + cross(turned(load.point), force)};
}

/// Inertia less loads and gravity, per coordinate: the right side of the transposed system for the multipliers.
/// `statics`: without inertia.
void required_forces(const Model& model, const Constraints& constraints, std::span<const double> velocity,
                     std::span<const double> acceleration, bool statics, std::span<double> required);

/// Reactions and efforts from the multipliers; `length`: the unit of length of the constraints, in m.
void share_out(const Model& model, const Constraints& constraints, std::span<const double> multipliers, double length,
               std::span<Reaction> reactions, std::span<double> effort);

}  // namespace loadpath::mechanism
