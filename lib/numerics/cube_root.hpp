// The cube root, inline and the same to the bit on every C library: it is half of what sizing a shaft costs.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace loadpath {

/// Within 0.67 units in the last place. A third of the exponent gives t to 4 %; a quartic (minimax) of t^3/|x| about 1
/// makes it 23 bits; rounded to 26 bits its square is exact, and a step of third order does the rest.
inline double cube_root(double x) {
  if (!std::isnormal(x)) return std::cbrt(x);
  const double size = std::abs(x), reciprocal = 1.0 / size;
  double t = std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) / 3 + 0x2a9f710000000000);
  const double z = t * t * (t * reciprocal), z2 = z * z;
  t *= (1.8756464067550622 + z2 * (1.619902617494929 + z2 * 0.14579451079410702)) +
       z * (-1.8838587060888095 + z2 * -0.7574848246843525);
  t = std::bit_cast<double>((std::bit_cast<std::uint64_t>(t) + 0x4000000) & ~std::uint64_t{0x7ffffff});
  const double square = t * t;
  const double step = (size / square - t) * (1.0 / 3.0);
  t += step - step * step * (square * reciprocal);
  return std::copysign(t, x);
}

}  // namespace loadpath
