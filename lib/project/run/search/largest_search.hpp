// The search for the largest value of a load, a length, a speed with which a step passes.
#pragma once

#include "lib/project/run/search/passing.hpp"

#include <vector>

namespace loadpath::project {

class LargestSearch {
 public:
  LargestSearch(Evaluation& evaluation, const Search& wanted)
      : evaluation_(evaluation), wanted_(wanted), leaf_(evaluation.inputs().leaf(wanted.path)), passing_(evaluation) {}
  /// `in_words`: warns of customs that the result violates.
  void run(bool in_words, std::vector<Issue>& issues);

 private:
  bool passes_with(double value);
  bool excuse_unmoved(double most);
  void keep(double largest);
  /// Reports that not even `value` passes.
  void report_none(double value, std::vector<Issue>& issues);

  Evaluation& evaluation_;
  const Search& wanted_;
  Leaf leaf_;
  Passing passing_;
};

}  // namespace loadpath::project
