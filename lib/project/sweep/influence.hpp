// Which inputs a result hangs on: tornado, slopes, the budget of its scatter, Sobol indices.
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
  std::vector<SweptInput> inputs;         // that are numbers
  std::vector<std::string> names, units;  // of the results
  std::vector<double> low, high;          // of each input, see low_of()
  std::vector<sweep::Tornado> tornados;   // of each result
  sweep::Slopes slopes;
  std::vector<sweep::Budget> budgets;      // of each result; none where nothing is uncertain
  std::vector<sweep::SobolIndices> sobol;  // of each result, over what is uncertain; where rows were asked for
  std::vector<std::size_t> scattering;     // of the inputs, in the order of the indices
};

/// `sobol_rows`: 0: no Sobol indices. Issues where there is no result, or no input that is a number.
std::optional<Influence> find_influence(const ReadAgain& read, const SweepPlan& plan, const SweepSettings& settings,
                                        std::uint64_t sobol_rows, std::vector<Issue>& issues);

}  // namespace loadpath::project
