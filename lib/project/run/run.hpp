// One solving of a calculator step: at one position, or at every position of a cycle.
#pragma once

#include "lib/account/rows.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/project/modes.hpp"
#include "lib/project/run/beside.hpp"
#include "lib/project/run/calculator_step.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

/// What an input can move: results, which modes of failure concern the part, which customs it breaks.
struct Effects {
  std::vector<double> numbers;
  std::string words;
};

class Run {
 public:
  /// `in_words`: why what a search finds is no smaller, where it comes from.
  Run(const CalculatorStep& step, const Known& known, bool in_words);

  /// Words, lists and rows of other steps; what a field refuses becomes an issue at the reference.
  bool take_from_others(std::vector<Issue>& issues);
  /// The values of expressions and companions; what a field refuses becomes an issue at its expression.
  /// `left_open`: inputs that are passed over.
  bool evaluate_operands(std::vector<Issue>& issues, const std::set<std::string>& left_open = {});
  /// An issue for everything typed that says of the part what the row or the record beside it does not.
  bool refuse_other_parts(std::vector<Issue>& issues) const;
  /// After `evaluate`: of what is bolder than what stands beside it, the reason is kept, or the modes that it decides
  /// are held back. `tells`: a reason that nothing needs is an issue.
  void weigh_typed_values(bool tells, std::vector<Issue>& issues);
  /// The typed inputs that were compared; whether with what depends on a size; whether modes are held back.
  [[nodiscard]] const std::vector<std::string>& compared() const { return compared_; }
  [[nodiscard]] bool compared_by_size() const { return compared_by_size_; }
  [[nodiscard]] bool holds_back() const { return holds_back_; }
  /// The rules between inputs, at every position.
  bool check_rules(std::vector<Issue>& issues);
  /// Sets what is searched for: a size to the smallest of its stock with which every check passes at every position, a
  /// row to the first of its table, a load to the largest. An issue where no check is asked for, so that any would
  /// pass.
  bool search(std::vector<Issue>& issues);
  /// All results at all positions.
  void evaluate();
  /// What the calculation says where it governs; without words the results there alone.
  void trace_governing();
  /// A warning for every typed input that could have been left out and has no effect.
  void warn_of_unused(std::vector<Issue>& issues);
  void fill(const Wanted& wanted, Account& account) const;
  /// By their groups, those that were found among them.
  [[nodiscard]] const Rows& rows() const { return rows_; }

 private:
  /// A leaf that is set anew at every position, or once where it takes a series whole.
  struct Input {
    std::string path;
    Leaf leaf;
    Value value;
    Origin origin;
    bool is_whole = false;
  };
  /// A result leaf over the positions.
  struct Column {
    std::string path;
    const FieldInfo* field;
    std::vector<double> si;
  };

  /// What stands beside a typed value.
  struct Neighbour {
    std::string path;
    Leaf leaf;
    Value value;
    Message source;  // "the material 'S235JR'"
    Beside kind = Beside::identity;
    bool by_size = false;
    std::string row_of = {};  // the table of the row; empty: of a record, or a strength
  };
  [[nodiscard]] double size_of(const FieldInfo& field) const;
  [[nodiscard]] Value value_at(const std::string& path, const Leaf& leaf) const;
  [[nodiscard]] bool answers_for_reduction(const std::string& path) const;
  [[nodiscard]] const StrengthBound* bound_of(const std::string& path) const;
  [[nodiscard]] double strength_of_part(const char* key) const;
  [[nodiscard]] bool may_change(const char* column, double part, double typed) const;
  void add_rows_beside(std::vector<Neighbour>& all) const;
  void add_records_beside(std::vector<Neighbour>& all) const;
  void add_strengths_beside(std::vector<Neighbour>& all) const;
  [[nodiscard]] std::vector<Neighbour> neighbours() const;
  [[nodiscard]] std::vector<Neighbour> bolder_ones();
  [[nodiscard]] Message excess_of(const Neighbour& beside) const;
  void set_value(const Neighbour& beside, const Value& value);
  void mark_decided(const Neighbour& beside, const Bolder& bolder);
  [[nodiscard]] Bolder bolder_in(const std::vector<const account::Verdict*>& rows) const;

