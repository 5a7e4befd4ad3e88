#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/expression/parser.hpp"
#include "lib/quantity/expression/scan.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/quantity/unit_hint.hpp"

#include <algorithm>

namespace loadpath::expression {
namespace {

std::string listed(std::span<const std::string_view> words) {
  std::string all;
  for (const std::string_view word : words) all += (all.empty() ? "" : ", ") + std::string(word);
  return all;
}

bool is_unit(std::string_view text) { return static_cast<bool>(parse_unit(text)); }

Message tonne_message(Names variables) {
  return say("'t' is read as the unit tonne; {1}", variables_message(variables));
}

/// Whether a name is read as a unit somewhere in a literal of the tree.
bool is_read_as_unit(const Tree& tree, const Node& node, std::string_view name) {
  const std::size_t end = node.operation == Operation::literal ? node.at + node.length : node.at;
  for (std::size_t at = node.at; at < end;) {
    const std::size_t word = word_end(tree.text, at);
    if (word != at && std::string_view(tree.text).substr(at, word - at) == name) return true;
    at = word != at ? word : character_end(tree.text, at);
  }
  return std::any_of(node.kids.begin(), node.kids.end(),
                     [&](const Node& kid) { return is_read_as_unit(tree, kid, name); });
}

}  // namespace

Message variables_message(Names variables) {
  return variables.size() == 1
             ? say("the variable is {1}; write other values as numbers with units", variables.front())
             : say("the variables are {1}; write other values as numbers with units", listed(variables));
}

Fault with_variables(Fault fault, const Tree& tree, Names variables) {
  const bool is_tonne = !is_among(variables, "t") && is_read_as_unit(tree, tree.root, "t");
  if (is_tonne)
    fault.hint = tonne_message(variables);
  else if (fault.hint.empty())
    fault.hint = say("give its numbers their units; {1}", variables_message(variables));
  return fault;
}

void Parser::fail(std::size_t at, std::size_t length, Message message, Message hint) {
  if (!fault_) fault_ = Fault{at, std::max<std::size_t>(length, 1), std::move(message), std::move(hint)};
  next_ = text_.size();
}

void Parser::fail_unit(Fault fault, std::size_t from, std::size_t end) {
  if (!variables_.empty() && fail_unknown_variable(from, end)) return;
  if (fault.hint.empty()) fault.hint = say("a unit is written as in 30 N/mm^2; to raise the quantity write (3 mm)^2");
  fail(fault.at, fault.length, std::move(fault.message), std::move(fault.hint));
}

/// The first word of a unit that is none may be a misspelt variable: "5 N*s/m*vx".
bool Parser::fail_unknown_variable(std::size_t from, std::size_t end) {
  for (std::size_t at = from; at < end;) {
    const std::size_t word = std::min(word_end(text_, at), end);
    const std::string name = slice(at, word);
    if (name == "t") {
      fail(at, 1, say("'t' is not a variable"), tonne_message(variables_));
      return true;
    }
    if (!name.empty() && !is_unit(name)) {
      Message hint = variable_hint(name);
      const Message unit = unknown_unit_hint(name);
      const bool is_unit_meant = nearest(name, {variables_.begin(), variables_.end()}).empty() && !unit.empty();
      if (is_unit_meant) hint = say("{1} {2}", unit, std::move(hint));
      fail(at, word - at, say("'{1}' is neither a unit nor a variable", name), std::move(hint));
      return true;
    }
    at = name.empty() ? character_end(text_, at) : word;
  }
  return false;
}

Message Parser::variable_hint(const std::string& name) const {
  const std::string near = nearest(name, {variables_.begin(), variables_.end()});
  return near.empty() ? variables_message(variables_)
                      : say("did you mean '{1}'? {2}", near, variables_message(variables_));
}

void Parser::fail_missing_value() {
  const auto hint = say("write a number, a reference such as lever.drive.M, or a function");
  if (next_ >= text_.size()) return fail(end_, 1, say("a value is missing at the end"), hint);
  const auto word = word_end(text_, next_);
  const auto end = word != next_ ? word : character_end(text_, next_);
  fail(next_, end - next_, say("a value is missing before '{1}'", slice(next_, end)), hint);
}

void Parser::fail_unknown_function(const std::string& name) {
  const auto names = function_names();
  std::string all;
  for (const auto& known : names) all += (all.empty() ? "" : ", ") + known;
  fail(next_, name.size(), say("unknown function '{1}'", name),
       did_you_mean(name, names, say("the functions are {1}", all)));
}

void Parser::fail_bare_name(std::size_t end) {
  const auto word = slice(next_, end);
  const bool may_be_pi = word.size() > 1 && (variables_.empty() || word.size() == 2);  // phi is a variable
  const auto constant = may_be_pi ? nearest(word, {"pi"}) : std::string{};
  Message hint = say("write {1}.RESULT, as in lever.drive.M; a shared value is values.{1}", word);
  if (!variables_.empty()) hint = variable_hint(std::string(word));
  if (find_function(word) != nullptr) {
    hint = say("write {1}", find_function(word)->form);
  } else if (!constant.empty()) {
    hint = say("did you mean '{1}'?", constant);
  } else if (is_unit(word) && variables_.empty()) {
    hint = say("write step.path, as in lever.drive.M; a unit needs a number: 1 {1}", word);
  }
  fail(next_, end - next_,
       variables_.empty() ? say("'{1}' is not a complete reference", word) : say("'{1}' is not a variable", word),
       std::move(hint));
}

/// Whether the last token is the start of a value of a table, cut at a name that is not a word:
/// `tables.sections.IPE`.
bool Parser::is_behind_table() const {
  if (references_.empty()) return false;
  const auto& last = references_.back();
  return last.at + last.path.size() == end_ && last.path.starts_with("tables.");
}

void Parser::fail_unexpected() {
  const auto word = word_end(text_, next_);
  if (is_behind_table()) {
    return fail(next_, 1, say("a name with characters other than letters and digits needs double quotes"),
                say("write '=tables.sections.\"IPE 330\".I_y', in single quotes for TOML"));
  }
  const auto end = character_end(text_, next_);
  if (word != next_) return fail_unexpected_word(word);
  if (sees('(') || sees('.') || digits_end(text_, next_) != next_) return fail_missing_operator(end);
  if (sees(',')) return fail_comma();
  const auto hint = sees(')')   ? say("no '(' is open")
                    : sees('[') ? say("an index in a reference is an integer, as in shaft.segments[2].tau")
                                : say("the operators are + - * / ^");
  fail(next_, end - next_, say("unexpected '{1}'", slice(next_, end)), hint);
}

void Parser::fail_comma() {
  const auto whole = text_.substr(0, next_).find_last_not_of("0123456789") + 1;
  const auto decimals = digits_end(text_, next_ + 1);
  if (whole == next_ || decimals == next_ + 1) {
    return fail(next_, 1, say("unexpected ','"), say("a comma separates the arguments of a function, as in max(a, b)"));
  }
  fail(whole, decimals - whole, say("a comma separates arguments; decimals are written with a point"),
       say("write {1}.{2}", slice(whole, next_), slice(next_ + 1, decimals)));
}

void Parser::fail_unexpected_word(std::size_t end) {
  const auto run = unit_end(text_, next_, variables_);
  const auto path = path_end(text_, next_);
  if (run != next_ && is_unit(text_.substr(next_, run - next_))) {
    const auto unit = slice(next_, run);
    return fail(next_, run - next_, say("the unit '{1}' must follow a number directly", unit),
                say("write * 1 {1}, as in (a + b) * 1 {1}", unit));
  }
  if (path != next_ && is_unit(text_.substr(next_, path - next_))) {
    return fail(next_, path - next_, say("a dot cannot join units here: '{1}' is a reference", slice(next_, path)),
                say("join units by *, as in 2 N*m"));
  }
  fail_missing_operator(std::max(path, end));
}

void Parser::fail_missing_operator(std::size_t end) {
  fail(next_, end - next_, say("an operator is missing before '{1}'", slice(next_, end)), say("write * between them"));
}

}  // namespace loadpath::expression
