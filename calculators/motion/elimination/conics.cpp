#include "calculators/motion/elimination/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace loadpath::motion {

namespace {

using Kind = Term::Kind;

constexpr double conic_rounding = 1e-12;

/// A X^2 + B X Y + C Y^2 + D X + E Y + F = 0.
struct Conic {
  double A = 0.0, B = 0.0, C = 0.0, D = 0.0, E = 0.0, F = 0.0;
};

/// f = p X + q Y, of X and Y from the constants of the coordinates.
struct Linear {
  double p = 0.0, q = 0.0;
};

std::vector<Term> functions_of(const Sum& x, const Sum& y) {
  std::vector<Term> functions = x.terms;
  for (const Term& term : y.terms) {
    if (coefficient_of(x, term) == 0.0) functions.push_back(term);
  }
  return functions;
}

/// The exponent of g as a power of f, both powers of the time or exponentials of one argument.
std::optional<double> exponent_between(const Term& g, const Term& f) {
  if (g.kind != f.kind || f.is_wave()) return std::nullopt;
  if (f.kind == Kind::power) return g.argument[0].exponent / f.argument[0].exponent;
  return ratio_of(g.argument, f.argument);
}

bool is_near(double a, double b) { return std::abs(a - b) <= 1e-10 * std::max(std::abs(a), std::abs(b)); }

std::string squared_over(const std::string& coordinate, double half_axis) {
  return power_text(divided_text(coordinate, half_axis), 2.0);
}

/// A X^2 + B X Y + C Y^2 = 1.
CurveEquation central(const Conic& c, const std::string& X, const std::string& Y, PathForm form) {
  if (c.A == 0.0 && c.C == 0.0) return {X + "*" + Y + " = " + number_text(1.0 / c.B), form};
  if (c.B != 0.0 || c.A == 0.0 || c.C == 0.0) {
    SumText sum;
    sum.add(c.A, power_text(X, 2.0)).add(c.B, X + "*" + Y).add(c.C, power_text(Y, 2.0));
    return {sum.text() + " = 1", form};
  }
  if (is_near(c.A, c.C))
    return {power_text(X, 2.0) + " + " + power_text(Y, 2.0) + " = " + number_text(2.0 / (c.A + c.C)), PathForm::circle};
  const std::string first = squared_over(X, 1.0 / std::sqrt(std::abs(c.A)));
  const std::string second = squared_over(Y, 1.0 / std::sqrt(std::abs(c.C)));
  if (c.A > 0.0) return {first + (c.C > 0.0 ? " + " : " - ") + second + " = 1", form};
  return {second + " - " + first + " = 1", form};
}

/// The parabola multiplied out, with the first of its squares.
CurveEquation expanded(Conic c, const SummedCoordinate& x, const SummedCoordinate& y) {
  const double a = x.sum.constant, b = y.sum.constant;
  c.F += c.A * a * a + c.B * a * b + c.C * b * b - c.D * a - c.E * b;
  c.D -= 2.0 * c.A * a + c.B * b;
  c.E -= 2.0 * c.C * b + c.B * a;
  const double lead = c.A != 0.0 ? c.A : c.C;
  const double largest = std::max({std::abs(c.A) * x.size * x.size, std::abs(c.C) * y.size * y.size,
                                   std::abs(c.D) * x.size, std::abs(c.E) * y.size, std::abs(c.F)});
  const auto kept = [&](double coefficient, double reach) {
    return std::abs(coefficient) * reach <= conic_rounding * largest ? 0.0 : coefficient / lead;
  };
  const std::string X(x.name), Y(y.name);
  SumText sum;
  sum.add(c.A / lead, X + "^2").add(c.B / lead, X + "*" + Y).add(c.C / lead, Y + "^2");
  sum.add(kept(c.D, x.size), X).add(kept(c.E, y.size), Y).add(kept(c.F, 1.0), "");
  return {sum.text() + " = 0", PathForm::parabola};
}

/// Squares that are rounding of the two linear forms.
void drop_small_squares(Conic& c, double reach_X, double reach_Y) {
  const double A = std::abs(c.A) * reach_X * reach_X, C = std::abs(c.C) * reach_Y * reach_Y;
  const double B = std::abs(c.B) * reach_X * reach_Y, least = conic_rounding * std::max({A, B, C});
  if (A <= least) c.A = 0.0;
  if (B <= least) c.B = 0.0;
  if (C <= least) c.C = 0.0;
}

double reach_of(const Sum& sum, const Term& f, const Term& g) {
  return std::abs(coefficient_of(sum, f)) + std::abs(coefficient_of(sum, g));
}

Conic product_of(const Linear& f, const Linear& g) { return {f.p * g.p, f.p * g.q + f.q * g.p, f.q * g.q}; }

}  // namespace

