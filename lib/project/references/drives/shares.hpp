// Shares of a load of [values] that a step takes, and what explains them without a reason.
#pragma once

#include "lib/project/project.hpp"

#include <cmath>
#include <functional>
#include <string>

namespace loadpath::project {

inline constexpr double least_share = 0.85;  // losses of a drive need no reason
inline constexpr double few_digits = 0.02;   // values that are written with few digits

/// A load, or the mass or inertia of a part that is moved, which loads its drive.
bool loads_a_part(const FieldInfo& field, std::string_view path);

/// The amplitude, the middle or the lower end of a cycle, less than its peak by definition. The mean power of a drive
/// is its load.
bool is_part_of_cycle(const Step& step, const Operand& operand);

/// A count of the step that the whole is divided by, or multiplied with: four screws.
bool is_count_of_parts(const Step& step, const Project& project, const Operand& operand, double share);

/// A force or mass that two equal parts share: symmetrical supports, two rods. A torque has no such supports; the load
/// of a column or of a mechanism is that of the whole.
bool is_half_of_two(const Step& step, const Operand& operand, double share);

/// The number in the formula of an input as it is written, where it refers to a value of its dimension with a word of
/// its own: 0.5 of "=values.phi*values.R_max/2", whatever R_max is computed from; NaN of any other formula.
double number_of_named_value(const Operand& operand, const Project& project);

/// What the inputs of the project take of a whole, named by the values that it is computed from, in parts, as loads of
/// this dimension. A shaft that carries the whole in front of its hubs takes none of their parts.
using ValuesOf = std::function<std::string(const Operand& operand)>;
double taken_in_parts(const Project& project, const std::string& values, double whole, const Dimension& dimension,
                      const ValuesOf& values_of);

}  // namespace loadpath::project
