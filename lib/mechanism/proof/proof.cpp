#include "lib/mechanism/proof/proof.hpp"

#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::mechanism {

double Proof::part(double force) const {
  const double scale = largest_force * condition;
  if (!std::isfinite(force) || !std::isfinite(scale)) return std::numeric_limits<double>::quiet_NaN();
  return force == 0.0 ? 0.0 : force / scale;
}

bool Proof::trustworthy() const {
  return motion <= tolerance && part(unbalanced) <= tolerance &&
         std::ranges::all_of(disagreement, [&](double force) { return part(force) <= tolerance; });
}

Prover::Prover(const Model& model)
    : instant_(model), motion_(instant_), equations_(instant_), chain_(instant_), forces_(blank_forces(model)) {}

Proof Prover::prove(std::span<const Drive> drives, bool statics, const Position& at) {
  instant_.take(at, statics);
  Proof proof;
  proof.residuals = residuals(instant_.model(), drives, instant_.external(), at);
  proof.motion = motion_.residual(instant_, drives);
  proof.unbalanced = largest_residual(proof.residuals);
  proof.largest_force = largest_force(at);
  proof.condition = instant_.condition();
  equations_.find_forces(instant_, forces_);
  compare(Proof::whole_system, proof);
  released_.find_forces(instant_, forces_);
  compare(Proof::released_constraints, proof);
  chain_.find_forces(instant_, forces_);
  compare(Proof::opened_chain, proof);
  for (std::size_t k = 0; k < at.effort.size(); ++k) {
    compare_effort(Proof::virtual_power, k, effort_by_virtual_power(instant_, k), proof);
    find_lever(instant_, k, lever_);
    compare_effort(Proof::zhukovsky, k, lever_.effort, proof);
  }
  return proof;
}

void Prover::compare(Proof::Method method, Proof& proof) const {
  const Position& at = instant_.at();
  double& most = proof.disagreement[method];
  for (std::size_t k = 0; k < at.reactions.size(); ++k) {
    const Reaction found = forces_.reactions[k] + instant_.unconstrained_reaction(k);
    most = numerics::larger_magnitude(most, difference(at.reactions[k], found, instant_.length()));
  }
  for (std::size_t k = 0; k < at.effort.size(); ++k) compare_effort(method, k, forces_.effort[k], proof);
}

void Prover::compare_effort(Proof::Method method, std::size_t driver, double effort, Proof& proof) const {
  const double off = effort - instant_.at().effort[driver];
  double& most = proof.disagreement[method];
  most = numerics::larger_magnitude(most, off / instant_.effort_arm(driver));
}

double Prover::largest_force(const Position& at) const {
  double most = 0.0;
  for (const Reaction& r : at.reactions) {
    most = numerics::larger_magnitude(numerics::larger_magnitude(most, length(r.force)), r.couple / instant_.length());
  }
  for (std::size_t k = 0; k < at.effort.size(); ++k) {
    most = numerics::larger_magnitude(most, at.effort[k] / instant_.effort_arm(k));
  }
  for (const ActiveForce& a : instant_.active()) {
    most = numerics::larger_magnitude(numerics::larger_magnitude(most, length(a.force)), a.couple / instant_.length());
  }
  return most;
}

double Prover::largest_residual(const Residuals& residuals) const {
  double most = 0.0;
  for (const LinkResidual& link : residuals.links) {
    most = numerics::larger_magnitude(numerics::larger_magnitude(most, link.force), link.moment / instant_.length());
  }
  return most;
}

}  // namespace loadpath::mechanism
