#include "lib/mechanism/proof/virtual_work.hpp"

#include "lib/mechanism/equations/kinetostatics.hpp"

namespace loadpath::mechanism {

double effort_by_virtual_power(const Instant& instant, std::size_t driver) {
  return -instant.virtual_power(driver) / instant.virtual_rate(driver);
}

void ReleasedConstraints::find_forces(const Instant& instant, Forces& forces) {
  const double length = instant.length();
  acting_.assign(instant.constraints().columns(), 0.0);
  multipliers_.resize(instant.constraints().rows());
  add_up(instant.active(), length, acting_);
  instant.inverse().find_supply(acting_, multipliers_);
  for (double& multiplier : multipliers_) multiplier /= -length;
  share_out(instant.model(), instant.constraints(), multipliers_, length, forces.reactions, forces.effort);
}

}  // namespace loadpath::mechanism