  void take_word(const Taken& taken, std::vector<Issue>& issues);
  void take_list(const Taken& taken, std::vector<Issue>& issues);
  /// What has no value in the other step.
  void leave_open(const Taken& taken);
  void refuse_length(const Taken& taken, std::vector<Issue>& issues) const;
  void take_row(const std::string& group, const std::string& row, std::vector<Issue>& issues);
  /// Sets what is taken whole; the rest is set position by position.
  void add_input(Input input);
  [[nodiscard]] Input companion_input(const Provided& provided) const;
  void add_columns();
  [[nodiscard]] std::size_t positions() const { return axis_ == nullptr ? 1 : axis_->at.size(); }
  /// Puts the inputs of position i into the record; false where one of them is not available there.
  bool set_position(std::size_t i);
  /// Values from tables at a size; where a table has none, missing_ says why.
  void provide(double size);
  /// Values from tables at the size that follows from them.
  void settle_sizes() { settle_sizes(first_size()); }
  void settle_sizes(double size);
  [[nodiscard]] std::string_view size_field() const;
  [[nodiscard]] bool is_given(std::string_view input) const;
  /// NaN where nothing gives it.
  [[nodiscard]] double size_now();
  [[nodiscard]] double first_size();
  /// The largest value of a result over the positions, refined between them; NaN where one is not available.
  double largest_result(const FieldInfo& field);
  [[nodiscard]] bool is_asked(const FieldInfo& check) const;
  [[nodiscard]] bool is_any_asked() const;
  [[nodiscard]] Issue aimless(const Search& wanted) const;
  [[nodiscard]] bool concerns_search(std::size_t rule) const;
  /// Whether a rule is about what is not there before the search.
  [[nodiscard]] bool waits_for_search(std::size_t rule) const;
  std::size_t first_broken_rule();
  bool passes();
  bool keeps_limits(bool criteria);
  bool lists_pass(bool criteria);
  [[nodiscard]] bool is_held_against(const FieldInfo& field, bool criteria) const;
  bool passes_covered();
  [[nodiscard]] bool keeps(const FieldInfo& field, const void* owner, bool criteria) const;
  [[nodiscard]] bool element_passes(const FieldInfo& list, void* element, bool criteria) const;
  [[nodiscard]] std::optional<double> first_outside(const FieldInfo& limit);
  [[nodiscard]] std::optional<double> failed(const FieldInfo& check);
  /// What a search goes through, ascending: sizes of a stock, or rows of a table.
  struct Candidates {
    Leaf leaf;  // without field: rows
    std::vector<double> sizes;
    std::vector<std::string> rows;
    [[nodiscard]] std::size_t count() const { return leaf ? sizes.size() : rows.size(); }
    [[nodiscard]] Message name(std::size_t i) const;
  };
  [[nodiscard]] Candidates candidates_of(const Search& wanted) const;
  void note_found(const Search& wanted);
  bool takes_size_of_body(const Search& wanted);
  void keep_to_body(const std::string& path, Candidates& all) const;
  void try_candidate(const Candidates& all, std::size_t i);
  bool fits(const Candidates& all, std::size_t i);
  std::size_t first_that_fits(const Candidates& all, std::size_t from);
  bool excuse_unmoved(const Candidates& all, std::size_t from);
  /// How far a candidate is from passing: the largest check, and the factor by which it is beyond limits; 1 passes.
  struct Lack {
    double check = 1.0, limit = 1.0;
  };
  [[nodiscard]] Lack lack_of_candidate();
  void add_lack_of(const FieldInfo& list, Lack& lack);
  [[nodiscard]] static double excess_of(const FieldInfo& limit, double si);
  std::size_t nearest(const Candidates& all, std::size_t from);
  void leave_without(const Search& wanted, const Candidates& all, std::size_t from, std::vector<Issue>& issues);
  void leave_open(const Search& wanted, Message why);
  void warn_of_found(const Search& wanted, std::vector<Issue>& issues);
  [[nodiscard]] Message other_methods() const;
  bool passes_whole();
  Message fault_of_excused();
  void search_first(const Search& wanted, std::vector<Issue>& issues);
  void search_most(const Search& wanted, std::vector<Issue>& issues);
  /// Sizes that are searched for together.
  struct Together;
  [[nodiscard]] Together sought_together();
  bool lay(Together& all, const std::vector<std::size_t>& least);
  bool fits_together(Together& all, const std::vector<std::size_t>& least);
  bool find_start(Together& all, std::vector<std::size_t>& least);
  bool find_cheapest(Together& all, std::vector<std::size_t>& least);
  struct Branching;
  void branch(Branching& at, std::size_t group);
  bool find_cheaper(Together& all, double lowest, std::vector<std::size_t>& least);
  bool places_hold(const Together& all, std::size_t first);
  [[nodiscard]] bool is_sound(const Together& all) const;
  void lower(Together& all, std::vector<std::size_t>& least);
  bool lower_one(Together& all, std::vector<std::size_t>& least, std::size_t which);
  static bool shrink(Together& all, const std::vector<std::size_t>& laid, std::size_t which);
  bool lay_smaller(Together& all, const std::vector<std::size_t>& laid, std::size_t which);
  void lower_alone(Together& all, std::vector<std::size_t>& least);
  [[nodiscard]] bool has_check();
  bool lay_largest(Together& all, std::vector<std::size_t>& least);
  void search_together(std::vector<Issue>& issues);
  [[nodiscard]] Message fault_of_less(Together& all, const std::vector<std::size_t>& laid, std::size_t which);
  void tell_together(Together& all, const std::vector<std::size_t>& least, bool found);
  void warn_of_passed_over(const Search& wanted, const Candidates& all, std::size_t found, std::vector<Issue>& issues);
  void tell_found(const Search& wanted, const Candidates& all, std::size_t found);
  void tell_none(const Search& wanted, double value, std::vector<Issue>& issues);
  bool passes_with(const Leaf& leaf, double value);
  /// What a candidate is refused for.
  [[nodiscard]] Message fault_of_candidate();
  [[nodiscard]] Message fault_of_limits();
  [[nodiscard]] Message fault_of_lists(double most);
  void keep_sizing_results(const std::string& searched);
  [[nodiscard]] Leaf map_leaf(const std::string& path) const { return find_leaf(record_, path); }

