// Powers of ten that a double holds exactly, and products with them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdlib>

namespace loadpath {

inline constexpr std::array<double, 23> powers_of_ten = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                         1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                         1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
inline constexpr int exact_power_of_ten = static_cast<int>(powers_of_ten.size()) - 1;

/// x * 10^ten; up to 10^22 a power of ten is exact and the result is rounded once.
inline double times_power_of_ten(double x, int ten) {
  for (; ten > exact_power_of_ten; ten -= exact_power_of_ten) x *= powers_of_ten.back();
  for (; ten < -exact_power_of_ten; ten += exact_power_of_ten) x /= powers_of_ten.back();
  const double power = powers_of_ten[static_cast<std::size_t>(std::abs(ten))];
  return ten < 0 ? x / power : x * power;
}

}  // namespace loadpath
