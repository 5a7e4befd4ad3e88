#include "lib/mechanism/proof/virtual_work.hpp"

#include "lib/mechanism/equations/kinetostatics.hpp"

namespace loadpath::mechanism {

double effort_by_virtual_power(const Instant& instant, std::size_t driver) {
  const std::size_t row = instant.constraints().first_driver_row() + driver;
  return -instant.virtual_power(row) / instant.virtual_rate(driver);
}

void ReleasedConstraints::find_forces(const Instant& instant, Forces& forces) {
  const double length = instant.length();
  multipliers_.resize(instant.constraints().rows());
  for (std::size_t row = 0; row < multipliers_.size(); ++row) {
    multipliers_[row] = -instant.virtual_power(row) / (length * length);
  }
  share_out(instant.model(), instant.constraints(), multipliers_, length, forces.reactions, forces.effort);
}

}  // namespace loadpath::mechanism
