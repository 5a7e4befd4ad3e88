// The candidates of a search, from small to large: sizes of a stock, rows of a table, or their kinds.
#pragma once

#include "lib/project/run/evaluation/evaluation.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath::project {

struct Candidates {
  const Search& wanted;
  Leaf leaf;  // without field: rows, or kinds of them
  std::vector<double> sizes;
  std::vector<std::string> rows;
  Leaf chosen = {};  // the name that is one of the kinds; without field: rows or sizes
  [[nodiscard]] std::size_t count() const { return leaf ? sizes.size() : rows.size(); }
  [[nodiscard]] Message name(std::size_t i) const;
  /// The stock or the table: "R40", "key".
  [[nodiscard]] const std::string& source() const;
  /// Makes one the value of the input, or the row of the step.
  void take(Inputs& inputs, std::size_t i) const;
  /// Drops sizes that are smaller than the other steps of the body need, or other than the one that they give.
  void keep_to_body(const BodySize& body);
  /// The input that was searched for, and what a row would have given, have no value. `tried`: the nearest ones.
  void leave_open(Inputs& inputs, Message why, std::vector<account::TriedSize> tried = {}) const;
};
/// A row that was found together with that of another step; empty: none passes.
struct JointRow {
  std::string row;
  std::string with;  // that step
};

Candidates candidates_of(const Evaluation& evaluation, const Search& wanted);

}  // namespace loadpath::project
