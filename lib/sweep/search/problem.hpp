// A search: the inputs of a function to be chosen, the output to be minimised or maximised, and the constraints.
#pragma once

#include "lib/sweep/function.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace loadpath::sweep {

/// One input of the function. A place is the position in its range: a share from 0 to 1, or the number of the value.
struct Variable {
  double from = 0.0, to = 0.0;  // continuous; both belong to it
  std::vector<double> values;   // a stock, in order of size; not empty: discrete
  bool ordered = true;          // false: words, of which each is a neighbour of each

  [[nodiscard]] bool is_discrete() const { return !values.empty(); }
  [[nodiscard]] double at(double place) const;
};

/// An output that decides whether a point is feasible. NaN and infinity are not.
struct Constraint {
  enum class Kind {
    at_most_one,  // a utilisation, over its bound
    is_one        // a flag, 1 where it passes
  };
  static constexpr std::size_t itself = static_cast<std::size_t>(-1);
  std::size_t output = 0;
  Kind kind = Kind::at_most_one;
  std::size_t decided_by = itself;  // the constraint that decides if this one has no value
  double bound = 1.0;               // above zero: of a utilisation
};

/// The variables are the inputs of the function, in their order.
struct Problem {
  Function& function;
  std::vector<Variable> variables;
  std::size_t objective = 0;  // an output
  bool maximise = false;
  std::vector<Constraint> constraints;
};

/// A place of each variable.
using Places = std::vector<double>;

/// The rank of a point in a search.
struct PointRank {
  int missing = 0;         // constraints, and the objective, that are not finite
  double violation = 0.0;  // the sum by which utilisations exceed 1, and 1 for each flag that does not pass
  double objective = 0.0;  // less is better, whether it is minimised or maximised

  [[nodiscard]] bool allowed() const { return missing == 0 && violation == 0.0; }
};

/// Whether a is better than b: feasible points by objective; before that by missing values, then by violation.
[[nodiscard]] bool better(const PointRank& a, const PointRank& b);

/// The rank of a point with these outputs.
[[nodiscard]] PointRank judge(const Problem& problem, std::span<const double> outputs);

/// By how much a value of this output breaks it; 0 if it does not, infinity where the value is not finite.
[[nodiscard]] double excess(const Constraint& constraint, double value);

/// The same of one constraint of a problem.
[[nodiscard]] double excess(const Problem& problem, const Constraint& constraint, std::span<const double> outputs);

/// The number of the constraint that is broken most: one that is not finite before utilisations, flags last; none: the
/// number of constraints.
[[nodiscard]] std::size_t worst_broken(const Problem& problem, std::span<const double> outputs);

/// The number of combinations of the discrete variables, at most `most` + 1.
[[nodiscard]] std::uint64_t combinations(const std::vector<Variable>& variables, std::uint64_t most);

}  // namespace loadpath::sweep
