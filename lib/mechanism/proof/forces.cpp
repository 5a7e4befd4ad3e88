#include "lib/mechanism/proof/forces.hpp"

#include "lib/numerics/magnitude.hpp"

namespace loadpath::mechanism {

Forces blank_forces(const Model& model) {
  Forces blank;
  blank.reactions.resize(model.joints.size());
  blank.effort.resize(model.drivers.size());
  return blank;
}

double difference(const Reaction& a, const Reaction& b, double length) {
  const double moment = b.couple + cross(b.at - a.at, b.force) - a.couple;
  return numerics::larger_magnitude(mechanism::length(b.force - a.force), moment / length);
}

}  // namespace loadpath::mechanism
