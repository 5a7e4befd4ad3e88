#include "calculators/motion/elimination/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace loadpath::motion {

namespace {

constexpr int highest_degree = 8;

/// The function of the time of one coordinate as a power of that of the other, with its coefficient.
struct Related {
  double exponent = 0.0, coefficient = 0.0;
};

bool is_whole(double x) { return std::abs(x - std::round(x)) <= 1e-10; }

/// The terms of `y` as powers of the single term of `x`; empty if they are none.
std::vector<Related> related_to(const Sum& y, const Term& of_x) {
  std::vector<Related> powers;
  for (const Term& term : y.terms) {
    if (term.kind != of_x.kind || term.is_wave()) return {};
    std::optional<double> exponent = ratio_of(term.argument, of_x.argument);
    if (term.kind == Term::Kind::power) exponent = term.argument[0].exponent / of_x.argument[0].exponent;
    if (!exponent) return {};
    powers.push_back({is_whole(*exponent) ? std::round(*exponent) : *exponent, term.coefficient});
  }
  return powers;
}

PathForm form_of_degree(std::size_t degree) {
  if (degree == 1) return PathForm::line;
  return degree == 2 ? PathForm::parabola : PathForm::other;
}

void add_polynomial(const SummedCoordinate& x, const SummedCoordinate& y, const std::vector<Related>& powers,
                    std::vector<CurveEquation>& all) {
  std::vector<double> c{y.sum.constant};
  for (const Related& power : powers) {
    const auto degree = static_cast<std::size_t>(power.exponent);
    if (degree >= c.size()) c.resize(degree + 1);
    c[degree] += power.coefficient / std::pow(x.sum.terms[0].coefficient, power.exponent);
  }
  all.push_back(
      {std::string(y.name) + " = " + polynomial_text(c, x.name, x.sum.constant, x.size), form_of_degree(c.size() - 1)});
}

/// y^n = k x^m, or x^m y^n = k: holds for either sign of the time.
void add_pair(const SummedCoordinate& x, const SummedCoordinate& y, const Related& power,
              std::vector<CurveEquation>& all) {
  int n = 2;
  while (n <= highest_degree && !is_whole(n * power.exponent)) ++n;
  const double m = std::round(std::abs(n * power.exponent));
  if (n > highest_degree || m > highest_degree) return;
  const std::string X = power_text(shifted_text(x.name, x.sum.constant), m);
  const std::string Y = power_text(shifted_text(y.name, y.sum.constant), n);
  const double of_x = std::pow(x.sum.terms[0].coefficient, m), of_y = std::pow(power.coefficient, n);
  if (power.exponent < 0.0) {
    all.push_back({X + "*" + Y + " = " + number_text(of_x * of_y), PathForm::other});
  } else {
    all.push_back({Y + " = " + SumText().add(of_y / of_x, X).text(), PathForm::other});
  }
}

/// y as a sum of powers of x with any exponents, of the side on which x lies.
void add_sum(const SummedCoordinate& x, const SummedCoordinate& y, const std::vector<Related>& powers,
             std::vector<CurveEquation>& all) {
  const double factor = x.sum.terms[0].coefficient, origin = x.sum.constant;
  std::string base = shifted_text(x.name, origin);
  if (factor < 0.0) base = "(" + (origin == 0.0 ? "-" : number_text(origin) + " - ") + std::string(x.name) + ")";
  SumText sum;
  for (const Related& power : powers)
    sum.add(power.coefficient / std::pow(std::abs(factor), power.exponent), power_text(base, power.exponent));
  sum.add(y.sum.constant, "");
  const bool is_hyperbola =
      std::ranges::all_of(powers, [](const Related& power) { return std::abs(power.exponent) == 1.0; });
  all.push_back({std::string(y.name) + " = " + sum.text(), is_hyperbola ? PathForm::hyperbola : PathForm::other});
}

}  // namespace

void add_powers(const SummedCoordinate& x, const SummedCoordinate& y, bool smooth, std::vector<CurveEquation>& all) {
  if (x.sum.terms.size() != 1) return;
  const std::vector<Related> powers = related_to(y.sum, x.sum.terms[0]);
  if (powers.empty()) return;
  const bool is_polynomial = std::ranges::all_of(powers, [](const Related& power) {
    return is_whole(power.exponent) && power.exponent > 0.0 && power.exponent <= highest_degree;
  });
  if (smooth && is_polynomial) add_polynomial(x, y, powers, all);
  if (smooth || is_polynomial) return;
  if (powers.size() == 1 && !is_whole(powers[0].exponent)) add_pair(x, y, powers[0], all);
  add_sum(x, y, powers, all);
}

}  // namespace loadpath::motion
