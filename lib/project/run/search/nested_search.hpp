// The search for several inputs of one step that no calculator sizes together: a diameter, the key in it, its length.
// In the order in which the calculator lists them each is the smallest with which the rest can pass; of a calculator
// that gives an amount, an area or a volume, together they are those of the least amount.
#pragma once

#include "lib/project/run/search/candidates.hpp"
#include "lib/project/run/search/passing.hpp"

#include <cstddef>
#include <vector>

namespace loadpath::project {

class NestedSearch {
 public:
  /// `in_words`: the result explains why it is not smaller.
  NestedSearch(Evaluation& evaluation, bool in_words);
  void run(std::vector<Issue>& issues);

 private:
  /// The index of a candidate for each search.
  using Choice = std::vector<std::size_t>;

  void take(const Choice& choice);
  bool keeps_rules_with(const Choice& choice);
  /// The first that passes, from the first candidates on.
  bool find(Choice& choice);
  /// The one of least amount that passes.
  bool find_least(Choice& choice);
  /// The one that is nearest to passing; false where none keeps the rules.
  bool find_nearest(Choice& choice);
  /// The next choice, the last search fastest; false behind the last.
  [[nodiscard]] bool advance(Choice& choice) const;
  void report(const Choice& found);
  void leave_open();
  [[nodiscard]] Message name(const Choice& choice) const;

  Evaluation& evaluation_;
  bool in_words_;
  std::vector<Candidates> all_;
  Passing passing_;
};

}  // namespace loadpath::project
