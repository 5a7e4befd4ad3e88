#include "lib/quantity/places.hpp"

#include <limits>

namespace loadpath {

std::vector<double> Places::values() const {
  return samples_.empty() ? si_ : std::vector<double>(samples_.begin(), samples_.end());
}

void Places::add_sample(std::uint64_t number) {
  if (si_.empty() && number <= std::numeric_limits<std::uint32_t>::max()) {
    samples_.push_back(static_cast<std::uint32_t>(number));
    return;
  }
  if (si_.empty()) si_ = values();
  samples_ = {};
  si_.push_back(static_cast<double>(number));
}

}  // namespace loadpath
