#include "lib/quantity/decimal.hpp"

#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string_view>

namespace loadpath {
namespace {

constexpr std::array<double, 23> powers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                           1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr int exact_powers = static_cast<int>(powers.size()) - 1;

// Integers up to here, of fifteen digits, are doubles, and no two of them are the same double at any power of ten.
constexpr double most = 1e15;

/// The nearest whole number of 10^power; NaN where it has more digits than a double can tell.
double whole(double value, int power) {
  const double multiple = times_power_of_ten(value, -power);
  if (!(std::abs(multiple) < most)) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(static_cast<std::int64_t>(multiple + std::copysign(0.5, multiple)));
}

/// Digits as they are written, with room for a sign and zeros in front, and for a point and zeros behind.
class Digits {
 public:
  explicit Digits(std::uint64_t number) : end_(std::to_chars(first_, text_.data() + text_.size(), number).ptr) {}

  /// Times 10^power: with a point, or with an exponent where that would take too many zeros.
  void place(int power) {
    const auto before = static_cast<int>(end_ - first_) + power;  // digits before the point
    if (before < -3 || before > 15) {
      raise(before - 1);
    } else if (before <= 0) {
      first_ -= 2 - before;
      std::fill_n(first_, 2 - before, '0');
      first_[1] = '.';
    } else if (power < 0) {
      put_point(before);
    } else {
      end_ = std::fill_n(end_, power, '0');
    }
  }
  void put_sign() { *--first_ = '-'; }
  [[nodiscard]] std::string_view text() const { return {first_, static_cast<std::size_t>(end_ - first_)}; }

 private:
  void put_point(int before) {
    std::copy_backward(first_ + before, end_, end_ + 1);
    first_[before] = '.';
    ++end_;
  }
  void raise(int exponent) {
    if (end_ - first_ > 1) put_point(1);
    *end_++ = 'e';
    *end_++ = exponent < 0 ? '-' : '+';
    if (std::abs(exponent) < 10) *end_++ = '0';
    end_ = std::to_chars(end_, text_.data() + text_.size(), std::abs(exponent)).ptr;
  }

  std::array<char, 48> text_{};
  char* first_ = text_.data() + 8;
  char* end_;
};

/// `number`, whole and below `most`, times 10^power.
void append_multiple(double number, int power, std::string& text) {
  auto left = static_cast<std::uint64_t>(std::abs(number));
  if (left == 0) {
    text += '0';
    return;
  }
  for (; left % 10 == 0; left /= 10) ++power;
  Digits digits(left);
  digits.place(power);
  if (number < 0.0) digits.put_sign();
  text += digits.text();
}

/// A power of ten that is beyond all doubles stands for those beyond it, and for that of zero.
int bounded(double power) { return static_cast<int>(std::clamp(power, -400.0, 400.0)); }

}  // namespace

double times_power_of_ten(double x, int ten) {
  for (; ten > exact_powers; ten -= exact_powers) x *= powers.back();
  for (; ten < -exact_powers; ten += exact_powers) x /= powers.back();
  const double power = powers[static_cast<std::size_t>(std::abs(ten))];
  return ten < 0 ? x / power : x * power;
}

Decimals Decimals::within(double rounding) { return Decimals(bounded(std::floor(std::log10(rounding)))); }
Decimals Decimals::beyond(double rounding) { return Decimals(bounded(std::ceil(std::log10(rounding)))); }

double Decimals::nearest(double value) const {
  const double number = whole(value, power_);
  return std::isnan(number) ? value : times_power_of_ten(number, power_) + 0.0;
}

void Decimals::append_nearest(double value, std::string& text) const {
  const double number = whole(value, power_);
  if (std::isnan(number)) return loadpath::append_exact(value, text);
  append_multiple(number, power_, text);
}

void Decimals::append_exact(double value, std::string& text) const {
  const double number = whole(value, power_);
  const bool read_back = std::abs(power_) <= exact_powers && times_power_of_ten(number, power_) == value;
  if (!read_back) return loadpath::append_exact(value, text);
  append_multiple(number, power_, text);
}

}  // namespace loadpath
