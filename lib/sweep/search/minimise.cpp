#include "lib/sweep/search/minimise.hpp"

#include "lib/sweep/search/enumeration.hpp"
#include "lib/sweep/search/proof.hpp"

#include <algorithm>
#include <cassert>

namespace loadpath::sweep {

namespace {

bool is_finite_set(const Problem& problem, const Effort& effort) {
  const auto& variables = problem.variables;
  const std::uint64_t most = std::min(effort.enumerated, effort.budget);
  return std::all_of(variables.begin(), variables.end(), [](const Variable& v) { return v.is_discrete(); }) &&
         combinations(variables, most) <= most;
}

Trial best_in(const std::vector<Trial>& trials) {
  return *std::min_element(trials.begin(), trials.end(),
                           [](const Trial& a, const Trial& b) { return better(a.standing, b.standing); });
}

/// Continues from better neighbours, until none is or the budget is spent.
Proof proven(Trials& trials, MixedSearch& search, Trial& best, double step) {
  for (;;) {
    Proof proof = proof_of(trials, search, best, step);
    if (proof.better.empty() || trials.left() == 0) return proof;
    best = search.climb(search.settled(best_in(proof.better)));
  }
}

}  // namespace

Optimum minimise(const Problem& problem, const Effort& effort) {
  assert(problem.variables.size() == problem.function.inputs());
  Optimum found;
  Trials trials(problem, effort.budget);
  MixedSearch search(trials);
  const bool finite = is_finite_set(problem, effort);
  Trial best = finite ? best_of_all(trials) : search.run(effort.starts);
  Proof proof = finite ? proof_of(trials, search, best, effort.step) : proven(trials, search, best, effort.step);
  for (std::size_t i = 0; i < best.at.size(); ++i) found.point.push_back(problem.variables[i].at(best.at[i]));
  found.outputs = trials.outputs({&best.at, 1});
  found.allowed = best.standing.allowed();
  found.worst = worst_broken(problem, found.outputs);
  found.scope = finite                           ? Optimum::Scope::every_point
                : search.saw_every_combination() ? Optimum::Scope::every_combination
                                                 : Optimum::Scope::local;
  found.budget_spent = !finite && trials.left() == 0;
  found.candidates = finite ? combinations(problem.variables, effort.enumerated) : 0;
  found.evaluations = trials.count();
  found.neighbours = std::move(proof.neighbours);
  return found;
}

}  // namespace loadpath::sweep