void add_lines(const SummedCoordinate& x, const SummedCoordinate& y, std::vector<CurveEquation>& all) {
  for (const SummedCoordinate* const one : {&x, &y}) {
    if (!one->sum.terms.empty()) continue;
    all.push_back({std::string(one->name) + " = " + number_text(one->sum.constant), PathForm::line});
    return;
  }
  const Term& lead = x.sum.terms[0];
  const double slope = coefficient_of(y.sum, lead) / lead.coefficient;
  const bool is_line = std::ranges::all_of(functions_of(x.sum, y.sum), [&](const Term& f) {
    const double along = slope * coefficient_of(x.sum, f), across = coefficient_of(y.sum, f);
    return std::abs(along - across) <= conic_rounding * std::max(std::abs(along), std::abs(across));
  });
  if (!is_line) return;
  const std::string right = polynomial_text({y.sum.constant, slope}, x.name, x.sum.constant, x.size);
  all.push_back({std::string(y.name) + " = " + right, PathForm::line});
}

void add_conics(const SummedCoordinate& x, const SummedCoordinate& y, std::vector<CurveEquation>& all) {
  std::vector<Term> functions = functions_of(x.sum, y.sum);
  if (functions.size() != 2) return;
  Term f = functions[0], g = functions[1];
  auto exponent = exponent_between(g, f);
  if (exponent && is_near(*exponent, 0.5)) {
    std::swap(f, g);
    exponent = 2.0;
  }
  const double x_f = coefficient_of(x.sum, f), x_g = coefficient_of(x.sum, g);
  const double y_f = coefficient_of(y.sum, f), y_g = coefficient_of(y.sum, g);
  const double determinant = x_f * y_g - x_g * y_f;
  if (std::abs(determinant) <= conic_rounding * (std::abs(x_f * y_g) + std::abs(x_g * y_f))) return;
  const Linear of_f{y_g / determinant, -x_g / determinant}, of_g{-y_f / determinant, x_f / determinant};
  const std::string X = shifted_text(x.name, x.sum.constant), Y = shifted_text(y.name, y.sum.constant);
  const double reach_X = reach_of(x.sum, f, g), reach_Y = reach_of(y.sum, f, g);
  if (f.is_wave() && g.is_wave() && f.kind != g.kind && ratio_of(f.argument, g.argument) &&
      is_near(*ratio_of(f.argument, g.argument), 1.0)) {
    Conic c = product_of(of_f, of_f);
    const Conic other = product_of(of_g, of_g);
    c.A += other.A, c.B += other.B, c.C += other.C;
    drop_small_squares(c, reach_X, reach_Y);
    all.push_back(central(c, X, Y, PathForm::ellipse));
  } else if (exponent && is_near(*exponent, -1.0)) {
    Conic c = product_of(of_f, of_g);
    drop_small_squares(c, reach_X, reach_Y);
    all.push_back(central(c, X, Y, PathForm::hyperbola));
  } else if (exponent && is_near(*exponent, 2.0)) {
    Conic c = product_of(of_f, of_f);
    drop_small_squares(c, reach_X, reach_Y);
    c.D = -of_g.p, c.E = -of_g.q;
    all.push_back(expanded(c, x, y));
  }
}

}  // namespace loadpath::motion
