// A law of motion as a sum of powers of the time, exponentials and waves: the form in which the time can be eliminated.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace loadpath::motion {

struct Monomial {
  double exponent = 0.0;
  double coefficient = 0.0;
};
/// A polynomial without constant, also of fractional and negative exponents; the largest exponent first.
using Powers = std::vector<Monomial>;

struct Term {
  enum class Kind { power, exponential, cosine, sine };
  Kind kind = Kind::power;
  Powers argument;  // of a power one with the coefficient 1, otherwise of the function; of a wave the first is positive
  double coefficient = 0.0;

  [[nodiscard]] bool is_wave() const { return kind == Kind::cosine || kind == Kind::sine; }
};

/// The time of a sum is t - shift.
struct Sum {
  double constant = 0.0;
  std::vector<Term> terms;
};

/// A factor k with `a` = k `b`; nothing if there is none.
std::optional<double> ratio_of(const Powers& a, const Powers& b);
/// Whether two terms are the same function of the time, apart from their coefficients.
bool is_same_function(const Term& a, const Term& b);
/// The coefficient that a sum has for the function of a term; zero if it has no such term.
double coefficient_of(const Sum& sum, const Term& function);

/// Two laws over one time, SI.
struct Laws {
  Sum first, second;
};
/// Empty if one of them is not such a sum. The time is counted from the zero of a binomial under a root or a fraction
/// line, 1/(t + 1 s). Terms that are rounding at times up to `longest` are left out.
std::optional<Laws> as_sums(std::string_view first, std::string_view second, double longest);

}  // namespace loadpath::motion
