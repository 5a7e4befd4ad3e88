// The parser of expressions: its grammar is in parse.cpp, its messages about wrong texts in fault.cpp.
#pragma once

#include "lib/quantity/expression/scan.hpp"
#include "lib/quantity/expression/tree.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::expression {

/// Recursive descent. The first fault ends the text, so that every loop ends and later faults are ignored.
class Parser {
 public:
  explicit Parser(std::string_view text, Names variables = {}) : text_{text}, variables_{variables} { step_to(0); }
  Outcome<Parsed> parse();

 private:
  Node sum();
  Node product();
  Node signed_power();
  Node power();
  Node primary();
  Node group();
  Node number();
  Node name();
  Node constant(double si, Dimension dimension, std::size_t end);
  Node reference(std::size_t end);
  Node call(std::size_t end);
  [[nodiscard]] Node resultant(Node call) const;
  void arguments(Node& node, std::size_t open);
  void unit(Node& literal);

  [[nodiscard]] bool done() const { return next_ >= text_.size(); }
  [[nodiscard]] bool sees(char c) const { return !done() && text_[next_] == c; }
  [[nodiscard]] std::string slice(std::size_t from, std::size_t to) const {
    return std::string(text_.substr(from, to - from));
  }

  /// The token that ends at `end` is read.
  void step_to(std::size_t end) {
    end_ = end;
    next_ = skip_space(text_, end);
  }
  bool take(std::size_t end) {
    if (end == next_) return false;
    step_to(end);
    return true;
  }
  bool take(char c) { return take(next_ + (sees(c) ? 1 : 0)); }

  Node joined(Operation operation, Node left, Node right) const;
  [[nodiscard]] Node ending_here(Node node, std::size_t from) const {
    node.at = from;
    node.length = end_ - from;
    return node;
  }

  void fail(std::size_t at, std::size_t length, Message message, Message hint);
  void fail_unit(Fault fault, std::size_t from, std::size_t end);
  [[nodiscard]] bool fail_unknown_variable(std::size_t from, std::size_t end);
  [[nodiscard]] Message variable_hint(const std::string& name) const;
  void fail_missing_value();
  void fail_unknown_function(const std::string& name);
  void fail_bare_name(std::size_t end);
  [[nodiscard]] bool is_behind_table() const;
  void fail_unexpected();
  void fail_comma();
  void fail_unexpected_word(std::size_t end);
  void fail_missing_operator(std::size_t end);

  std::string_view text_;
  Names variables_;
  std::size_t next_ = 0;  // start of the next token
  std::size_t end_ = 0;   // end of the last one
  int depth_ = 0;
  std::vector<Reference> references_;
  std::optional<Fault> fault_;
};

}  // namespace loadpath::expression
