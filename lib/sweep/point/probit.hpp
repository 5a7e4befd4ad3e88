// The quantile of the standard normal distribution.
#pragma once

#include <span>

namespace loadpath::sweep {

/// The value below which a standard normal variable falls with probability p, 0 < p < 1: Wichura's AS 241 (PPND16,
/// Applied Statistics 37, 1988), within 1e-15 of its value.
double probit(double p);

/// The same to the bit for each of a column; both spans may be the same column.
void probit(std::span<const double> p, std::span<double> z);

}  // namespace loadpath::sweep
