// The motion of a mechanism when one of its constraints is released, for every constraint: the inverse of the full
// Jacobian, for studies that need all of it.
#pragma once

#include "lib/mechanism/proof/instant.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

class VirtualMotions {
 public:
  explicit VirtualMotions(const Instant& instant);
  /// For the position of the instant. Does not allocate.
  void find(const Instant& instant);

  /// In units of length and rad, of all coordinates, at one unit per second.
  [[nodiscard]] std::span<const double> of(std::size_t row) const {
    return std::span(motions_).subspan(row * size_, size_);
  }
  /// The same of one link, m/s and 1/s.
  [[nodiscard]] Pose velocity(std::size_t row, std::size_t link) const {
    const double* v = &motions_[row * size_ + 3 * link];
    return {length_ * v[0], length_ * v[1], v[2]};
  }

 private:
  std::size_t size_;
  double length_;
  std::vector<double> rates_, motions_;
};

}  // namespace loadpath::mechanism
