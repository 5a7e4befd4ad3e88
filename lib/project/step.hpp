// One entry of a project. It has two phases: when the file is read it tells dimension and axis of every path that
// others may refer to; when the project is solved it turns values into an account of what it found.
#pragma once

#include "lib/account/account.hpp"
#include "lib/calculator/calculator.hpp"
#include "lib/project/read/reading.hpp"
#include "lib/project/series_choice.hpp"

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

using account::Account;
using account::Entry;
using account::Origin;

/// What is wanted of the accounts; what nobody looks at is costly, and is not made.
struct Wanted {
  bool pictures = true;              // tables and figures
  bool formulas = true;              // the derivation, written out
  SeriesChoice series = {};          // of those that could be written
  std::set<std::string> taken = {};  // those that other steps refer to, "lever.drive.M": solve() fills it

  /// Whether the series of this path in this step is needed for any of it; pictures show every one.
  [[nodiscard]] bool holds(const std::string& step, const std::string& path) const {
    return pictures || series.holds(step, path) || taken.count(step + "." + path) != 0;
  }
};

/// What is common to every step of a file.
struct StepInput {
  std::string name;
  std::string title;
  std::string note;
  const Calculator* calculator = nullptr;
  const Template* from = nullptr;  // null: the input is written out
  Reading reading;
  /// Rows that the step names for its providers: "material" -> "C45E".
  std::map<std::string, Typed> rows;
  /// Modes of failure that the user answers for, and why: "pitting" -> "rated by the maker, drawing 12".
  std::map<std::string, std::string> accepted;
  /// Display units of results that the user prefers: "d" -> "in".
  std::map<std::string, std::string> display;
  Place place;  // of the step's name
};

/// The signatures of other steps' paths, when the file is read.
using Declared = Expression::Declared;
/// Their values, when it is solved.
using Known = Expression::Known;
/// What else loads the part that takes a path's value: full paths (Step::companions_of).
using Companions = std::function<std::vector<std::string>(const std::string& path)>;

class Step {
 public:
  explicit Step(StepInput&& input) : input_(std::move(input)) {}
  virtual ~Step() = default;
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

  [[nodiscard]] const std::string& name() const { return input_.name; }
  [[nodiscard]] const StepInput& input() const { return input_; }

  /// Checks what can be known before anything runs: expressions' dimensions, names, rules. Called in order of
  /// evaluation.
  virtual void prepare(const Declared& declared, const Companions& companions, std::vector<Issue>& issues) = 0;
  /// Dimension and axis of a path; a Fault with a hint where there is none, without a message where the step's own
  /// errors, which are told, leave it unknown. After `prepare`.
  [[nodiscard]] virtual Outcome<Signature> signature(const std::string& path) const = 0;
  /// Full paths of what else loads the part that takes the value at `path`.
  [[nodiscard]] virtual std::vector<std::string> companions_of(const std::string& path) const;
  /// Fills the account; series that are not wanted may have no values. A computed value that its field refuses becomes
  /// an issue at its expression.
  virtual void solve(const Known& known, const Wanted& wanted, std::vector<Issue>& issues) = 0;
  /// The value at a path, after `solve`; nothing where there is none (an element that the list does not have).
  [[nodiscard]] virtual const Value* value(const std::string& path) const;

  [[nodiscard]] const Account& account() const { return account_; }
  /// Whether what loads the part comes from something that turns, or varies: known when the project is read.
  [[nodiscard]] bool load_varies() const { return load_varies_; }
  void set_load_varies(bool varies) { load_varies_ = varies; }
  /// What comes along with the loads of the step, and it does not take: "lever.links.rod.M_b"; after `prepare`.
  [[nodiscard]] const std::string& left_of_loads() const { return left_of_loads_; }
  void warn(Message warning) { account_.warnings.push_back(std::move(warning)); }

 protected:
  [[nodiscard]] StepInput& own() { return input_; }
  [[nodiscard]] Account& own_account() { return account_; }
  void leave_of_loads(std::string names) { left_of_loads_ = std::move(names); }

 private:
  StepInput input_;
  Account account_;
  bool load_varies_ = false;
  std::string left_of_loads_;
};

/// Checks the operands of a reading against their fields: dimension, references. The axis that they share, if any;
/// `lifted` false refuses series.
const Axis* check_operands(const Reading& reading, const std::string& step, bool lifted, const Declared& declared,
                           std::vector<Issue>& issues);

/// The value of an operand; nothing and an issue where its field refuses it.
std::optional<Value> evaluate_operand(const Operand& operand, const std::string& step, const Known& known,
                                      std::vector<Issue>& issues);

/// The inputs of a record as entries, those left open and unnamed left out. `origin` tells where a leaf comes from.
std::vector<Entry> input_entries(const Record& record,
                                 const std::function<Origin(const std::string& path, const Leaf& leaf)>& origin);
/// "given" where it was typed, "default" where it has a value all the same.
Origin plain_origin(const Reading& reading, const std::string& path, const Leaf& leaf);

/// An issue at the field that was typed at `path`, or at what it is part of.
Issue issue_at(const StepInput& input, const std::string& path, Message message, Message hint = {});

}  // namespace loadpath::project
