// The search for a size or a row: the first, from small to large, with which the step passes.
#pragma once

#include "lib/project/run/search/candidates.hpp"
#include "lib/project/run/search/shortfall.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath::project {

class SizeSearch {
 public:
  /// `in_words`: the result explains why it is not smaller.
  SizeSearch(Evaluation& evaluation, const Search& wanted, bool in_words, const JointRow* together);
  void run(std::vector<Issue>& issues);

 private:
  /// A size given by another step of the same body is not searched: this one is assessed at it. Returns whether that
  /// applies.
  bool takes_size_of_body();
  /// Whether the rules about the searched inputs hold with a candidate, at the sizes that follow from it.
  bool keeps_rules_with(std::size_t i);
  std::size_t first_that_passes(std::size_t from);
  FailedValues unmoved_by_size(std::size_t from);
  std::size_t nearest(std::size_t from);
  void keep_sizing_results();
  /// No candidate passes.
  void report_none(std::size_t from, std::vector<Issue>& issues);
  void report_nearest(std::size_t nearest);
  void refuse_all(std::vector<Issue>& issues);
  [[nodiscard]] account::TriedSize tried(std::size_t i);
  [[nodiscard]] std::vector<account::TriedSize> tried_around(std::size_t best);
  void leave_open(Message why, std::vector<account::TriedSize> tried = {});
  void warn_of_passed_over(std::size_t found, std::vector<Issue>& issues);
  void report_found(std::size_t found);
  void note_found();
  [[nodiscard]] const BodySize* size_of_body() const;
  [[nodiscard]] Message what_is_searched() const;
  [[nodiscard]] Message how_found(bool covered) const;

  Evaluation& evaluation_;
  const Search& wanted_;
  bool in_words_;
  const JointRow* together_;  // null: the row is searched for here
  Candidates candidates_;
  Passing passing_;
};

}  // namespace loadpath::project
