#include "calculators/motion/elimination/terms.hpp"

#include "lib/quantity/expression/tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::motion {

namespace {

using expression::Node;
using expression::Operation;

constexpr double part_of_rounding = 1e-13;
constexpr std::size_t most_terms = 24;
constexpr double most_factors = 6.0;  // the largest exponent of a sum that is multiplied out

bool is_alike(double a, double b) { return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b)); }
bool is_integer(double x) { return std::abs(x - std::round(x)) <= 1e-12; }

void add_power(Powers& powers, const Monomial& added) {
  const auto same =
      std::ranges::find_if(powers, [&](const Monomial& p) { return is_alike(p.exponent, added.exponent); });
  if (same == powers.end()) {
    const auto smaller = std::ranges::find_if(powers, [&](const Monomial& p) { return p.exponent < added.exponent; });
    powers.insert(smaller, added);
    return;
  }
  const double before = std::abs(same->coefficient);
  same->coefficient += added.coefficient;
  if (std::abs(same->coefficient) <= part_of_rounding * before) powers.erase(same);
}

Powers scaled(Powers powers, double factor) {
  for (Monomial& p : powers) p.coefficient *= factor;
  return powers;
}

Powers total(Powers a, const Powers& b) {
  for (const Monomial& p : b) add_power(a, p);
  return a;
}

Sum constant_sum(double value) { return {value, {}}; }

/// Adds a term whose function may be a constant, or one of opposite argument.
void add_term(Sum& sum, Term term) {
  using Kind = Term::Kind;
  const bool is_constant = term.argument.empty() || (term.kind == Kind::power && term.argument[0].exponent == 0.0);
  if (is_constant) {
    if (term.kind != Kind::sine) sum.constant += term.coefficient;
    return;
  }
  if (term.is_wave() && term.argument[0].coefficient < 0.0) {
    term.argument = scaled(std::move(term.argument), -1.0);
    if (term.kind == Kind::sine) term.coefficient = -term.coefficient;
  }
  const auto same = std::ranges::find_if(sum.terms, [&](const Term& t) { return is_same_function(t, term); });
  if (same == sum.terms.end()) {
    sum.terms.push_back(std::move(term));
    return;
  }
  const double before = std::abs(same->coefficient);
  same->coefficient += term.coefficient;
  if (std::abs(same->coefficient) <= part_of_rounding * before) sum.terms.erase(same);
}

Sum added(Sum a, const Sum& b, double sign) {
  a.constant += sign * b.constant;
  for (Term term : b.terms) {
    term.coefficient *= sign;
    add_term(a, std::move(term));
  }
  return a;
}

/// Products of sines and cosines as waves of the sum and of the difference of their arguments.
void add_waves(Sum& sum, const Term& a, const Term& b) {
  using Kind = Term::Kind;
  const double half = 0.5 * a.coefficient * b.coefficient;
  const bool of_one_kind = a.kind == b.kind;
  const Kind kind = of_one_kind ? Kind::cosine : Kind::sine;
  const Term& first = a.kind == Kind::sine ? a : b;  // of a sine and a cosine the sine
  const Term& other = a.kind == Kind::sine ? b : a;
  add_term(sum, {kind, total(first.argument, other.argument), a.kind == Kind::sine && of_one_kind ? -half : half});
  add_term(sum, {kind, total(first.argument, scaled(other.argument, -1.0)), half});
}

bool add_product(Sum& sum, const Term& a, const Term& b) {
  using Kind = Term::Kind;
  if (a.is_wave() && b.is_wave()) {
    add_waves(sum, a, b);
    return true;
  }
  if (a.kind != b.kind) return false;
  const double coefficient = a.coefficient * b.coefficient;
  if (a.kind == Kind::power) {
    const double exponent = a.argument[0].exponent + b.argument[0].exponent;
    add_term(sum, {Kind::power, {{is_integer(exponent) ? std::round(exponent) : exponent, 1.0}}, coefficient});
  } else {
    add_term(sum, {Kind::exponential, total(a.argument, b.argument), coefficient});
  }
  return true;
}

