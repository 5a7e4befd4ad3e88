#include "lib/project/run/governing.hpp"

#include "lib/numerics/magnitude.hpp"

#include <utility>

namespace loadpath::project {

namespace {

std::size_t position_of_largest_check(const Evaluation& evaluation, const Results& results) {
  std::size_t best = 0;
  double most = -1.0;
  for (const ResultSeries& series : results.series) {
    if (series.field->role != Role::check || !evaluation.is_judged(*series.field)) continue;
    for (std::size_t i = 0; i < series.value.si.size(); ++i) {
      if (numerics::exceeds(series.value.si[i], most)) {
        most = series.value.si[i];
        best = i;
      }
    }
  }
  return best;
}

/// Compares the checks that are largest at other positions than the governing one.
void compare_elsewhere(Evaluation& evaluation, const std::map<std::size_t, Checks>& checks, Governing& governing) {
  for (const auto& [position, here] : checks) {
    if (position == governing.position || !evaluation.set_position(position)) continue;
    Trace trace;
    evaluation.explain_record(trace);
    add_compared(trace, evaluation, here, governing.compared);
  }
}

}  // namespace

Governing evaluate_governing(Evaluation& evaluation, Results& results, bool in_words) {
  Governing governing{.position = position_of_largest_check(evaluation, results), .is_evaluated = false, .trace = {}};
  std::map<std::size_t, Checks> checks;
  if (in_words) {
    checks = checks_by_position(evaluation, results);
    compare_elsewhere(evaluation, checks, governing);
  }
  if (results.series.empty() || !evaluation.set_position(governing.position)) return governing;
  governing.is_evaluated = true;
  if (!in_words) {
    if (evaluation.positions() > 1) evaluation.evaluate_record();
    return governing;
  }
  if (results.trace)
    governing.trace = *std::exchange(results.trace, std::nullopt);
  else
    evaluation.explain_record(governing.trace);
  add_compared(governing.trace, evaluation, checks[governing.position], governing.compared);
  return governing;
}

}  // namespace loadpath::project
