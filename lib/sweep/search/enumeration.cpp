#include "lib/sweep/search/enumeration.hpp"

#include <algorithm>
#include <limits>

namespace loadpath::sweep {

void set_combination(const std::vector<Variable>& variables, std::uint64_t index, Places& at) {
  for (std::size_t i = variables.size(); i-- > 0;) {
    if (!variables[i].is_discrete()) continue;
    at[i] = static_cast<double>(index % variables[i].values.size());
    index /= variables[i].values.size();
  }
}

Trial best_of_all(Trials& trials) {
  constexpr std::uint64_t block = 1024;
  const auto& variables = trials.problem().variables;
  const std::uint64_t count = combinations(variables, std::numeric_limits<std::uint64_t>::max() - 1);
  std::vector<Trial> some(block, {Places(variables.size()), {}});
  Trial best;
  for (std::uint64_t first = 0; first < count; first += block) {
    const auto here = std::span(some).first(std::min(block, count - first));
    for (std::size_t k = 0; k < here.size(); ++k) set_combination(variables, first + k, here[k].at);
    trials.judge(here);
    for (const Trial& trial : here) {
      if (best.at.empty() || better(trial.standing, best.standing)) best = trial;
    }
  }
  return best;
}

}  // namespace loadpath::sweep
