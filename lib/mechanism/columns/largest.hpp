// Largest sizes of a cycle's columns; positions without a number are skipped.
#pragma once

#include <span>

namespace loadpath::mechanism {

/// The largest magnitude; 0 of nothing.
double largest_size(std::span<const double> x);
/// The largest square of the vectors' lengths; 0 of nothing.
double largest_square(std::span<const double> x, std::span<const double> y);
/// Raises each number to the square of the vector's length at its position, if that is larger. Whether all squares
/// are finite.
bool raise_to_squares(std::span<const double> x, std::span<const double> y, std::span<double> most);
/// The roots of squares that are not negative.
void take_roots(std::span<double> squares);

}  // namespace loadpath::mechanism
