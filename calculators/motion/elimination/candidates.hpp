// Equations that two laws of one time may fulfil; each is still to be compared with the path.
#pragma once

#include "calculators/motion/elimination/equation_text.hpp"
#include "calculators/motion/elimination/terms.hpp"

#include <string_view>
#include <vector>

namespace loadpath::motion {

/// A coordinate as a sum, with the largest magnitude that it has on the path.
struct SummedCoordinate {
  std::string_view name;
  Sum sum;
  double size = 0.0;
};

/// A constant coordinate, or one proportional to the other: a straight line.
void add_lines(const SummedCoordinate& x, const SummedCoordinate& y, std::vector<CurveEquation>& all);

/// Both coordinates linear in two functions f and g of the time with f^2 + g^2 = 1, f g = 1 or g = f^2.
void add_conics(const SummedCoordinate& x, const SummedCoordinate& y, std::vector<CurveEquation>& all);

/// One coordinate has a single power of the time, or a single exponential: the powers of the other are powers of it.
/// `smooth`: only where these are integers.
void add_powers(const SummedCoordinate& x, const SummedCoordinate& y, bool smooth, std::vector<CurveEquation>& all);

/// One coordinate is a single wave, those of the other are its multiples: cos n psi and sin n psi as Chebyshev
/// polynomials of cos psi.
void add_multiple_waves(const SummedCoordinate& x, const SummedCoordinate& y, std::vector<CurveEquation>& all);

}  // namespace loadpath::motion
