// Forces on each link of a planar mechanism at a position, one by one: the sides of its force plan.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "lib/figure/figure.hpp"

#include <string>
#include <vector>

namespace loadpath::planar {

struct ActingForce {
  enum class Cause { load, spring, weight, inertia, drive, joint };
  Cause cause = Cause::joint;
  std::size_t index = 0;  // index of the load, spring, joint or driver
  double sense = 1.0;     // -1: the opposite of the named force of the spring, drive or joint
  mechanism::Vec at;      // global
  mechanism::Vec force;   // N, global
  double couple = 0.0;    // N m
  std::string label;      // for lib/draw: "R_A", "−m a_rod"

  /// With its sign.
  [[nodiscard]] std::string name() const;
  [[nodiscard]] figure::Plan::Tone tone() const;
};

/// Loads, springs, weight, inertia (the force -m a at the mass centre, with the couple -J epsilon), drives, then
/// joints: in the order in which a force plan is drawn. Causes that the link does not have are left out; a cause that
/// is zero at this position is not, so that the list is as long at every position. `link` may be the ground.
std::vector<ActingForce> acting_on(const mechanism::Model& model, const mechanism::Position& at, int link,
                                   bool statics);

/// Loads, springs and drives, weights and inertia of all links: what Zhukovsky's lever is loaded with.
std::vector<ActingForce> external_forces(const mechanism::Model& model, const mechanism::Position& at, int link,
                                         bool statics);

inline figure::Point point(mechanism::Vec v) { return {v.x, v.y}; }
/// The mean of points; of none the origin.
figure::Point middle_of(const std::vector<figure::Point>& points);

/// The direction of the line of a joint, a guide or slot, in global axes.
mechanism::Vec line_of(const mechanism::Joint& joint, const mechanism::Position& at);

}  // namespace loadpath::planar
