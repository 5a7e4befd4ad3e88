#include "lib/quantity/decimal.hpp"

#include "lib/quantity/format.hpp"
#include "lib/quantity/number/power_of_ten.hpp"
#include "lib/simd/attributes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string_view>

namespace loadpath {
namespace {

// Integers up to here, of fifteen digits, are doubles, and no two of them are the same double at any power of ten.
constexpr double most = 1e15;

/// The nearest integer multiple of 10^power; NaN if it has more digits than a double.
double whole(double value, int power) {
  const double multiple = times_power_of_ten(value, -power);
  if (!(std::abs(multiple) < most)) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(static_cast<std::int64_t>(multiple + std::copysign(0.5, multiple)));
}

constexpr std::array<char, 200> pairs = [] {
  std::array<char, 200> digits{};
  for (std::size_t n = 0; n < 100; ++n) {
    digits[2 * n] = static_cast<char>('0' + n / 10);
    digits[2 * n + 1] = static_cast<char>('0' + n % 10);
  }
  return digits;
}();

/// Digits that are written from the last to the first.
class Digits {
 public:
  /// Writes the last `count` digits of a number, with leading zeros if it has fewer; returns the rest.
  std::uint64_t put(std::uint64_t number, int count) {
    for (; count > 1; count -= 2, number /= 100) put_pair(number % 100);
    if (count == 0) return number;
    *--first_ = static_cast<char>('0' + number % 10);
    return number / 10;
  }
  void put(std::uint64_t number) {
    for (; number >= 100; number /= 100) put_pair(number % 100);
    if (number >= 10) return put_pair(number);
    *--first_ = static_cast<char>('0' + number);
  }
  void put(char sign) { *--first_ = sign; }
  /// Removes trailing zeros after the point, and the point without digits.
  void cut_zeros() {
    while (end_[-1] == '0') --end_;
    if (end_[-1] == '.') --end_;
  }
  [[nodiscard]] std::string_view text() const { return {first_, static_cast<std::size_t>(end_ - first_)}; }

 private:
  void put_pair(std::uint64_t number) {
    first_ -= 2;
    std::memcpy(first_, pairs.data() + 2 * number, 2);
  }

  std::array<char, 48> text_;  // filled from its end
  char* first_ = text_.data() + text_.size();
  char* end_ = first_;
};

/// With a point before the last digits, without trailing zeros.
void append_with_point(std::uint64_t number, int behind, bool negative, std::string& text) {
  Digits digits;
  const std::uint64_t whole_part = digits.put(number, behind);
  digits.put('.');
  digits.put(whole_part);
  if (negative) digits.put('-');
  digits.cut_zeros();
  text += digits.text();
}

void append_whole(std::uint64_t number, int zeros, bool negative, std::string& text) {
  Digits digits;
  digits.put(0, zeros);
  digits.put(number);
  if (negative) digits.put('-');
  text += digits.text();
}

/// "1.25e-07", as the standard library writes it: where a point would take too many zeros.
void append_with_exponent(std::uint64_t number, int power, bool negative, std::string& text) {
  for (; number % 10 == 0; number /= 10) ++power;
  Digits digits;
  int behind = 0;
  for (std::uint64_t left = number; left >= 10; left /= 10) ++behind;
  const int exponent = power + behind;
  digits.put(static_cast<std::uint64_t>(std::abs(exponent)), std::abs(exponent) < 100 ? 2 : 3);
  digits.put(exponent < 0 ? '-' : '+');
  digits.put('e');
  const std::uint64_t first = digits.put(number, behind);
  if (behind > 0) digits.put('.');
  digits.put(first);
  if (negative) digits.put('-');
  text += digits.text();
}

/// `number`, an integer below `most`, times 10^power. With an exponent from 10^15 on, and below 10^-4.
void append_multiple(double number, int power, std::string& text) {
  const auto size = static_cast<std::uint64_t>(std::abs(number));
  const double value = std::abs(number) * 1e4;
  if (size == 0) {
    text += '0';
  } else if (power < 0 && power >= -18 && value >= powers_of_ten[static_cast<std::size_t>(-power)]) {
    append_with_point(size, -power, number < 0.0, text);
  } else if (power >= 0 && power <= 15 && std::abs(number) < powers_of_ten[static_cast<std::size_t>(15 - power)]) {
    append_whole(size, power, number < 0.0, text);
  } else {
    append_with_exponent(size, power, number < 0.0, text);
  }
}

/// To multiples of 1/power, smaller values to zero; as Decimals::nearest, in lanes. False, with the values as they
/// were, if one of them has more digits than a double.
LOADPATH_COLUMNS bool round_fractions(double power, double zero, std::span<double> values) {
  double* const x = values.data();
  std::array<double, 8> beyond{};
  std::size_t i = 0;
  for (; i + beyond.size() <= values.size(); i += beyond.size()) {
    LOADPATH_LANEWISE
    for (std::size_t lane = 0; lane < beyond.size(); ++lane)
      beyond[lane] += std::abs(x[i + lane] * power) < most ? 0.0 : 1.0;
  }
  for (; i < values.size(); ++i) beyond[0] += std::abs(x[i] * power) < most ? 0.0 : 1.0;
  if (std::ranges::any_of(beyond, [](double count) { return count != 0.0; })) return false;
  LOADPATH_POINTWISE
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double multiple = x[k] * power;
    const double nearest = std::trunc(multiple + std::copysign(0.5, multiple)) / power + 0.0;
    x[k] = std::abs(x[k]) <= zero ? 0.0 : nearest;
  }
  return true;
}

/// Clamps to a power of ten beyond all doubles, also for zero.
int bounded(double power) { return static_cast<int>(std::clamp(power, -400.0, 400.0)); }

}  // namespace

Decimals Decimals::within(double rounding) { return Decimals(bounded(std::floor(std::log10(rounding)))); }
Decimals Decimals::beyond(double rounding) { return Decimals(bounded(std::ceil(std::log10(rounding)))); }

double Decimals::nearest(double value) const {
  const double number = whole(value, power_);
  return std::isnan(number) ? value : times_power_of_ten(number, power_) + 0.0;
}

void Decimals::round(std::span<double> values, double zero) const {
  if (power_ < 0 && power_ >= -exact_power_of_ten &&
      round_fractions(powers_of_ten[static_cast<std::size_t>(-power_)], zero, values))
    return;
  for (double& x : values) x = std::abs(x) <= zero ? 0.0 : nearest(x);
}

void Decimals::append_nearest(double value, std::string& text) const {
  const double number = whole(value, power_);
  if (std::isnan(number)) return loadpath::append_exact(value, text);
  append_multiple(number, power_, text);
}

void Decimals::append_exact(double value, std::string& text) const {
  const double number = whole(value, power_);
  const bool read_back = std::abs(power_) <= exact_power_of_ten && times_power_of_ten(number, power_) == value;
  if (!read_back) return loadpath::append_exact(value, text);
  append_multiple(number, power_, text);
}

}  // namespace loadpath
