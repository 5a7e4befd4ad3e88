// The parsed expression, shared by its parser, its check and its evaluation.
#pragma once

#include "lib/numerics/jet.hpp"
#include "lib/quantity/expression/interval.hpp"
#include "lib/quantity/expression/references.hpp"
#include "lib/quantity/kinds.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::expression {

/// The rule for the arguments and the result of a function.
enum class Rule {
  reduction,        // a series to one value of its dimension
  cycle_reduction,  // the same, of a cycle only
  place,            // a series and a position of its axis
  selection,        // like quantities to one of them; a single series is reduced
  same,             // any quantity to one of its dimension
  root,             // the dimension is divided by `degree`
  trigonometric,    // an angle or a number to a number
  number,           // a number to a number
  inverse,          // a number to an angle
  ratio,            // two like quantities to an angle
  stresses          // a normal and a shear stress to one stress
};

struct Function {
  std::string_view name;
  std::string_view form;  // written form, for hints
  Rule rule;
  std::size_t least, most;  // arguments
  double (*reduce)(const Value&) = nullptr;
  double (*map)(double) = nullptr;
  double (*join)(double, double) = nullptr;
  int degree = 1;
  bool is_magnitude = false;  // never negative, for any argument
  bool is_resultant = false;  // the parser writes it out: the root of the sum of the squares of the arguments
  numerics::Jet (*jet)(const numerics::Jet&) =
      nullptr;  // smooth functions of one argument; null for functions with kinks
  numerics::Jet (*jet_of_two)(const numerics::Jet&, const numerics::Jet&) = nullptr;
  IntervalJet (*bounds)(const IntervalJet&) = nullptr;  // set if `jet` is
  IntervalJet (*bounds_of_two)(const IntervalJet&, const IntervalJet&) = nullptr;
};

/// Null if no function has the name.
const Function* find_function(std::string_view name);

enum class Operation { literal, reference, negate, add, subtract, multiply, divide, power, call };

struct Node {
  Operation operation = Operation::literal;
  std::size_t at = 0, length = 0;      // bytes of the text
  double si = 0.0;                     // value of a literal
  Dimension dimension;                 // dimension of a literal
  Meant kind = Meant::nothing;         // kind of a literal, by its unit
  std::string path;                    // path of a reference
  const Function* function = nullptr;  // function of a call; of a sum: the one that adds squares
  std::vector<Node> kids;
};

struct Tree {
  std::string text;
  Node root;
  [[nodiscard]] std::string written(const Node& node) const { return text.substr(node.at, node.length); }
};

struct Parsed {
  Tree tree;
  std::vector<Reference> references;
};
/// `variables`: bare names that are references and not units.
Outcome<Parsed> parse(std::string_view text, std::span<const std::string_view> variables = {});

Outcome<Signature> check(const Tree& tree, const Declared& declared);
/// Checks one node of the tree.
Outcome<Signature> check(const Tree& tree, const Node& node, const Declared& declared);

/// The numbers and the axis of a tree that passed its check; the dimension is left to the check.
Value numbers(const Node& node, const Known& known);

/// The number of a tree that passed its check and refers to single values only.
double number(const Node& node, const Single& single);

/// The same for single values, at all points of `out`; false if it refers to a place in a series.
bool numbers(const Node& node, const Column& column, std::span<double> out);

/// "the variables are x, v_x; write other values as numbers with units"
Message variables_message(std::span<const std::string_view> variables);
/// A fault of dimensions with its remedy: a unit that was meant as a variable, else the variables.
Fault with_variables(Fault fault, const Tree& tree, std::span<const std::string_view> variables);

/// The value of a tree without references.
double constant(const Node& node);
bool is_constant(const Node& node);

}  // namespace loadpath::expression
