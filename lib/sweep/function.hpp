// The function to be swept, searched and differentiated: a function of a point, evaluated at many points at once.
#pragma once

#include <cstddef>
#include <span>

namespace loadpath::sweep {

/// Inputs in, results out, column by column; the same point gives the same bits in any batch. An object works for one
/// thread.
class Function {
 public:
  Function() = default;
  virtual ~Function() = default;
  Function(const Function&) = delete;
  Function& operator=(const Function&) = delete;

  [[nodiscard]] virtual std::size_t inputs() const = 0;
  [[nodiscard]] virtual std::size_t outputs() const = 0;
  /// `in` has a column of n values for each input, `out` takes one for each output. SI; missing values are NaN.
  virtual void evaluate(std::span<const double* const> in, std::span<double* const> out, std::size_t n) = 0;
};

}  // namespace loadpath::sweep
