// A middle of the inputs' values in a sweep, and their deviations to both sides.
#pragma once

#include "lib/project/read/sweep_settings.hpp"
#include "lib/project/sweep/axes.hpp"

#include <vector>

namespace loadpath::project {

/// The mean of an uncertain input, the middle one of values, the first word.
double middle_of(const SweptInput& input);
/// The 5 % and 95 % quantiles of an uncertain input, else its bounds.
double low_of(const SweptInput& input);
double high_of(const SweptInput& input);
/// Standard deviation; of values that are given, 0.
double sd_of(const SweptInput& input);
/// Whether it is { from, to }: a range that a search may choose from.
bool is_continuous(const SweptInput& input);

std::vector<double> middles_of(const std::vector<SweptInput>& inputs);

/// The correlation matrix of some of the inputs, row by row; pairs with another are skipped.
std::vector<double> correlation_matrix(const std::vector<SweptInput>& inputs, const std::vector<std::size_t>& among,
                                       const std::vector<Correlated>& pairs);

}  // namespace loadpath::project
