// Quantiles of the distributions that scatter is described with.
#pragma once

namespace loadpath::numerics {

/// The value that a standard normal variable falls below with probability p; 0 < p < 1, NaN else.
double normal_quantile(double p);

/// The same of Student's t with n degrees of freedom, n >= 1, NaN else.
double student_quantile(double p, int n);

}  // namespace loadpath::numerics
