// The inputs that influence a result: tornado, slopes, the budget of its scatter, Sobol indices.
#pragma once

#include "lib/project/sweep/blocks.hpp"
#include "lib/sweep/sensitivity/sobol.hpp"
#include "lib/sweep/sensitivity/tornado.hpp"
#include "lib/sweep/sensitivity/variance_budget.hpp"

#include <optional>
#include <vector>

namespace loadpath::project {

/// About the middle of all inputs; words stay at their first.
struct Influence {
  std::vector<SweptInput> inputs;         // numeric inputs
  std::vector<std::string> names, units;  // names and units of the results
  std::vector<double> low, high;          // per input, see low_of()
  std::vector<sweep::Tornado> tornados;   // per result
  sweep::Slopes slopes;
  std::vector<sweep::Budget> budgets;      // per result; none if nothing is uncertain
  std::vector<sweep::SobolIndices> sobol;  // per result, over the uncertain inputs; if rows were requested
  std::vector<std::size_t> scattering;     // the inputs, in the order of the indices
};

/// `sobol_rows`: 0: no Sobol indices. Issues if there is no result, or no numeric input.
std::optional<Influence> find_influence(const Searching& searching, const SweepPlan& plan,
                                        const SweepSettings& settings, std::uint64_t sobol_rows,
                                        std::vector<Issue>& issues);

}  // namespace loadpath::project
