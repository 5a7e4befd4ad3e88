#include "lib/project/sweep/studies/influence.hpp"

#include "lib/project/sweep/plan.hpp"
#include "lib/project/sweep/ranges.hpp"
#include "lib/project/sweep/slice.hpp"

namespace loadpath::project {

std::optional<Influence> find_influence(const Searching& searching, const SweepPlan& plan,
                                        const SweepSettings& settings, std::uint64_t sobol_rows,
                                        std::vector<Issue>& issues) {
  const auto refuse = [&](Message message, Message hint) {
    issues.push_back({{}, "", std::move(message), std::move(hint), Severity::error});
    return std::nullopt;
  };
  if (plan.columns.empty()) return refuse(say("no result given"), say("name one: --results shaft.u_tau"));
  std::vector<std::string> texts;
  for (const SweptResult& column : plan.columns) texts.push_back(column.name + " = " + column.text);
  Variants variants(searching.read(), texts);
  sweep::Threaded threaded = in_threads(variants, searching, texts);
  const std::vector<double> middles = middles_of(variants.axes());
  Influence influence;
  std::vector<std::size_t> numbers, scattering;
  for (std::size_t i = 0; i < variants.axes().size(); ++i) {
    const SweptInput& input = variants.axes()[i];
    if (!input.words.empty() || (!input.distribution && input.axis.size() < 2)) continue;
    if (input.distribution) {
      influence.scattering.push_back(influence.inputs.size());
      scattering.push_back(i);
    }
    numbers.push_back(i);
    influence.inputs.push_back(input);
  }
  if (numbers.empty()) return refuse(say("no numeric input varies"), say("make one a range, or uncertain"));
  for (const SweptResult& column : plan.columns) {
    influence.names.push_back(column.name);
    influence.units.push_back(column.unit);
  }
  std::vector<double> steps, sd;
  for (const SweptInput& input : influence.inputs) {
    influence.low.push_back(low_of(input));
    influence.high.push_back(high_of(input));
    steps.push_back((influence.high.back() - influence.low.back()) / 100.0);
    sd.push_back(sd_of(input));
  }
  Slice all(threaded, middles, numbers, plan.columns.size());
  const std::vector<double> base = middles_of(influence.inputs);
  influence.tornados = sweep::tornado(all, base, influence.low, influence.high);
  influence.slopes = sweep::slopes(all, base, steps);
  if (scattering.empty()) return influence;
  const bool correlated = !settings.correlations.empty();
  if (correlated && sobol_rows > 0)
    return refuse(
        say("Sobol indices assume independent inputs, and these are correlated"),
        say("omit --sobol: the budget of the scatter takes the correlations into account; or omit correlations"));
  const std::vector<double> correlation =
      correlated ? correlation_matrix(variants.axes(), numbers, settings.correlations) : std::vector<double>{};
  for (std::size_t k = 0; k < plan.columns.size(); ++k)
    influence.budgets.push_back(sweep::variance_budget(influence.slopes, k, sd, correlation));
  if (sobol_rows == 0) return influence;
  Slice uncertain(threaded, middles, scattering, plan.columns.size());
  influence.sobol = sweep::sobol_indices(uncertain, sampler_of(variants.axes(), scattering, settings.seed), sobol_rows);
  return influence;
}

}  // namespace loadpath::project
