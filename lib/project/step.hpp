// One entry of a project. It has two phases: when the file is read it returns dimension and axis of every path that
// others may refer to; when the project is solved it turns values into an account of its results.
#pragma once

#include "lib/account/account.hpp"
#include "lib/calculator/calculator.hpp"
#include "lib/project/read/reading.hpp"
#include "lib/project/series_choice.hpp"

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace loadpath::table {
class Tables;
}

namespace loadpath::project {

using account::Account;
using account::Entry;
using account::Origin;

/// The requested parts of the accounts; parts that are not shown are costly, and are not made.
struct Wanted {
  bool pictures = true;                 // tables and figures
  bool formulas = true;                 // the derivation, written out
  bool unused = true;                   // inputs and reasons without effect
  bool words = true;                    // origins of values, lines of a calculation
  bool warnings = true;                 // of what changes nothing, which takes as long as the rest
  SeriesChoice series = {};             // selection of the series that could be written
  std::set<std::string> taken = {};     // values that other steps refer to, "lever.drive.M": solve() fills it
  std::set<std::string> compared = {};  // values that expectations and typed values are compared with: the same

  /// Whether the series of this path in this step is needed for any of it; pictures show every one.
  [[nodiscard]] bool holds(const std::string& step, const std::string& path) const {
    const std::string full = step + "." + path;
    return pictures || series.holds(step, path) || taken.contains(full) || compared.contains(full);
  }
};

/// The input common to every step of a file.
struct StepInput {
  std::string name;
  std::string title;
  std::string note;
  const Calculator* calculator = nullptr;
  const Template* from = nullptr;  // null: the input is written out
  Reading reading;
  std::shared_ptr<const table::Tables> tables;  // tables for its rows and stocks; never null
  /// Rows that the step names for its providers: "material" -> "C45E".
  std::map<std::string, Typed> rows;
  /// Failure modes that the user answers for, and why: "pitting" -> "rated by the manufacturer, drawing 12".
  std::map<std::string, Typed> accepted;
  /// Reasons why a typed value is better than that of a row or a record: "R_e" -> "certificate 4711".
  std::map<std::string, Typed> because;
  /// The physical part that the step describes, where several do: they share its size.
  Typed body;
  /// Display units of results that the user prefers: "d" -> "in".
  std::map<std::string, std::string> display;
  Place place;  // place of the step's name
};

/// The signatures of other steps' paths, when the file is read.
using Declared = Expression::Declared;
/// Values of other steps, when the project is solved.
struct Known {
  Expression::Known value;
  /// A choice, a name, a row; empty if there is none.
  std::function<std::string(const std::string& path)> word;
  /// Everything in a record or a list, "pulleys": paths behind it, "[2].R", ".pump.R".
  std::function<std::vector<std::pair<std::string, const Entry*>>(const std::string& path)> within;

  const Value& operator()(const std::string& path) const { return value(path); }
};
/// A load that changes its sense over a cycle.
struct Reversal {
  Message text;        // "'press.drive.M', from -375 N·m to 375 N·m"
  double ratio = 0.0;  // the smaller extreme over the larger one, negative
};
/// A load that is only part of the series that it comes from.
struct ReducedLoad {
  std::string path;      // path of the input: "F"
  Message message = {};  // the value used, and the text to write in its place

  bool operator==(const ReducedLoad& other) const {
    return path == other.path && message.text() == other.message.text();
  }
};
/// A size that the other steps of the same body have, of an input that this one searches for.
struct BodySize {
  double si = 0.0;
  bool is_given = false;  // typed there; else the least that it may be
  std::string by;         // the step that requires it
};
/// A less favourable value of an input in another step of the same body.
struct BodyFact {
  double si = 0.0;  // of a choice its index
  std::string by;   // that step

  bool operator==(const BodyFact&) const = default;
};
/// By the path of the input.
using BodyFacts = std::map<std::string, BodyFact>;
/// Facts about the loads of a step.
struct LoadFacts {
  bool vary = false;  // loads come from a rotating part, or vary: known when the project is read
  /// Load components that the step does not include: "lever.links.rod.M_b"; known when it is solved.
  std::string left = {};
  /// Factors included in the loads that the step has taken, and therefore in its results; known when it is solved.
  Factors factors = {};
  /// A factor not included in its loads, and not given here: "T comes without gears.K_A = 1.75: give K_A"; empty
  /// if there is none. Loads taken from this step do not include it either. Known when it is solved.
  Message missing_factor = {};
  std::set<std::string> justified = {};  // factors that are lower here for a reason of the user's
  /// Loads that are less than the series that they come from, and have no reason: no mode of strength is
  /// assessed by them, here and where the results go; known when it is solved.
  std::vector<ReducedLoad> reduced = {};
  std::optional<Reversal> reversal = {};  // reversal of a load; known when the step is solved
};
/// Other loads on the part that takes a path's value: full paths (Step::companions_of).
using Companions = std::function<std::vector<std::string>(const std::string& path)>;

/// A value in a record of a step.
struct Member {
  std::string key;   // within the record: "T"
  std::string path;  // within the step: "gear_2.T"
  bool is_word = false;
};

class Step {
 public:
  explicit Step(StepInput&& input) : input_(std::move(input)) {}
  virtual ~Step() = default;
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

  [[nodiscard]] const std::string& name() const { return input_.name; }
  [[nodiscard]] const StepInput& input() const { return input_; }
  [[nodiscard]] StepInput& input() { return input_; }

