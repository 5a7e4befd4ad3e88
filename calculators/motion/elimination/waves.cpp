#include "calculators/motion/elimination/candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

namespace loadpath::motion {

namespace {

using Polynomial = std::vector<double>;  // of u = cos psi, from the constant on

constexpr std::size_t most_multiples = 8;

/// b cos n psi + c sin n psi for each n from 1.
struct Multiples {
  std::array<double, most_multiples + 1> b{}, c{};
};

/// The one wave of a coordinate as A cos psi with psi = theta - delta; nothing if it is none.
struct Wave {
  Powers theta;
  double A = 0.0, delta = 0.0;
};

std::optional<Wave> single_wave(const Sum& sum) {
  if (sum.terms.empty() || sum.terms.size() > 2 || !sum.terms[0].is_wave()) return std::nullopt;
  const Term& first = sum.terms[0];
  const Term cosine{Term::Kind::cosine, first.argument, 1.0}, sine{Term::Kind::sine, first.argument, 1.0};
  const double p = coefficient_of(sum, cosine), q = coefficient_of(sum, sine);
  if (sum.terms.size() == 2 && (p == 0.0 || q == 0.0)) return std::nullopt;
  return Wave{first.argument, std::hypot(p, q), std::atan2(q, p)};
}

std::optional<Multiples> multiples_of(const Sum& sum, const Wave& wave) {
  Multiples all;
  double largest = 0.0;
  for (const Term& term : sum.terms) {
    const auto ratio = term.is_wave() ? ratio_of(term.argument, wave.theta) : std::nullopt;
    if (!ratio || std::abs(*ratio - std::round(*ratio)) > 1e-10 || *ratio > most_multiples) return std::nullopt;
    const auto n = static_cast<std::size_t>(std::lround(*ratio));
    if (n == 0) return std::nullopt;
    const double phase = static_cast<double>(n) * wave.delta, cosine = std::cos(phase), sine = std::sin(phase);
    const bool is_cosine = term.kind == Term::Kind::cosine;
    all.b[n] += term.coefficient * (is_cosine ? cosine : sine);
    all.c[n] += term.coefficient * (is_cosine ? -sine : cosine);
    largest = std::max(largest, std::abs(term.coefficient));
  }
  for (auto* const series : {&all.b, &all.c}) {
    for (double& coefficient : *series) {
      if (std::abs(coefficient) <= 1e-13 * largest) coefficient = 0.0;
    }
  }
  return all;
}

void add_scaled(Polynomial& sum, const Polynomial& added, double factor) {
  if (sum.size() < added.size()) sum.resize(added.size());
  for (std::size_t k = 0; k < added.size(); ++k) sum[k] += factor * added[k];
}

/// 2 u p_1 - p_0: the recurrence of both Chebyshev polynomials.
Polynomial next_of(const Polynomial& p_1, const Polynomial& p_0) {
  Polynomial next(p_1.size() + 1);
  for (std::size_t k = 0; k < p_1.size(); ++k) next[k + 1] = 2.0 * p_1[k];
  add_scaled(next, p_0, -1.0);
  return next;
}

/// y = P(u) + Q(u) sin psi.
struct InCosine {
  Polynomial P, Q;
};

InCosine in_cosine(const Multiples& multiples, double constant) {
  InCosine all{{constant}, {0.0}};
  Polynomial T_0{1.0}, T_1{0.0, 1.0}, U_0{0.0}, U_1{1.0};
  for (std::size_t n = 1; n <= most_multiples; ++n) {
    if (multiples.b[n] != 0.0) add_scaled(all.P, T_1, multiples.b[n]);
    if (multiples.c[n] != 0.0) add_scaled(all.Q, U_1, multiples.c[n]);
    T_0 = next_of(T_1, T_0);
    U_0 = next_of(U_1, U_0);
    std::swap(T_0, T_1);
    std::swap(U_0, U_1);
  }
  return all;
}

/// The polynomial of u as one of A u.
Polynomial stretched(Polynomial p, double A) {
  double power = 1.0;
  for (double& coefficient : p) {
    coefficient /= power;
    power *= A;
  }
  return p;
}

PathForm form_of_degree_in_cosine(std::size_t degree) { return degree == 2 ? PathForm::parabola : PathForm::other; }

}  // namespace

void add_multiple_waves(const SummedCoordinate& x, const SummedCoordinate& y, std::vector<CurveEquation>& all) {
  const auto wave = single_wave(x.sum);
  if (!wave || y.sum.terms.empty()) return;
  const auto multiples = multiples_of(y.sum, *wave);
  if (!multiples) return;
  const InCosine of_u = in_cosine(*multiples, y.sum.constant);
  const double origin = x.sum.constant;
  const Polynomial P = stretched(of_u.P, wave->A);
  Polynomial Q = stretched(of_u.Q, wave->A);
  const std::string right = polynomial_text(P, x.name, origin, x.size);
  if (std::ranges::all_of(Q, [](double c) { return c == 0.0; })) {
    all.push_back({std::string(y.name) + " = " + right, form_of_degree_in_cosine(P.size() - 1)});
    return;
  }
  if (Q.back() < 0.0) std::ranges::transform(Q, Q.begin(), std::negate<>{});  // only its square counts
  const std::string left =
      P.size() == 1 ? shifted_text(y.name, y.sum.constant) : "(" + std::string(y.name) + " - (" + right + "))";
  const std::string u = divided_text(shifted_text(x.name, origin), wave->A);
  const std::string factor = "(" + polynomial_text(Q, x.name, origin, x.size) + ")";
  all.push_back(
      {power_text(left, 2.0) + " = " + power_text(factor, 2.0) + "*(1 - " + power_text(u, 2.0) + ")", PathForm::other});
}

}  // namespace loadpath::motion
