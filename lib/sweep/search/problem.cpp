#include "lib/sweep/search/problem.hpp"

#include <cmath>
#include <limits>

namespace loadpath::sweep {

double Variable::at(double place) const {
  return is_discrete() ? values[static_cast<std::size_t>(place)] : std::lerp(from, to, place);
}

bool better(const PointRank& a, const PointRank& b) {
  if (a.missing != b.missing) return a.missing < b.missing;
  if (a.violation != b.violation) return a.violation < b.violation;
  return a.objective < b.objective;
}

double excess(const Constraint& constraint, double value) {
  if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
  if (constraint.kind == Constraint::Kind::is_one) return value == 1.0 ? 0.0 : 1.0;
  return value > constraint.bound ? value / constraint.bound - 1.0 : 0.0;
}

double excess(const Problem& problem, const Constraint& constraint, std::span<const double> outputs) {
  const double value = outputs[constraint.output];
  if (!std::isfinite(value) && constraint.decided_by != Constraint::itself) {
    const Constraint& other = problem.constraints[constraint.decided_by];
    if (excess(other, outputs[other.output]) == 0.0) return 0.0;
  }
  return excess(constraint, value);
}

PointRank judge(const Problem& problem, std::span<const double> outputs) {
  PointRank standing;
  for (const Constraint& constraint : problem.constraints) {
    const double by = excess(problem, constraint, outputs);
    if (std::isfinite(by)) {
      standing.violation += by;
    } else {
      ++standing.missing;
    }
  }
  const double objective = outputs[problem.objective];
  if (!std::isfinite(objective)) {
    ++standing.missing;
  } else {
    standing.objective = problem.maximise ? -objective : objective;
  }
  return standing;
}

std::size_t worst_broken(const Problem& problem, std::span<const double> outputs) {
  std::size_t worst = problem.constraints.size();
  double most = 0.0;
  bool flag = false;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const Constraint& constraint = problem.constraints[i];
    const double by = excess(problem, constraint, outputs);
    const bool is_flag = constraint.kind == Constraint::Kind::is_one && std::isfinite(by);
    if (by == 0.0 || (is_flag && most > 0.0) || (is_flag == flag && by <= most)) continue;
    worst = i, most = by, flag = is_flag;
  }
  return worst;
}

std::uint64_t combinations(const std::vector<Variable>& variables, std::uint64_t most) {
  std::uint64_t count = 1;
  for (const Variable& variable : variables) {
    if (!variable.is_discrete()) continue;
    if (variable.values.size() > most / count) return most + 1;
    count *= variable.values.size();
  }
  return count;
}

}  // namespace loadpath::sweep
