#include "lib/mechanism/proof/all_equations.hpp"

#include "lib/mechanism/equations/kinetostatics.hpp"

#include <algorithm>
#include <limits>

namespace loadpath::mechanism {
namespace {

void flatten(std::span<const Pose> poses, std::vector<double>& flat) {
  flat.clear();
  for (const Pose& p : poses) flat.insert(flat.end(), {p.x, p.y, p.phi});
}

}  // namespace

AllEquations::AllEquations(const Instant& instant)
    : factors_(instant.constraints().rows(), instant.constraints().pattern()),
      unknowns_(instant.constraints().columns()) {}

void AllEquations::find_forces(const Instant& instant, Forces& forces) {
  const Model& model = instant.model();
  const double length = instant.length();
  flatten(instant.at().velocity, velocity_);
  flatten(instant.at().acceleration, acceleration_);
  required_forces(model, instant.constraints(), velocity_, acceleration_, instant.statics(), unknowns_);
  for (const ActiveForce& active : instant.active()) {
    if (active.kind == ActiveForce::Kind::spring || active.kind == ActiveForce::Kind::induced) supply(active);
  }
  // In the constraints' unit of length; kg and s stay.
  for (std::size_t k = 0; k < unknowns_.size(); ++k) unknowns_[k] /= k % 3 == 2 ? length * length : length;
  if (factors_.factor(instant.constraints().jacobian())) {
    factors_.solve_transposed(unknowns_);
  } else {
    std::ranges::fill(unknowns_, std::numeric_limits<double>::quiet_NaN());
  }
  share_out(model, instant.constraints(), unknowns_, length, forces.reactions, forces.effort);
}

void AllEquations::supply(const ActiveForce& active) {
  unknowns_[3 * active.link] -= active.force.x;
  unknowns_[3 * active.link + 1] -= active.force.y;
  unknowns_[3 * active.link + 2] -= active.couple + cross(active.arm, active.force);
}

}  // namespace loadpath::mechanism
