// The checks and limits of a candidate, from one evaluation at each position.
#pragma once

#include "lib/project/run/search/passing.hpp"

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace loadpath::project {

class EvaluatedRows {
 public:
  /// A row of an element of a list that counts; what the evaluation holds belongs to it.
  using Visit = std::function<void(const FieldInfo& list, const Row& row, double si)>;

  EvaluatedRows(Evaluation& evaluation, const Passing& passing, const Visit& visit = {});

  /// As Evaluation::largest_result, of a check or limit of the part that counts.
  [[nodiscard]] double largest(const FieldInfo& check) const;
  /// As Passing::first_outside.
  [[nodiscard]] std::optional<double> first_outside(const FieldInfo& limit) const;

 private:
  std::map<const FieldInfo*, Value> columns_;
  std::vector<bool> is_available_;  // at each position
};

}  // namespace loadpath::project
