// Equations of curves as texts in the language of expressions: "(x - 1)^2 + y^2 = 9".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::motion {

/// The form of a path, of which the equation is given.
enum class PathForm { no_range, no_equation, point, line, circle, ellipse, parabola, hyperbola, other };

struct CurveEquation {
  std::string text;  // without units: coordinates in m
  PathForm form = PathForm::no_equation;
};

std::string number_text(double value);
/// "x", "(x - 2)", "(x + 2)": a coordinate from another origin.
std::string shifted_text(std::string_view name, double origin);
/// "x/3", "(x - 2)/3"; the divisor 1 is left out.
std::string divided_text(const std::string& dividend, double divisor);
/// "x^2"; the exponent 1 is left out, and a quotient is put in parentheses.
std::string power_text(const std::string& base, double exponent);

/// A sum, term by term, with its signs: "-2*x^2 + y - 1".
class SumText {
 public:
  /// Nothing where the coefficient is zero; an empty factor is a number.
  SumText& add(double coefficient, const std::string& factor);
  [[nodiscard]] std::string text() const { return text_.empty() ? "0" : text_; }

 private:
  std::string text_;
};

/// A polynomial, coefficients from the constant on, of the coordinate from `origin`: multiplied out, unless that takes
/// more terms. `size`: the largest coordinate, by which terms that are rounding are known.
std::string polynomial_text(const std::vector<double>& coefficients, std::string_view name, double origin, double size);

}  // namespace loadpath::motion
