#include "calculators/mechanism/parts/losses.hpp"

#include "lib/mechanism/model/frames.hpp"

namespace loadpath::planar {

double loss_of(const mechanism::Model& model, std::size_t k, const mechanism::Position& at) {
  const mechanism::Joint& joint = model.joints[k];
  const mechanism::Reaction& r = at.reactions[k];
  const auto power_on = [&](int link) {
    const mechanism::Placed frame = mechanism::placed_at(at, link);
    const mechanism::Speeds speed = mechanism::speeds_at(at, link);
    return dot(r.force, speed.origin + speed.omega * normal(r.at - frame.origin)) + r.couple * speed.omega;
  };
  return power_on(joint.j) - power_on(joint.i);
}

}  // namespace loadpath::planar
