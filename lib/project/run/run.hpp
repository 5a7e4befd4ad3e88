// One solving of a calculator step: at one position, or at every position of a cycle.
#pragma once

#include "lib/project/run/calculator_step.hpp"

#include <vector>

namespace loadpath::project {

class Run {
 public:
  Run(const CalculatorStep& step, const Known& known);

  /// The values of expressions and companions; what a field refuses becomes an issue at its expression.
  bool evaluate_operands(std::vector<Issue>& issues);
  /// The rules between inputs, at every position.
  bool check_rules(std::vector<Issue>& issues);
  /// Sets the leaf that is searched for to the smallest value of its stock that passes every check at every position.
  /// An issue where no check is asked for, so that any value would pass.
  bool search(std::vector<Issue>& issues);
  /// All results at all positions.
  void evaluate();
  /// A warning for every typed quantity that no result depends on.
  void warn_of_unused(std::vector<Issue>& issues);
  void fill(const Wanted& wanted, Account& account) const;

 private:
  /// Of a utilisation: a size that is just the least one passes, and what is just zero may have a sign.
  static constexpr double rounding = 1e-9;

  /// A leaf that is set anew at every position.
  struct Input {
    std::string path;
    Leaf leaf;
    Value value;
    Origin origin;
  };
  /// A result leaf over the positions.
  struct Column {
    std::string path;
    const FieldInfo* field;
    std::vector<double> si;
  };

  [[nodiscard]] Input companion_input(const Provided& provided) const;
  void add_columns();
  [[nodiscard]] std::size_t positions() const { return axis_ == nullptr ? 1 : axis_->at.size(); }
  /// Puts the inputs of position i into the record; false where one of them is not available there.
  bool set_position(std::size_t i);
  /// Values from tables at a size; false where a table has none (missing_ says why).
  bool provide(double size);
  /// Values from tables at the size that follows from them.
  bool settle_sizes();
  [[nodiscard]] const char* size_field() const;
  /// NaN where nothing gives it.
  [[nodiscard]] double size_now();
  [[nodiscard]] double first_size();
  /// The largest value of a result over the positions, refined between them; NaN where one is not available.
  double largest_result(const FieldInfo& field);
  [[nodiscard]] bool is_asked(const FieldInfo& check) const;
  [[nodiscard]] bool comes_from_row(std::string_view input, const FieldInfo& field) const;
  [[nodiscard]] bool is_any_asked() const;
  [[nodiscard]] Issue aimless(const Search& wanted) const;
  std::size_t first_broken_rule();
  bool passes();
  bool keeps_limits(bool criteria);
  std::vector<double>::const_iterator first_that_passes(const std::vector<double>& values, double least,
                                                        const Leaf& leaf, bool covered);
  bool take_largest(const std::vector<double>& values, const Leaf& leaf);
  void keep_sizing_results(const std::string& searched);
  [[nodiscard]] Leaf map_leaf(const std::string& path) const { return find_leaf(record_, path); }

  [[nodiscard]] std::vector<double> numbers_at(std::size_t position);
  [[nodiscard]] bool keeps_rules() const;
  bool moves_something(const Leaf& leaf, std::size_t position, const std::vector<double>& before);
  void trace_governing();
  [[nodiscard]] std::size_t governing_position() const;
  void fill_inputs(Account& account) const;
  [[nodiscard]] bool applies(const Column& column) const;
  void fill_results(Account& account) const;
  void fill_verdicts(Account& account) const;
  void fill_modes(Account& account) const;
  void add_missing_input(Account& account) const;
  /// Which modes concern the part as it is now in the record.
  void ask_modes();
  /// Of a part that is not known: any may.
  void doubt_modes();
  [[nodiscard]] bool is_judged(const ModeInfo& mode, const Account& account, std::string& wants) const;
  void excuse_uncovered(Account& account) const;
  [[nodiscard]] Message missing_input() const;
  [[nodiscard]] account::Verdict check_verdict(const Column& column) const;
  [[nodiscard]] account::Verdict limit_verdict(const Column& column) const;
  [[nodiscard]] Value value_of(const Column& column) const;
  [[nodiscard]] Origin origin_of(const std::string& path, const Leaf& leaf) const;

  const CalculatorStep& step_;
  const Calculator& calculator_;
  const Known& known_;
  const Axis* axis_;
  Record record_;
  Record result_;
  std::vector<Input> inputs_;
  std::map<std::string, Origin> origins_;  // of provided, kept and searched leaves
  Message missing_;                        // why a table's value is not available
  bool lacks_needed_ = false;              // such a value, and the calculator needs it
  std::vector<Column> columns_;
  std::vector<std::size_t> order_;  // of columns, for a walk over the result
  std::vector<Applies> applies_;    // of every mode, over the positions
  Trace trace_;
  std::size_t governing_ = 0;
  bool traced_ = false;
};

}  // namespace loadpath::project
