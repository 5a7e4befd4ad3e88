// Values written once for many steps: [values]. A bare reference, "=values.n", is equivalent to typing the text
// there, be it a quantity, a word, a list; inside an expression, "=2*values.n", it is a literal, or its own
// expression, in parentheses.
#pragma once

#include "lib/quantity/expression/expression.hpp"
#include "lib/sweep/point/axis.hpp"
#include "lib/sweep/point/distribution.hpp"
#include "lib/text/issue.hpp"
#include "lib/toml/tree.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::project {

/// Whether an entry is `[values]`, and no step that was called so.
bool is_shared(const toml::Tree::Entry& entry);

class Values {
 public:
  /// A value that is a range or a list, or uncertain, and that an expression calculates with.
  struct Several {
    std::string name;
    Place place;
    sweep::Axis axis;  // SI
    std::optional<sweep::Distribution> distribution;
  };

  /// Takes the table [values]; unknown names and circular references become issues.
  void read(const toml::Tree::Entry& table, std::vector<Issue>& issues);
  [[nodiscard]] bool empty() const { return all_.empty(); }

  /// The tree with values in place of bare references. Unknown names become issues.
  [[nodiscard]] toml::Tree in_place(const toml::Tree& tree, std::vector<Issue>& issues);
  /// The literal of a name, for an expression; a Fault if there is none.
  [[nodiscard]] Outcome<Signature> signature(const std::string& name);
  /// Null if there is none.
  [[nodiscard]] const Value* literal(const std::string& name) const;
  /// The same, of one that no sweep gives other values, calculated or not.
  [[nodiscard]] const Value* fixed(const std::string& name) const;
  /// The kind of a literal by its unit: "25 Hz".
  [[nodiscard]] Meant kind(const std::string& name) const;
  /// Writes values that are expressions in the place of the references to them. An Issue at `place` where that grows
  /// out of bounds.
  void write_into(Expression& expression, const Place& place, const std::string& key, std::vector<Issue>& issues) const;
  /// Evaluates numbers written as expressions to literals, for tables and expectations, which are read at once.
  /// References to steps remain.
  void write_out_all_numbers(toml::Tree& tree) const;
  /// Marks every value named in the texts of a tree as used: in steps and expectations.
  void note_uses(const toml::Tree& tree);

  /// All that are one number, whether a step refers to them or not, calculated or not.
  [[nodiscard]] std::vector<const Value*> numbers() const;
  /// What is typed for them: literals, words, expressions.
  [[nodiscard]] std::vector<std::string_view> texts() const;
  [[nodiscard]] std::vector<Several> several() const;
  /// Sets such a value to one of its values.
  void set(const std::string& name, double si);
  /// Collects the values that nothing refers to, once all references are read: every step is compared with them.
  void collect_unused();
  /// Quantities among them, by name.
  [[nodiscard]] const std::vector<std::pair<std::string, Value>>& unused() const { return unused_; }
  /// Texts without a number among them, by name: "full" of a vacuum.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& unused_words() const { return unused_words_; }
  /// A warning for every value that nothing refers to.
  void warn_of_unused(std::vector<Issue>& issues) const;

 private:
  struct Shared {
    toml::Tree tree;
    Place place;  // place of its name
    Value literal;
    std::optional<Several> several = {};  // set of values that the literal is one of
    std::optional<Expression> expression = {};
    bool is_literal = false;
    bool is_constant = false;  // an expression that refers to no step; the literal is its value
    bool is_used = false;
    bool in_circle = false;                                                         // reported
    enum class Search : std::uint8_t { fresh, open, done } search = Search::fresh;  // search of its references
  };
  static void read_several(const std::string& name, Shared& shared);
  void write_out_numbers(toml::Tree& tree) const;
  [[nodiscard]] Message nearest_to(const std::string& name) const;
  void refuse_circle(const std::string& name, std::vector<Issue>& issues);
  void refuse_circle(const std::vector<std::string>& names, std::vector<Issue>& issues);
  void settle(const std::string& name, std::vector<std::string>& path, std::vector<Issue>& issues);

  std::map<std::string, Shared> all_;
  std::set<std::string> open_;      // while references are followed
  std::set<std::string> reported_;  // bare names without a value
  std::size_t in_place_ = 0;        // number of replacements of names
  bool too_many_ = false;           // reported
  std::vector<std::pair<std::string, Value>> unused_;
  std::vector<std::pair<std::string, std::string>> unused_words_;
};

}  // namespace loadpath::project
