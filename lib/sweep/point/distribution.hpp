// The distribution of an uncertain input: the law with its parameters, and the value at a probability.
//
// Normal, uniform and triangular laws, the lognormal one by mean and standard deviation of the quantity itself, and
// Weibull's of three parameters. Probabilities lie inside (0, 1), where every value is finite.
#pragma once

#include "lib/text/issue.hpp"

#include <array>
#include <span>
#include <variant>

namespace loadpath::sweep {

struct Normal {
  double mean = 0.0, sd = 1.0;
};
struct Uniform {
  double min = 0.0, max = 1.0;
  bool is_design = false;  // a range that a search chooses from, not scatter
};
struct Triangular {
  double min = 0.0, mode = 0.5, max = 1.0;
};
struct Lognormal {
  double mean = 1.0, sd = 1.0;  // parameters of the quantity, not of its logarithm
};
struct Weibull {
  double scale = 1.0, shape = 1.0, location = 0.0;
};
using Law = std::variant<Normal, Uniform, Triangular, Lognormal, Weibull>;

/// The error in the parameters; empty if there is none.
Message refusal(const Law& law);

class Distribution {
 public:
  Distribution() : Distribution(Normal{}) {}
  /// For a law that is not refused.
  explicit Distribution(const Law& law);

  /// The value that is not exceeded with probability p, 0 < p < 1.
  [[nodiscard]] double quantile(double p) const;
  /// The same to the bit for each of a column; both spans may be the same column.
  void quantile(std::span<const double> p, std::span<double> x) const;

  /// The value at z of a standard normal variable, quantile(Phi(z)), |z| <= 37; valid even where p is too near to 1
  /// to be represented.
  [[nodiscard]] double of_normal(double z) const;
  void of_normal(std::span<const double> z, std::span<double> x) const;

  [[nodiscard]] double density(double x) const;
  /// The probability of values up to x.
  [[nodiscard]] double cumulative(double x) const;
  [[nodiscard]] double mean() const;
  [[nodiscard]] double sd() const;
  [[nodiscard]] const Law& law() const { return law_; }

 private:
  Law law_;
  double log_mean_ = 0.0, log_sd_ = 0.0;  // lognormal law: parameters of the logarithm
};

/// Whether it is a range that a search chooses from.
inline bool is_design(const Distribution& distribution) {
  const auto* const law = std::get_if<Uniform>(&distribution.law());
  return law != nullptr && law->is_design;
}

}  // namespace loadpath::sweep
