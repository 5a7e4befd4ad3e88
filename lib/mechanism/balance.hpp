// The proof by summing up: what is left of the equilibrium of each link and of the power balance when everything that
// acts is added together again, from the model and a position alone.
#pragma once

#include "lib/mechanism/model.hpp"
#include "lib/mechanism/position.hpp"

#include <span>
#include <vector>

namespace loadpath::mechanism {

struct Residuals {
  double force = 0.0;        // largest unbalanced force on a link, N
  double moment = 0.0;       // largest unbalanced moment about a link's mass centre, N m
  double power = 0.0;        // drives + loads + gravity - rate of kinetic energy, W
  double power_scale = 0.0;  // sum of the magnitudes in the power balance, W
};

/// `statics`: without inertia.
Residuals residuals(const Model& model, std::span<const Drive> drives, bool statics, const Position& at);

}  // namespace loadpath::mechanism
