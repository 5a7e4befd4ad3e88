#include "lib/sweep/search/proof.hpp"

#include "lib/sweep/search/neighbours.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::sweep {

namespace {

/// Better by more than rounding and the tolerance of descents.
bool clearly_better(const PointRank& a, const PointRank& b) {
  constexpr double least = 1e-9;
  if (!better(a, b)) return false;
  if (a.missing != b.missing) return true;
  if (a.violation != b.violation) return b.violation - a.violation > least;
  return b.objective - a.objective > least * std::abs(b.objective);
}

std::vector<double> values_at(const std::vector<Variable>& variables, const Places& at) {
  std::vector<double> values(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) values[i] = variables[i].at(at[i]);
  return values;
}

std::vector<Places> moved(const std::vector<Variable>& variables, const Places& at, double step) {
  auto all = neighbours_of(variables, at, 1);
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (const double by : {-step, step}) {
      const double place = std::clamp(at[i] + by, 0.0, 1.0);
      if (variables[i].is_discrete() || place == at[i] || variables[i].from == variables[i].to) continue;
      all.push_back(at);
      all.back()[i] = place;
    }
  }
  return all;
}

class Prover {
 public:
  Prover(Trials& at_work, const Trial& point) : trials(at_work), best(point) {}

  /// The neighbour of which variable i is another.
  void add(const Places& at, std::size_t i, bool resized) {
    const Problem& problem = trials.problem();
    Neighbour next;
    next.variable = i, next.up = at[i] > best.at[i], next.resized = resized;
    next.point = values_at(problem.variables, at);
    next.outputs = trials.outputs({&at, 1});
    next.broken = worst_broken(problem, next.outputs);
    const PointRank standing = judge(problem, next.outputs);
    next.outcome = standing.allowed() ? Neighbour::Outcome::no_better : Neighbour::Outcome::breaks;
    if (clearly_better(standing, best.standing)) {
      next.outcome = Neighbour::Outcome::better;
      proof.better.push_back({at, standing});
    }
    proof.neighbours.push_back(std::move(next));
  }
  Proof proof;

 private:
  Trials& trials;
  const Trial& best;
};

std::size_t changed(const Places& a, const Places& b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin()).first - a.begin());
}

}  // namespace

Proof proof_of(Trials& trials, MixedSearch& search, const Trial& best, double step) {
  const auto& variables = trials.problem().variables;
  const bool has_continuous =
      std::any_of(variables.begin(), variables.end(), [](const Variable& variable) { return !variable.is_discrete(); });
  Prover prover(trials, best);
  auto around = moved(variables, best.at, step);
  std::stable_sort(around.begin(), around.end(),
                   [&](const Places& a, const Places& b) { return changed(a, best.at) < changed(b, best.at); });
  for (const Places& at : around) {
    const std::size_t i = changed(at, best.at);
    prover.add(at, i, false);
    if (variables[i].is_discrete() && has_continuous) prover.add(search.settled(trials.judged(at)).at, i, true);
  }
  return std::move(prover.proof);
}

}  // namespace loadpath::sweep
