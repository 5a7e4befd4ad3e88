// Logarithm and exponential without a branch, so that loops over columns go in wide registers, and equal to the bit on
// every C library. After the polynomials of fdlibm (Sun Microsystems 1993, e_log.c and e_exp.c), within 1 unit in the
// last place.
#pragma once

#include <bit>
#include <cstdint>

namespace loadpath::sweep {

/// ln(x) of a positive normal number.
inline double natural_log(double x) {
  constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
  constexpr std::uint64_t root_half = 0x3fe6a09e00000000;  // the mantissa goes from here to its double
  const std::uint64_t shifted = std::bit_cast<std::uint64_t>(x) + (0x3ff0000000000000 - root_half);
  const double k = std::bit_cast<double>(0x4330000000000000 | (shifted >> 52)) - (0x1p52 + 1023.0);
  const double f = std::bit_cast<double>((shifted & 0xfffffffffffff) + root_half) - 1.0;
  const double half_square = 0.5 * f * f, s = f / (2.0 + f), z = s * s, w = z * z;
  const double even = w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
  const double odd =
      z * (6.666666666666735130e-01 +
           w * (2.857142874366239149e-01 + w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
  return s * (half_square + (odd + even)) + k * ln2_low - half_square + f + k * ln2_high;
}

/// -ln(1 - p) of 0 < p < 1, of small p too.
inline double log_of_survival(double p) {
  const double q = 1.0 - p;
  return (p - (1.0 - q)) / q - natural_log(q);
}

/// e^x; beyond +-708 that of the bound.
inline double exponential(double x) {
  constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
  constexpr double shifter = 0x1.8p52;  // adding it rounds to an integer, which is in the low bits
  const double above = x < -708.0 ? -708.0 : x, bounded = above > 708.0 ? 708.0 : above;
  const double shifted = bounded * 1.44269504088896338700e+00 + shifter;
  const double k = shifted - shifter;
  const double high = bounded - k * ln2_high, low = k * ln2_low, r = high - low, t = r * r;
  const double c =
      r -
      t * (1.66666666666666019037e-01 +
           t * (-2.77777777770155933842e-03 +
                t * (6.61375632143793436117e-05 + t * (-1.65339022054652515390e-06 + t * 4.13813679705723846039e-08))));
  const double y = 1.0 + (r * c / (2.0 - c) - low + high);
  const std::uint64_t power = (std::bit_cast<std::uint64_t>(shifted) - std::bit_cast<std::uint64_t>(shifter)) << 52;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(y) + power);
}

}  // namespace loadpath::sweep