std::optional<Sum> product(const Sum& a, const Sum& b) {
  Sum sum = constant_sum(a.constant * b.constant);
  for (const auto& [one, factor] : {std::pair{&a, b.constant}, std::pair{&b, a.constant}}) {
    for (Term term : one->terms) {
      term.coefficient *= factor;
      if (factor != 0.0) add_term(sum, std::move(term));
    }
  }
  for (const Term& left : a.terms) {
    for (const Term& right : b.terms) {
      if (!add_product(sum, left, right) || sum.terms.size() > most_terms) return std::nullopt;
    }
  }
  return sum;
}

/// A root of a negative factor exists where it is odd.
double raised(double factor, double exponent) {
  if (factor < 0.0 && is_alike(exponent, 1.0 / 3.0)) return std::cbrt(factor);
  return std::pow(factor, exponent);
}

/// The terms of a sum as a polynomial; nothing if others than powers are among them.
std::optional<Powers> powers_of(const Sum& sum) {
  Powers powers;
  for (const Term& term : sum.terms) {
    if (term.kind != Term::Kind::power) return std::nullopt;
    add_power(powers, {term.argument[0].exponent, term.coefficient});
  }
  return powers;
}

class SumReader {
 public:
  explicit SumReader(double shift) : shift_(shift) {}
  [[nodiscard]] std::optional<Sum> read(const Node& node);
  /// The time at which a binomial under a root or a fraction line is zero, if that prevented a sum.
  [[nodiscard]] const std::optional<double>& wanted() const { return wanted_; }

 private:
  std::optional<Sum> join(const Node& node);
  std::optional<Sum> call(const Node& node);
  std::optional<Sum> power(const Sum& base, double exponent);
  std::optional<Sum> power_of_one(const Sum& base, double exponent);

  double shift_;
  std::optional<double> wanted_;
};

std::optional<Sum> SumReader::power_of_one(const Sum& base, double exponent) {
  const Term& term = base.terms[0];
  const bool is_binomial = term.kind == Term::Kind::power && term.argument[0].exponent == 1.0;
  if (base.constant != 0.0) {
    if (is_binomial && !wanted_) wanted_ = shift_ - base.constant / term.coefficient;
    return std::nullopt;
  }
  if (term.is_wave()) return std::nullopt;
  Sum sum;
  Powers argument = term.argument;
  if (term.kind == Term::Kind::power) {
    argument[0].exponent *= exponent;
    if (is_integer(argument[0].exponent)) argument[0].exponent = std::round(argument[0].exponent);
  } else {
    argument = scaled(std::move(argument), exponent);
  }
  add_term(sum, {term.kind, std::move(argument), raised(term.coefficient, exponent)});
  return sum;
}

std::optional<Sum> SumReader::power(const Sum& base, double exponent) {
  if (base.terms.empty()) return constant_sum(raised(base.constant, exponent));
  const bool is_counted = exponent >= 0.0 && exponent <= most_factors && is_integer(exponent);
  if (!is_counted) return base.terms.size() == 1 ? power_of_one(base, exponent) : std::nullopt;
  std::optional<Sum> sum = constant_sum(1.0);
  for (int i = 0; sum && i < static_cast<int>(std::lround(exponent)); ++i) sum = product(*sum, base);
  return sum;
}

std::optional<Sum> SumReader::call(const Node& node) {
  using Kind = Term::Kind;
  if (node.kids.size() != 1) return std::nullopt;
  const std::optional<Sum> inner = read(node.kids[0]);
  if (!inner) return std::nullopt;
  const std::string_view name = node.function->name;
  if (name == "sqrt") return power(*inner, 0.5);
  if (name == "cbrt") return power(*inner, 1.0 / 3.0);
  const auto argument = powers_of(*inner);
  if (!argument) return std::nullopt;
  Sum sum;
  const double phase = inner->constant;
  if (name == "exp") {
    add_term(sum, {Kind::exponential, *argument, std::exp(phase)});
  } else if (name == "sin") {
    add_term(sum, {Kind::sine, *argument, std::cos(phase)});
    add_term(sum, {Kind::cosine, *argument, std::sin(phase)});
  } else if (name == "cos") {
    add_term(sum, {Kind::cosine, *argument, std::cos(phase)});
    add_term(sum, {Kind::sine, *argument, -std::sin(phase)});
  } else {
    return std::nullopt;
  }
  return sum;
}

