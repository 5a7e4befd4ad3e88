// The cube root, inline and the same to the bit on every C library: it takes half of the time of sizing a shaft.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace loadpath::numerics {

/// Within 0.67 units in the last place, without a branch, so that it goes in lanes. A third of the exponent gives t to
/// 4 %; a quartic (minimax) of t^3/|x| about 1 makes it 23 bits; rounded to 26 bits its square is exact, and a step of
/// third order does the rest.
inline double cube_root(double x) {
  const double magnitude = std::abs(x);
  const bool tiny = magnitude < std::numeric_limits<double>::min();
  const double size = tiny ? magnitude * 0x1p54 : magnitude;
  const double reciprocal = 1.0 / size;
  const std::uint64_t high = std::bit_cast<std::uint64_t>(size) >> 32;
  double t = std::bit_cast<double>((((high * 0x55555556) >> 32) << 32) + 0x2a9f710000000000);
  const double z = t * t * (t * reciprocal), z2 = z * z;
  t *= (1.8756464067550622 + z2 * (1.619902617494929 + z2 * 0.14579451079410702)) +
       z * (-1.8838587060888095 + z2 * -0.7574848246843525);
  t = std::bit_cast<double>((std::bit_cast<std::uint64_t>(t) + 0x4000000) & ~std::uint64_t{0x7ffffff});
  const double square = t * t;
  const double step = (size / square - t) * (1.0 / 3.0);
  t += step - step * step * (square * reciprocal);
  t = tiny ? t * 0x1p-18 : t;
  const bool itself = !(magnitude > 0.0 && magnitude <= std::numeric_limits<double>::max());
  return itself ? x : std::copysign(t, x);
}

}  // namespace loadpath::numerics