  void find_effects(Effects& effects);
  [[nodiscard]] bool keeps_rules() const;
  bool has_effect(const Leaf& leaf, std::size_t position);
  [[nodiscard]] bool lacks_checks() const;
  [[nodiscard]] bool takes_long() const;
  [[nodiscard]] std::vector<std::size_t> probes() const;
  [[nodiscard]] double untyped(const std::string& path, const FieldInfo& field) const;
  bool is_spare(const std::string& path, const Leaf& leaf);
  [[nodiscard]] std::size_t governing_position() const;
  void fill_inputs(Account& account) const;
  void fill_rows(Account& account) const;
  void tell_unjudged(Account& account) const;
  [[nodiscard]] bool applies(const Column& column) const;
  [[nodiscard]] bool is_handed_over(const std::string& path) const;
  void fill_words_of_records(Account& account) const;
  void fill_results(Account& account) const;
  void fill_verdicts(Account& account) const;
  void fill_modes(Account& account) const;
  void add_missing_input(Account& account) const;
  void add_missing_load(Account& account) const;
  void add_bolder(Account& account) const;
  [[nodiscard]] bool is_loaded() const;
  [[nodiscard]] bool is_load_told() const;
  /// Which modes concern the part as it is now in the record.
  void ask_modes();
  /// Of a part that is not known: any may.
  void doubt_modes();
  void excuse_uncovered(Account& account) const;
  [[nodiscard]] Message missing_input() const;
  [[nodiscard]] account::Verdict check_verdict(const Column& column) const;
  [[nodiscard]] account::Verdict limit_verdict(const Column& column) const;
  [[nodiscard]] Value value_of(const Column& column) const;
  [[nodiscard]] Origin origin_of(const std::string& path, const Leaf& leaf) const;

  bool in_words_;
  const CalculatorStep& step_;
  const Calculator& calculator_;
  const Known& known_;
  const Axis* axis_;
  Record record_;
  Record result_;
  Rows rows_;
  std::vector<Provided> provided_;
  Message not_given_;  // a word or a list of another step that is not available; empty: there is none
  bool search_failed_ = false;
  std::vector<Input> inputs_;
  std::map<std::string, Origin> origins_;  // of provided, kept and searched leaves
  std::set<const FieldInfo*> excused_;     // limits that no candidate of a search changes
  std::vector<bool> concerned_;            // of every rule whether a search has to keep it, once that was asked
  double settled_ = 0.0;                   // the size that values of tables were asked at last
  Message missing_;                        // why a table's value is not available
  std::vector<Column> columns_;
  std::vector<std::size_t> order_;          // of columns, for a walk over the result
  std::vector<Applies> applies_;            // of every mode, over the positions
  std::map<std::string, Bolder> bolder_;    // by the check or limit that such a value decides
  std::vector<Bolder> handed_on_;           // values without a reason that no check of the step sees, and others do
  std::map<std::string, Message> reasons_;  // by the input: how it is bolder, and why
  std::vector<std::string> compared_;
  bool compared_by_size_ = false, holds_back_ = false;
  Trace trace_;
  std::size_t governing_ = 0;
  bool traced_ = false;
};

}  // namespace loadpath::project
