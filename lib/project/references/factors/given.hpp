// Factors and loads that are given in a step, whether it is solved yet or not.
#pragma once

#include "lib/project/project.hpp"

#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

/// A factor of 1 does not count, nor one that is not given.
bool is_applied(double factor);
/// The first value of a series that is applied; 1 if none is.
double applied_factor(const std::vector<double>& si);
/// The factor that an input of a solved step is.
double factor_of(const Step& step, const std::string& key);
/// Whether a value of a step includes the factors of its loads: a load, and the corresponding power.
bool carries_factors(const FieldInfo& field);
/// The peak torque of a start or a jam, for yielding only: it is stated as it is, with an application factor or
/// without.
bool is_peak(const Operand& operand);

/// Whether the user has given an input of the step.
bool is_given(const StepInput& step, const std::string& key);
bool is_expression(const StepInput& step, const std::string& key);
/// The factor given in a step that may not be solved yet; NaN while its expression waits for other steps.
double given_factor(const Project& project, const StepInput& step, const std::string& key);
/// The same of a load: over a series the largest.
double largest_given(const Project& project, const StepInput& step, const std::string& key);
double largest_of(const Project& project, const Operand& operand);

/// The values of [values] of a dimension that an input is computed from: "values.F".
std::set<std::string> values_in(const Operand& operand, const Dimension& dimension, const Project& project);

}  // namespace loadpath::project
