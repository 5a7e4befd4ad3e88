// The evaluation of a calculator's step at one position, or at the positions of a cycle, with values of table rows at
// the sizes that follow from them.
#pragma once

#include "lib/project/run/evaluation/evaluated_records.hpp"
#include "lib/project/run/evaluation/inputs.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace loadpath::project {

class Evaluation {
 public:
  Evaluation(const PreparedStep& step, const Known& known);

  [[nodiscard]] const PreparedStep& step() const { return step_; }
  [[nodiscard]] const Calculator& calculator() const { return calculator_; }
  [[nodiscard]] Inputs& inputs() { return inputs_; }
  [[nodiscard]] const Inputs& inputs() const { return inputs_; }
  [[nodiscard]] const Record& record() const { return inputs_.record(); }
  /// The result of the last evaluation.
  [[nodiscard]] const Record& result() const { return result_; }
  [[nodiscard]] const Axis* axis() const { return step_.axis(); }
  [[nodiscard]] std::size_t positions() const { return axis() == nullptr ? 1 : axis()->at.size(); }

  /// The rules between inputs, at every position, but for those that a search has to keep.
  bool check_rules(std::vector<Issue>& issues);
  [[nodiscard]] bool holds(std::size_t rule) const { return calculator_.holds(rule, record().data.get()); }
  [[nodiscard]] Issue broken_rule(std::size_t rule) const;

  /// Sets values of rows at the size that follows from them. Only an evaluation afterwards has the result of them.
  void settle_sizes() { settle_sizes_from(first_size()); }
  /// The same, from the size that was found last: a neighbouring candidate needs fewer rounds.
  void settle_sizes_again() { settle_sizes_from(settled_); }
  [[nodiscard]] bool is_settled() const { return unsettled_.empty(); }
  /// Why the size does not settle.
  [[nodiscard]] const Message& unsettled() const { return unsettled_; }

  /// Puts the inputs of position i into the record; false if one of them is not available there.
  bool set_position(std::size_t i) { return inputs_.set_position(i) && is_settled(); }
  /// The same, and evaluates it.
  bool evaluate_at(std::size_t i);
  /// Evaluates the record as it is.
  void evaluate_record() { evaluated_.reset(), calculator_.evaluate(record().data.get(), result_.data.get()); }
  /// The same, with the lines of the calculation.
  void explain_record(Trace& trace) {
    evaluated_.reset(), calculator_.explain(record().data.get(), result_.data.get(), trace);
  }
  /// The largest value of a result over the positions, refined between them; NaN if one is not available.
  double largest_result(const FieldInfo& field);

  [[nodiscard]] bool is_asked(const FieldInfo& check) const { return step_.is_asked(check, record()); }
  /// Whether a result is a check or a limit of the part.
  [[nodiscard]] bool is_judged(const FieldInfo& field) const;
  /// Why there are no results; empty if no input is missing.
  [[nodiscard]] Message missing() const { return is_settled() ? inputs_.missing() : unsettled_; }

 private:
  void settle_sizes_from(double size);
  [[nodiscard]] bool remembers_results() const;
  void evaluate_or_remember();
  /// NaN if nothing gives it.
  [[nodiscard]] double size_now();
  [[nodiscard]] double first_size();
  [[nodiscard]] Message unsettled_size(double two_before, double before, double now) const;

  const PreparedStep& step_;
  const Calculator& calculator_;
  Inputs inputs_;
  Record result_;
  double settled_ = 0.0;  // size at which values of rows were last looked up
  Message unsettled_;
  EvaluatedRecords evaluated_records_;
  std::optional<RecordState> evaluated_;  // the record that the result is of, where results are remembered
};

}  // namespace loadpath::project
