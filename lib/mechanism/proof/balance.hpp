// The proof by summation: the residuals of the equilibrium of each link and of the power balance when all loads are
// added up again, only from the model and a position.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"
#include "lib/mechanism/proof/active_forces.hpp"

#include <span>
#include <vector>

namespace loadpath::mechanism {

/// The residual of the equilibrium of a link.
struct LinkResidual {
  double force = 0.0;   // N
  double moment = 0.0;  // about the mass centre, N m
};

struct Residuals {
  double force = 0.0;                    // largest on a link, N
  double moment = 0.0;                   // largest on a link, N m
  double power = 0.0;                    // drives + loads + gravity - friction - rate of kinetic energy, W
  double power_scale = 0.0;              // sum of the magnitudes in the power balance, W
  std::vector<LinkResidual> links = {};  // magnitudes, as the links of the model
};

/// `active`: as `find_active_forces` gives them there.
Residuals residuals(const Model& model, std::span<const Drive> drives, std::span<const ActiveForce> active,
                    const Position& at);
/// `statics`: without inertia.
Residuals residuals(const Model& model, std::span<const Drive> drives, bool statics, const Position& at);

}  // namespace loadpath::mechanism