  /// Checks everything that can be known before anything runs: expressions' dimensions, names, rules. Called in order
  /// of evaluation.
  virtual void prepare(const Declared& declared, const Companions& companions, std::vector<Issue>& issues) = 0;
  /// Dimension and axis of a path; a Fault with a hint if there is none, without a message if an error of the step,
  /// already reported, leaves it unknown. After `prepare`.
  [[nodiscard]] virtual Outcome<Signature> signature(const std::string& path) const = 0;
  /// The field at a path, a result or an input; null if there is none, or its shape depends on the model.
  [[nodiscard]] virtual const FieldInfo* field(const std::string& path) const;
  /// The members of a record of the step: "gear_2", "links.rod"; empty if there is none of that name.
  [[nodiscard]] virtual std::vector<Member> members(const std::string& path) const;
  /// Whether any member of a record has a value; words do not count.
  [[nodiscard]] bool has_values(const std::string& path) const;
  /// Full paths of the other loads on the part that takes the value at `path`.
  [[nodiscard]] virtual std::vector<std::string> companions_of(const std::string& path) const;
  /// Fills the account; series that are not requested may have no values. A computed value that its field refuses
  /// becomes an issue at its expression.
  virtual void solve(const Known& known, const Wanted& wanted, std::vector<Issue>& issues) = 0;
  /// Solves for results only, with these inputs left open: results that depend on them are not available, or turn out
  /// to differ when the step is solved completely.
  virtual void solve_without(const std::set<std::string>& inputs, const Known& known);
  /// The value at a path, after `solve`; nothing if there is none (an element that the list does not have).
  [[nodiscard]] virtual const Value* value(const std::string& path) const;
  /// Other steps before `solve`: the value of an input, and whether a record may contain a path.
  struct Beforehand {
    std::function<std::optional<Value>(const std::string& path)> value;
    std::function<bool(const std::string& path)> may_have;
  };
  /// The value of an input before `solve`; nothing if that is not certain. `settled`: not one of several values either.
  [[nodiscard]] virtual std::optional<Value> value_beforehand(const std::string& path, bool settled,
                                                              const Beforehand& of) const;
  /// The choice, name or row at a path, after `solve`; empty if there is none.
  [[nodiscard]] std::string word(const std::string& path) const;
  /// Results, else inputs, in a record or a list, each with the rest of its path.
  [[nodiscard]] std::vector<std::pair<std::string, const Entry*>> within(const std::string& path) const;

  [[nodiscard]] const Account& account() const { return account_; }
  /// The failure modes, to be adjusted by other steps.
  [[nodiscard]] account::Modes& modes() { return account_.modes; }
  [[nodiscard]] const LoadFacts& loads() const { return loads_; }
  [[nodiscard]] LoadFacts& loads() { return loads_; }
  /// Adds a remark on the step's inputs to the report.
  void remark(Message remark) { remarks_.push_back(std::move(remark)); }
  [[nodiscard]] const std::vector<Message>& remarks() const { return remarks_; }
  /// The sizes that the body requires, by input (lib/project/solving/bodies.hpp).
  [[nodiscard]] const std::map<std::string, BodySize>& body_sizes() const { return body_sizes_; }
  void set_body_size(const std::string& path, BodySize size) { body_sizes_[path] = std::move(size); }
  /// What the body has less favourable than this step (lib/project/solving/body_facts.hpp); nothing before the steps of
  /// the body have been compared.
  [[nodiscard]] const std::optional<BodyFacts>& body_facts() const { return body_facts_; }
  void set_body_facts(BodyFacts facts) { body_facts_ = std::move(facts); }
  /// What other steps contradict (lib/project/references/machine); nothing before the step is first solved.
  [[nodiscard]] const std::optional<std::vector<ReducedLoad>>& contradictions() const { return contradictions_; }
  void set_contradictions(std::vector<ReducedLoad> all) { contradictions_ = std::move(all); }
  void forget_body() {
    body_sizes_.clear();
    body_facts_.reset();
    contradictions_.reset();
  }
  /// Discards the previous solution.
  void forget() {
    account_ = {};
    rows_found_.clear();
  }
  void warn(Message warning) { account_.warnings.push_back(std::move(warning)); }

 protected:
  [[nodiscard]] StepInput& own() { return input_; }
  /// The row that the step has found for a table.
  void name_row(const std::string& group, std::string row) { rows_found_[group] = std::move(row); }
  [[nodiscard]] Account& own_account() { return account_; }

 private:
  StepInput input_;
  Account account_;
  std::map<std::string, std::string> rows_found_;
  LoadFacts loads_;
  std::vector<Message> remarks_;
  std::map<std::string, BodySize> body_sizes_;
  std::optional<BodyFacts> body_facts_;
  std::optional<std::vector<ReducedLoad>> contradictions_;
};

/// The type of object that a bare reference names.
enum class Form { nothing, number, word, row, record, list };
Form form_of(const Step& step, const std::string& path);

/// Checks the operands of a reading against their fields: dimension, references. The axis that they share, if any;
/// `lifted` false refuses series.
const Axis* check_operands(const Reading& reading, const std::string& step, bool lifted, const Declared& declared,
                           std::vector<Issue>& issues);

/// The value of an operand; nothing and an issue if its field refuses it.
std::optional<Value> evaluate_operand(const Operand& operand, const std::string& step, const Known& known,
                                      std::vector<Issue>& issues);

/// The inputs of a record as entries, except open and unnamed ones. `origin` gives the origin of a leaf. An entire
/// series, which may have millions of values, is that of the record: it gets no other one from then on.
std::vector<Entry> input_entries(const Record& record,
                                 const std::function<Origin(const std::string& path, const Leaf& leaf)>& origin);
/// "given" if it was typed, "default" if it has a value anyway.
Origin plain_origin(const Reading& reading, const std::string& path, const Leaf& leaf);

/// An issue at the field that was typed at `path`, or at its parent.
Issue issue_at(const StepInput& input, const std::string& path, Message message, Message hint = {});

}  // namespace loadpath::project
