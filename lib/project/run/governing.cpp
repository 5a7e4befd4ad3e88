#include "lib/project/run/governing.hpp"

#include "lib/numerics/magnitude.hpp"

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

}  // namespace

Governing evaluate_governing(Evaluation& evaluation, const Results& results, bool in_words) {
  Governing governing{.position = position_of_largest_check(evaluation, results), .is_evaluated = false, .trace = {}};
  if (results.series.empty() || !evaluation.set_position(governing.position)) return governing;
  governing.is_evaluated = true;
  const Calculator& calculator = evaluation.calculator();
  if (in_words)
    calculator.explain(evaluation.record().data.get(), evaluation.result().data.get(), governing.trace);
  else if (evaluation.positions() > 1)
    evaluation.evaluate_record();
  return governing;
}

}  // namespace loadpath::project
