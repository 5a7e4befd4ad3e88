// Writes numbers and quantities for people, deterministically and without a locale.
#pragma once

#include "lib/quantity/dimension.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath {

/// `digits` significant digits, trailing zeros kept off, no exponent between 1e-4 and 1e7, U+2212 never: "-27.35".
std::string format_number(double value, int digits = 6);

/// The shortest text that reads back to the same double.
std::string format_exact(double value);
void append_exact(double value, std::string& text);

/// `si` in `unit` ("12.5 mm"; the unit as pretty_unit prints it; "30°"). NaN: "not available".
std::string format_quantity(double si, std::string_view unit, int digits = 6);

/// The unit as it is printed: "N*m" -> "N·m", "mm^2" -> "mm²", "deg/m" -> "°/m".
std::string pretty_unit(std::string_view unit);
/// Whether a space separates the unit as it is printed from its number: not from the sign of degrees, "30°".
bool takes_space(std::string_view pretty);
/// A number and its unit as it is printed, with this space between them where it takes one.
std::string with_unit(std::string number, std::string_view pretty, std::string_view space = " ");

/// A readable unit (MPa, kN, mm, N*m...) for a value of this dimension, as an ASCII unit text that parse_unit reads.
std::string readable_unit(double si, const Dimension& dimension, Kind kind = Kind::plain);

/// The factor and offset of a unit text that is known to be right (a field's own): asserts that it parses.
double in_unit(double si, std::string_view unit);
/// Converts many numbers: the unit is read once.
std::vector<double> in_unit(std::vector<double> si, std::string_view unit);

}  // namespace loadpath
