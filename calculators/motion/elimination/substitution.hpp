// Elimination of the time by substitution: one law is solved for the time, which the other law takes in its place.
#pragma once

#include "calculators/motion/elimination/equation_text.hpp"

#include <string_view>
#include <vector>

namespace loadpath::motion {

/// y = y(t(x)), if the law of x contains the time once and consists of functions with an inverse. The inverse is that
/// of one branch: the comparison with the path decides whether it holds.
void add_substitution(std::string_view x_name, std::string_view x_law, std::string_view y_name, std::string_view y_law,
                      std::vector<CurveEquation>& all);

}  // namespace loadpath::motion
