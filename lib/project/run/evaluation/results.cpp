#include "lib/project/run/evaluation/results.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace loadpath::project {

namespace {

constexpr double unset_number = std::numeric_limits<double>::quiet_NaN();

/// Every leaf in the order of for_each_leaf, without making paths.
template <class Visit>
void walk(std::span<const FieldInfo> fields, void* data, const Visit& visit) {
  for (const FieldInfo& field : fields) {
    if (field.is_leaf()) visit(field, data);
    if (!field.has_fields()) continue;
    for (std::size_t i = 0; i < field.size(data); ++i) walk(field.fields, field.element(data, i), visit);
  }
}

/// The number of elements of each list, in the order of traversal.
std::vector<std::size_t> list_sizes(std::span<const FieldInfo> fields, void* data) {
  std::vector<std::size_t> sizes;
  for (const FieldInfo& field : fields) {
    if (field.type == FieldInfo::Type::list) sizes.push_back(field.size(data));
  }
  return sizes;
}

/// Adds series for the leaves of the result as it is now; those that are known keep their values. Which of the series
/// each leaf has, in the order of a walk.
std::vector<std::size_t> add_series(const Evaluation& evaluation, std::vector<ResultSeries>& all) {
  std::vector<std::size_t> order;
  for_each_leaf(evaluation.result(), [&](const std::string& path, const Leaf& leaf) {
    if (leaf.field->get == nullptr) return;
    const auto known = std::find_if(all.begin(), all.end(), [&](const ResultSeries& s) { return s.path == path; });
    order.push_back(static_cast<std::size_t>(known - all.begin()));
    if (known != all.end()) return;
    Value open{{leaf.field->dimension, evaluation.axis()}, std::vector<double>(evaluation.positions(), unset_number)};
    all.push_back({path, leaf.field, std::move(open)});
  });
  return order;
}

/// Applicability of each mode at a position; if the part is unknown, every mode may apply.
void add_applies(const Evaluation& evaluation, bool is_available, std::vector<Applies>& applies) {
  const Calculator& calculator = evaluation.calculator();
  for (std::size_t k = 0; k < applies.size(); ++k) {
    const auto here = is_available ? calculator.applies(k, evaluation.record().data.get()) : Applies::unseen;
    applies[k] = std::max(applies[k], here);
  }
}

}  // namespace

Results evaluate_all(Evaluation& evaluation, bool in_words) {
  const auto& fields = evaluation.calculator().result->fields;
  Results results{{}, std::vector<Applies>(evaluation.calculator().modes.size(), Applies::no)};
  std::vector<std::size_t> order, shape;  // order and shape of the result with these series
  evaluation.settle_sizes();
  for (std::size_t i = 0; i < evaluation.positions(); ++i) {
    const bool is_available = evaluation.set_position(i);
    add_applies(evaluation, is_available, results.applies);
    if (!is_available) continue;
    if (in_words && evaluation.positions() == 1)
      evaluation.explain_record(results.trace.emplace());
    else
      evaluation.evaluate_at(i);
    void* const result = evaluation.result().data.get();
    std::vector<std::size_t> here = list_sizes(fields, result);
    if (results.series.empty() || here != shape) {
      order = add_series(evaluation, results.series);
      shape = std::move(here);
    }
    std::size_t leaf = 0;
    walk(fields, result, [&](const FieldInfo& field, const void* owner) {
      if (field.get == nullptr) return;
      const double si = field.get(owner);  // values beyond the range of numbers are not available
      results.series[order[leaf++]].value.si[i] = std::isinf(si) && !field.infinite ? unset_number : si;
    });
  }
  return results;
}

bool is_reported(const Evaluation& evaluation, const ResultSeries& series) {
  if (!evaluation.is_asked(*series.field)) return false;
  const std::vector<double>& si = series.value.si;
  return !series.field->where_set || std::any_of(si.begin(), si.end(), [](double x) { return !std::isnan(x); });
}

}  // namespace loadpath::project
