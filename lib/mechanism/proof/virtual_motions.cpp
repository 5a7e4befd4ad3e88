#include "lib/mechanism/proof/virtual_motions.hpp"

#include <algorithm>

namespace loadpath::mechanism {

VirtualMotions::VirtualMotions(const Instant& instant)
    : size_(instant.constraints().rows()), length_(instant.length()), rates_(size_), motions_(size_ * size_) {}

void VirtualMotions::find(const Instant& instant) {
  const std::span<const GroupRows> groups = instant.inverse().groups();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (const std::size_t row : groups[g].rows) {
      std::ranges::fill(rates_, 0.0);
      rates_[row] = 1.0;
      instant.inverse().find_motion(rates_, std::span(motions_).subspan(row * size_, size_), g);
    }
  }
}

}  // namespace loadpath::mechanism
