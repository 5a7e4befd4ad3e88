// The search for a size or a row: the first, from small to large, with which the step passes.
#pragma once

#include "lib/project/run/search/shortfall.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath::project {

/// The candidates of a search, ascending: sizes of a stock, or rows of a table.
struct Candidates {
  Leaf leaf;  // without field: rows
  std::vector<double> sizes;
  std::vector<std::string> rows;
  [[nodiscard]] std::size_t count() const { return leaf ? sizes.size() : rows.size(); }
  [[nodiscard]] Message name(std::size_t i) const;
};

class SizeSearch {
 public:
  /// `in_words`: the result explains why it is not smaller.
  SizeSearch(Evaluation& evaluation, const Search& wanted, bool in_words);
  void run(std::vector<Issue>& issues);

 private:
  /// A size given by another step of the same body is not searched: this one is assessed at it. Returns whether that
  /// applies.
  bool takes_size_of_body();
  /// Excludes sizes smaller than those that the other steps of the same body require.
  void keep_to_body();
  void try_candidate(std::size_t i);
  /// Whether the rules about the searched inputs hold with a candidate, at the sizes that follow from it.
  bool keeps_rules_with(std::size_t i);
  std::size_t first_that_passes(std::size_t from);
  bool excuse_unmoved(std::size_t from);
  std::size_t nearest(std::size_t from);
  void keep_sizing_results();
  /// No candidate passes.
  void tell_none(std::size_t from, std::vector<Issue>& issues);
  void refuse_all(std::vector<Issue>& issues);
  void leave_open(Message why);
  void warn_of_passed_over(std::size_t found, std::vector<Issue>& issues);
  void tell_found(std::size_t found);
  void note_found();
  [[nodiscard]] const BodySize* size_of_body() const;
  [[nodiscard]] Message what_is_searched() const;
  /// The stock or the table that is searched in.
  [[nodiscard]] const std::string& source() const { return wanted_.stock.empty() ? wanted_.path : wanted_.stock; }

  Evaluation& evaluation_;
  const Search& wanted_;
  bool in_words_;
  Candidates candidates_;
  Passing passing_;
};

}  // namespace loadpath::project
