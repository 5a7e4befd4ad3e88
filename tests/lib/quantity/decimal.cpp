#include "lib/quantity/decimal.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace loadpath;

namespace {

std::string nearest_text(double value, double rounding) {
  std::string text;
  Decimals::beyond(rounding).append_nearest(value, text);
  return text;
}

std::string exact_text(double value, double rounding) {
  std::string text;
  Decimals::within(rounding).append_exact(value, text);
  return text;
}

double read(const std::string& text) {
  double value = NAN;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value).ptr;
  CHECK(end == text.data() + text.size());
  return value;
}

}  // namespace

TEST_SUITE("quantity") {
  TEST_CASE("a number has the digits that its rounding leaves, and no others") {
    struct Row {
      double value, rounding;
      std::string text;
    };
    const Row rows[] = {{4.99999999999999, 1e-13, "5"},
                        {29.999999999999996, 2e-12, "30"},
                        {-0.1 - 0.2, 1e-12, "-0.3"},
                        {2.0 / 3.0, 1e-6, "0.666667"},
                        {2.0 / 3.0, 1.1e-6, "0.66667"},
                        {-1234.5678, 1e-2, "-1234.57"},
                        {1234567.0, 1e3, "1235000"},
                        {0.0004, 1e-6, "0.0004"},
                        {0.00001234, 1e-9, "1.234e-05"},
                        {3e-20, 1e-21, "3e-20"},
                        {1.5e20, 1e10, "1.5e+20"},
                        {4e-14, 1e-13, "0"},
                        {-4e-14, 1e-13, "0"},
                        {-0.0, 1e-13, "0"},
                        {0.0, 1e-13, "0"}};
    for (const Row& row : rows) {
      CAPTURE(row.value);
      CHECK(nearest_text(row.value, row.rounding) == row.text);
    }
  }

  TEST_CASE("a number with more digits than a double has is written unchanged") {
    CHECK(read(nearest_text(1.0 / 3.0, 1e-30)) == 1.0 / 3.0);
    CHECK(read(nearest_text(1e300, 1e-30)) == 1e300);
    CHECK(read(exact_text(1.0 / 3.0, 0.0)) == 1.0 / 3.0);
    CHECK(Decimals::within(0.0).nearest(1.0 / 3.0) == 1.0 / 3.0);
    CHECK(Decimals::within(1e-30).nearest(1e300) == 1e300);
    CHECK(std::isnan(Decimals::within(1e-3).nearest(NAN)));
    CHECK(std::isinf(Decimals::within(1e-3).nearest(INFINITY)));
    CHECK(Decimals::within(INFINITY).nearest(2.5) == 0.0);
  }

  TEST_CASE("a column is rounded as each of its numbers, and what is below its rounding is zero") {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> mantissa(-1.0, 1.0), ten(-12.0, 9.0);
    for (int n = 0; n < 300; ++n) {
      const double size = std::pow(10.0, ten(random)), rounding = size * 1e-9;
      std::vector<double> values{0.0, -0.0, 0.5 * rounding, -rounding};
      for (int k = 0; k < 33; ++k) values.push_back(size * mantissa(random));
      if (n % 10 == 0) values.push_back(NAN), values.push_back(1e300);  // more digits than a double
      const Decimals decimals = Decimals::within(rounding);
      std::vector<double> rounded = values;
      decimals.round(rounded, rounding);
      for (std::size_t k = 0; k < values.size(); ++k) {
        const double expected = std::abs(values[k]) <= rounding ? 0.0 : decimals.nearest(values[k]);
        CHECK(std::bit_cast<std::uint64_t>(rounded[k]) == std::bit_cast<std::uint64_t>(expected));
      }
    }
  }

  TEST_CASE("numbers of all sizes: within half a step, read back to the bit, as short as the shortest") {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> mantissa(-1.0, 1.0), ten(-18.0, 18.0), digits(1.0, 13.0);
    for (int n = 0; n < 20000; ++n) {
      const double largest = std::pow(10.0, std::floor(ten(random))), value = largest * mantissa(random);
      const double rounding = largest * std::pow(10.0, -digits(random));
      CAPTURE(value);
      CAPTURE(rounding);
      const double nearest = Decimals::within(rounding).nearest(value);
      CHECK(std::abs(nearest - value) <= 0.5 * rounding * (1.0 + 1e-3));
      CHECK(Decimals::within(rounding).nearest(nearest) == nearest);
      const std::string text = exact_text(nearest, rounding), any = exact_text(value, rounding);
      CHECK(read(text) == nearest);
      CHECK(read(any) == value);
      char shortest[40];
      const auto end = std::to_chars(shortest, shortest + sizeof shortest, nearest, std::chars_format::scientific).ptr;
      const auto digits_in = [](const std::string& number) {
        const std::string written = number.substr(0, number.find('e'));
        std::string all;
        std::copy_if(written.begin(), written.end(), std::back_inserter(all),
                     [](char c) { return c >= '0' && c <= '9'; });
        all.erase(0, std::min(all.find_first_not_of('0'), all.size()));
        all.erase(all.find_last_not_of('0') + 1);
        return all;
      };
      CHECK(digits_in(text) == digits_in(std::string(shortest, end)));
      CHECK(std::abs(read(nearest_text(value, rounding)) - value) <= 5.0 * rounding * (1.0 + 1e-3));
    }
  }
}