std::optional<Sum> SumReader::join(const Node& node) {
  const std::optional<Sum> left = read(node.kids[0]), right = read(node.kids[1]);
  if (!left || !right) return std::nullopt;
  if (node.operation == Operation::add) return added(*left, *right, 1.0);
  if (node.operation == Operation::subtract) return added(*left, *right, -1.0);
  if (node.operation == Operation::multiply) return product(*left, *right);
  const std::optional<Sum> inverse = power(*right, -1.0);
  return inverse ? product(*left, *inverse) : std::nullopt;
}

std::optional<Sum> SumReader::read(const Node& node) {
  if (expression::is_constant(node)) return constant_sum(expression::constant(node));
  switch (node.operation) {
    case Operation::reference:
      return Sum{shift_, {{Term::Kind::power, {{1.0, 1.0}}, 1.0}}};
    case Operation::negate: {
      const std::optional<Sum> inner = read(node.kids[0]);
      return inner ? product(*inner, constant_sum(-1.0)) : std::nullopt;
    }
    case Operation::power: {
      const std::optional<Sum> base = read(node.kids[0]);
      return base ? power(*base, expression::constant(node.kids[1])) : std::nullopt;
    }
    case Operation::call:
      return call(node);
    default:
      return join(node);
  }
}

/// The largest contribution of a term up to a time; a negative power counts with its coefficient.
double weight_of(const Term& term, double longest) {
  if (term.kind != Term::Kind::power) return std::abs(term.coefficient);
  return std::abs(term.coefficient) * std::pow(longest, std::max(0.0, term.argument[0].exponent));
}

void drop_rounding(Sum& sum, double longest) {
  double largest = std::abs(sum.constant);
  for (const Term& term : sum.terms) largest = std::max(largest, weight_of(term, longest));
  const double least = part_of_rounding * largest;
  std::erase_if(sum.terms, [&](const Term& term) { return weight_of(term, longest) <= least; });
  if (std::abs(sum.constant) <= least) sum.constant = 0.0;
}

bool is_finite_sum(const Sum& sum) {
  return std::isfinite(sum.constant) &&
         std::ranges::all_of(sum.terms, [](const Term& term) { return std::isfinite(term.coefficient); });
}

}  // namespace

std::optional<double> ratio_of(const Powers& a, const Powers& b) {
  if (a.size() != b.size() || a.empty()) return std::nullopt;
  const double ratio = a[0].coefficient / b[0].coefficient;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!is_alike(a[i].exponent, b[i].exponent)) return std::nullopt;
    if (!is_alike(a[i].coefficient, ratio * b[i].coefficient)) return std::nullopt;
  }
  return ratio;
}

bool is_same_function(const Term& a, const Term& b) {
  if (a.kind != b.kind) return false;
  if (a.kind == Term::Kind::power) return is_alike(a.argument[0].exponent, b.argument[0].exponent);
  const auto ratio = ratio_of(a.argument, b.argument);
  return ratio && is_alike(*ratio, 1.0);
}

double coefficient_of(const Sum& sum, const Term& function) {
  const auto same = std::ranges::find_if(sum.terms, [&](const Term& term) { return is_same_function(term, function); });
  return same == sum.terms.end() ? 0.0 : same->coefficient;
}

std::optional<Laws> as_sums(std::string_view first, std::string_view second, double longest) {
  constexpr std::array<std::string_view, 1> time{"t"};
  const auto one = expression::parse(first, time), two = expression::parse(second, time);
  if (!one || !two) return std::nullopt;
  std::optional<double> shift = 0.0;
  for (int attempt = 0; attempt < 2 && shift; ++attempt) {
    SumReader reader(*shift);
    auto x = reader.read(one->tree.root), y = reader.read(two->tree.root);
    if (x && y) {
      if (!is_finite_sum(*x) || !is_finite_sum(*y)) return std::nullopt;
      drop_rounding(*x, longest + std::abs(*shift));
      drop_rounding(*y, longest + std::abs(*shift));
      return Laws{std::move(*x), std::move(*y)};
    }
    shift = reader.wanted();
  }
  return std::nullopt;
}

}  // namespace loadpath::motion
