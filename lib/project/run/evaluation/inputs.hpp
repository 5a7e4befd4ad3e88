// The inputs of a step while it is solved: the record of its calculator, values of other steps at the positions of a
// cycle, and values of table rows.
#pragma once

#include "lib/project/run/evaluation/prepared_step.hpp"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

/// An input whose value comes from other steps: set at every position, or once if it takes an entire series.
struct ComputedInput {
  std::string path;
  Leaf leaf;
  Value value;
  Origin origin;
  bool is_whole = false;
};

class Inputs {
 public:
  Inputs(const PreparedStep& step, const Known& known);
  Inputs(const Inputs&) = delete;  // leaves refer to the record
  Inputs& operator=(const Inputs&) = delete;

  /// Words, lists and rows of other steps; values that a field refuses become issues at the reference.
  bool take_from_others(std::vector<Issue>& issues);
  /// The values of expressions and companions; values that a field refuses become issues at their expression.
  /// `left_open`: inputs to be skipped.
  bool evaluate_operands(std::vector<Issue>& issues, const std::set<std::string>& left_open = {});
  void take_row(const std::string& group, const std::string& row, std::vector<Issue>& issues);
  /// Leaves a row open, and the inputs that it gives.
  void clear_row(const std::string& group);
  /// Sets the values of rows at a size, and returns whether one of them changed; if a table has none, `table_gap` gives
  /// the reason.
  bool set_values_of_rows(double size);
  /// Puts the computed inputs at position i into the record; false if one of them is not available there.
  bool set_position(std::size_t i);
  /// Sets an input at every position.
  void set_value(const std::string& path, const Leaf& leaf, const Value& value);
  void set_origin(const std::string& path, Origin origin) { origins_[path] = std::move(origin); }
  /// Marks an input as not available, which leaves the step without results. `subject`: of the message in the report.
  void set_unavailable(Message why, account::Subject subject = account::Subject::input) {
    unavailable_ = std::move(why);
    subject_ = subject;
  }

  [[nodiscard]] const Record& record() const { return record_; }
  [[nodiscard]] Leaf leaf(std::string_view path) const { return find_leaf(record_, path); }
  [[nodiscard]] const std::vector<ComputedInput>& computed() const { return computed_; }
  /// The computed input at a path; null if there is none.
  [[nodiscard]] const ComputedInput* find_computed(std::string_view path) const;
  [[nodiscard]] Value value_of(const std::string& path, const Leaf& leaf) const;
  [[nodiscard]] const std::vector<Provided>& provided() const { return provided_; }
  /// The rows by their groups, including those that were found.
  [[nodiscard]] const Rows& rows() const { return rows_; }
  /// The input or result that gives the size of rows: the first given one of the sizes, "d_h, d", else the last.
  [[nodiscard]] std::string_view size_field() const;
  [[nodiscard]] Origin origin_of(const std::string& path, const Leaf& leaf) const;
  /// The origin of a row that was taken from another step or found; null for one that the step names itself.
  [[nodiscard]] const Origin* origin_of_row(const std::string& group) const;
  /// Why a table's value is not available; empty if all are.
  [[nodiscard]] const Message& table_gap() const { return table_gap_; }
  /// The message that names an input without a value somewhere; empty if all have values.
  [[nodiscard]] Message missing() const;
  [[nodiscard]] account::Subject subject_of_missing() const { return subject_; }

 private:
  bool find_records(const std::set<std::string>& left_open, std::vector<Issue>& issues);
  bool has_elements(const Operand& operand, std::vector<Issue>& issues) const;
  void take_word(const Taken& taken, std::vector<Issue>& issues);
  void take_list(const Taken& taken, std::vector<Issue>& issues);
  void add_computed(ComputedInput input);
  [[nodiscard]] ComputedInput companion_input(const Provided& provided) const;
  [[nodiscard]] bool is_given(std::string_view input) const;

  const PreparedStep& step_;
  const Known& known_;
  Record record_;
  Rows rows_;
  std::vector<Provided> provided_;
  std::vector<ComputedInput> computed_;
  std::map<std::string, Origin> origins_;  // origins of rows, and of leaves that were provided, kept or searched for
  Message unavailable_;                    // a word, a list, or a search without result; empty: there is none
  account::Subject subject_ = account::Subject::input;
  Message table_gap_;
};

}  // namespace loadpath::project
