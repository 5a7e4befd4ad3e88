#include "lib/project/run/search/evaluated_rows.hpp"

#include "lib/account/rows.hpp"

#include <cmath>
#include <limits>

namespace loadpath::project {

namespace {

bool judges(const FieldInfo& f) { return f.role == Role::check || f.role == Role::limit; }

void visit_list(void* result, const FieldInfo& list, const Passing& passing, const EvaluatedRows::Visit& visit) {
  for (std::size_t k = 0; k < list.size(result); ++k) {
    for (const FieldInfo& f : list.fields) {
      if (judges(f) && passing.counts({&f, k})) visit(list, {&f, k}, f.get(list.element(result, k)));
    }
  }
}

}  // namespace

EvaluatedRows::EvaluatedRows(Evaluation& evaluation, const Passing& passing, const Visit& visit) {
  const auto& fields = evaluation.calculator().result->fields;
  for (const FieldInfo& f : fields) {
    if (judges(f) && passing.counts({&f})) columns_[&f].signature = {f.dimension, evaluation.axis()};
  }
  for (std::size_t i = 0; i < evaluation.positions(); ++i) {
    is_available_.push_back(evaluation.evaluate_at(i));
    void* const result = evaluation.result().data.get();
    for (auto& [field, column] : columns_)
      column.si.push_back(is_available_[i] ? field->get(result) : std::numeric_limits<double>::quiet_NaN());
    if (!is_available_[i] || !visit) continue;
    for (const FieldInfo& list : fields) {
      if (list.type == FieldInfo::Type::list) visit_list(result, list, passing, visit);
    }
  }
}

double EvaluatedRows::largest(const FieldInfo& check) const {
  const Value& column = columns_.at(&check);
  return column.is_series() ? maximum(column).value : column.si[0];
}

std::optional<double> EvaluatedRows::first_outside(const FieldInfo& limit) const {
  const Value& column = columns_.at(&limit);
  for (std::size_t i = 0; i < column.si.size(); ++i) {
    if (is_available_[i] && !account::is_kept(limit, column.si[i])) return column.si[i];
  }
  return std::nullopt;
}

}  // namespace loadpath::project
