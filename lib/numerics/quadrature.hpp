// The integral of a smooth function, to the last digits: Gauss's rule of eight points, halved until it agrees.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace loadpath::numerics {

/// Calls with each of the eight places of Gauss's rule, and its weight.
template <class Take>
void for_each_gauss_8(double from, double to, const Take& take) {
  constexpr std::array<double, 4> place{0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
  constexpr std::array<double, 4> weight{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                         0.1012285362903763};
  const double middle = (from + to) / 2.0, half = (to - from) / 2.0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    take(middle - half * place[i], half * weight[i]);
    take(middle + half * place[i], half * weight[i]);
  }
}

namespace detail {

template <class Function>
double gauss_8(const Function& f, double from, double to) {
  double sum = 0.0;
  for_each_gauss_8(from, to, [&](double x, double weight) { sum += weight * f(x); });
  return sum;
}

template <class Function>
double halved(const Function& f, double from, double to, double whole, double allowed, int depth) {
  const double middle = (from + to) / 2.0;
  const double left = gauss_8(f, from, middle), right = gauss_8(f, middle, to);
  if (depth == 0 || std::abs(left + right - whole) <= allowed) return left + right;
  return halved(f, from, middle, left, allowed, depth - 1) + halved(f, middle, to, right, allowed, depth - 1);
}

}  // namespace detail

/// The integral of a function that is finite between the bounds and does not change its sign.
template <class Function>
double integral(const Function& f, double from, double to) {
  constexpr double rounding = 1e-15;
  constexpr int most_halvings = 24;
  const double whole = detail::gauss_8(f, from, to);
  return detail::halved(f, from, to, whole, rounding * std::abs(whole), most_halvings);
}

}  // namespace loadpath::numerics
