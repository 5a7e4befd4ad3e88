// Points that fill a cube evenly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace loadpath::sweep {

/// The additive sequence whose steps are the powers of the root of x^(d+1) = x + 1: the golden ratio's in more than one
/// dimension (M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018; as recalled).
class Spread {
 public:
  explicit Spread(std::size_t dimensions);
  /// From 0, included, to 1.
  [[nodiscard]] double operator()(std::uint64_t index, std::size_t dimension) const;

 private:
  std::vector<double> steps;
};

}  // namespace loadpath::sweep
