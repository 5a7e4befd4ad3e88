#include "calculators/motion/elimination/equation_text.hpp"

#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace loadpath::motion {

namespace {

/// The coefficients of a polynomial of x - origin as those of one of x: a row of Horner's scheme for each.
std::vector<double> multiplied_out(std::vector<double> c, double origin) {
  for (std::size_t first = 0; first + 1 < c.size(); ++first) {
    for (std::size_t k = c.size() - 1; k > first; --k) c[k - 1] -= origin * c[k];
  }
  return c;
}

void drop_small(std::vector<double>& c, double size) {
  double largest = 0.0, reach = 1.0;
  for (const double coefficient : c) {
    largest = std::max(largest, std::abs(coefficient) * reach);
    reach *= size;
  }
  reach = 1.0;
  for (double& coefficient : c) {
    if (std::abs(coefficient) * reach <= 1e-12 * largest) coefficient = 0.0;
    reach *= size;
  }
}

/// Whether a text is a name, or has parentheses around all of it.
bool is_one_factor(const std::string& text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    const bool is_outside = depth == 0 && i + 1 < text.size();
    if (is_outside && std::string_view("*/+-^ )").find(text[i]) != std::string_view::npos) return false;
  }
  return true;
}

std::ptrdiff_t terms_in(const std::vector<double>& c) {
  return std::ranges::count_if(c, [](double coefficient) { return coefficient != 0.0; });
}

}  // namespace

std::string number_text(double value) {
  constexpr int digits = 10;
  return format_number(value, digits);
}

std::string shifted_text(std::string_view name, double origin) {
  std::string text(name);
  if (origin == 0.0) return text;
  return "(" + text + (origin > 0.0 ? " - " : " + ") + number_text(std::abs(origin)) + ")";
}

std::string divided_text(const std::string& dividend, double divisor) {
  const std::string number = number_text(divisor);
  if (number == "1") return dividend;
  return dividend + "/" + (divisor < 0.0 ? "(" + number + ")" : number);
}

std::string power_text(const std::string& base, double exponent) {
  const std::string number = number_text(exponent);
  if (number == "1") return base;
  return (is_one_factor(base) ? base : "(" + base + ")") + "^" + (exponent < 0.0 ? "(" + number + ")" : number);
}

SumText& SumText::add(double coefficient, const std::string& factor) {
  if (coefficient == 0.0) return *this;
  const std::string number = number_text(std::abs(coefficient));
  if (text_.empty()) {
    text_ = coefficient < 0.0 ? "-" : "";
  } else {
    text_ += coefficient < 0.0 ? " - " : " + ";
  }
  text_ += factor.empty() ? number : number == "1" ? factor : number + "*" + factor;
  return *this;
}

std::string polynomial_text(const std::vector<double>& coefficients, std::string_view name, double origin,
                            double size) {
  std::vector<double> near = coefficients, out = multiplied_out(coefficients, origin);
  drop_small(near, size);
  drop_small(out, size);
  const bool is_shifted = terms_in(near) < terms_in(out);
  const std::string base = is_shifted ? shifted_text(name, origin) : std::string(name);
  const std::vector<double>& c = is_shifted ? near : out;
  SumText sum;
  for (std::size_t k = c.size(); k-- > 1;) sum.add(c[k], power_text(base, static_cast<double>(k)));
  sum.add(c[0], "");
  return sum.text();
}

}  // namespace loadpath::motion
