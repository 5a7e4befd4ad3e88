// Whether the constraints of a large mechanism are independent, and the least step that closes them. The Jacobian has a
// few entries per row, and its sparse factors take work in proportion to their number, where dense ones take its cube.
#pragma once

#include "lib/mechanism/equations/kinematics.hpp"

#include <memory>
#include <span>

namespace loadpath::mechanism {

/// Below this size the dense factors take no longer.
inline bool is_large(const Constraints& constraints) {
  constexpr std::size_t most_dense = 60;  // rows, of twenty links
  return constraints.rows() > most_dense;
}

class RowFactors {
 public:
  /// At the position of the constraints.
  explicit RowFactors(const Constraints& constraints);
  ~RowFactors();
  RowFactors(const RowFactors&) = delete;
  RowFactors& operator=(const RowFactors&) = delete;

  /// Independent beyond doubt: the estimated condition number is far from the threshold of the rank. Dependent or
  /// nearly dependent rows are left to a decomposition with pivots.
  [[nodiscard]] bool independent() const;
  /// The step of least norm with J step = residual; only of independent rows.
  void find_step(std::span<const double> residual, std::span<double> step) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace loadpath::mechanism
