// Integers in formulas: teeth, links, belts. A double in arithmetic, so that z_2 / z_1 divides as written; an integer
// only on explicit request.
#pragma once

#include "lib/quantity/units.hpp"

#include <concepts>
#include <cstddef>

namespace loadpath {

class Whole {
 public:
  constexpr Whole() = default;
  template <std::integral Integer>
  constexpr Whole(Integer number) : number_(static_cast<int>(number)) {}  // NOLINT(google-explicit-constructor)
  constexpr explicit Whole(double number) : number_(static_cast<int>(number)) {}

  constexpr operator double() const { return number_; }  // NOLINT(google-explicit-constructor)
  constexpr explicit operator int() const { return number_; }
  constexpr explicit operator std::size_t() const { return static_cast<std::size_t>(number_); }
  constexpr friend int operator%(Whole number, int divisor) { return number.number_ % divisor; }

 private:
  int number_ = 0;
};

// Boost's operators take arithmetic types only.
template <class Quantity>
requires requires(Quantity q) { q.value(); }
[[nodiscard]] constexpr auto operator*(Whole count, const Quantity& q) { return static_cast<double>(count) * q; }
template <class Quantity>
requires requires(Quantity q) { q.value(); }
[[nodiscard]] constexpr auto operator*(const Quantity& q, Whole count) { return q * static_cast<double>(count); }
template <class Quantity>
requires requires(Quantity q) { q.value(); }
[[nodiscard]] constexpr auto operator/(const Quantity& q, Whole count) { return q / static_cast<double>(count); }
template <class Quantity>
requires requires(Quantity q) { q.value(); }
[[nodiscard]] constexpr auto operator/(Whole count, const Quantity& q) { return static_cast<double>(count) / q; }

namespace detail {

template <>
struct Traits<Whole> {
  static constexpr Dimension dimension{};
};

}  // namespace detail

}  // namespace loadpath
