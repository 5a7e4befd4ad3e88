// Loads on the links other than constraint forces: weights, inertia forces, loads, springs; and forces induced by
// reactions.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

struct ActiveForce {
  enum class Kind { weight, inertia, load, spring, induced };
  Kind kind;
  std::size_t index;    // index of the link, the load, the spring, or the joint
  std::size_t link;     // on which it acts
  Vec arm;              // from the origin of the link's frame, global axes, m
  Vec force;            // N, global axes
  double couple = 0.0;  // N m
};

/// Weights, loads, springs and, unless `statics`, inertia forces (D'Alembert) act at the mass centre; zero loads are
/// left out.
void find_active_forces(const Model& model, const Position& at, bool statics, std::vector<ActiveForce>& active);

/// Adds them up, coordinate by coordinate: forces, N, and moments about the origins of the links' frames over this
/// length, m.
void add_up(std::span<const ActiveForce> active, double length, std::span<double> acting);

/// W, when the link moves so.
double power(const ActiveForce& active, const Pose& velocity);

}  // namespace loadpath::mechanism
