#include "lib/formula/names.hpp"
#include "lib/formula/tree.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace loadpath::formula {
namespace {

using Number = std::optional<double>;  // nothing: unknown name. NaN is a value, and compares as in C++.

double read(std::string_view text) {
  double number = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

Number named(const std::string& name, const Known& known) {
  if (const Number given = known ? known(name) : std::nullopt) return given;
  return constant(name);
}

double joined(std::string_view op, double a, double b) {
  if (op == "+") return a + b;
  if (op == "-") return a - b;
  if (op == "*") return a * b;
  if (op == "/") return a / b;
  if (op == "<") return a < b;
  if (op == "<=") return a <= b;
  if (op == ">") return a > b;
  if (op == ">=") return a >= b;
  return op == "==" ? a == b : a != b;
}

double called(std::string_view function, double x) {
  if (function == "sqrt") return std::sqrt(x);
  if (function == "cbrt") return std::cbrt(x);
  if (function == "abs") return std::fabs(x);
  if (function == "sin") return std::sin(x);
  if (function == "cos") return std::cos(x);
  if (function == "tan") return std::tan(x);
  if (function == "asin") return std::asin(x);
  if (function == "acos") return std::acos(x);
  if (function == "atan") return std::atan(x);
  if (function == "exp") return std::exp(x);
  if (function == "log") return std::log(x);
  if (function.starts_with("pow<")) return std::pow(x, template_number(function));
  return std::pow(x, 1.0 / template_number(function));  // root<n>
}

double called(std::string_view function, double a, double b) {
  if (function == "pow") return std::pow(a, b);
  return function == "min" ? std::min(a, b) : std::max(a, b);
}

Number evaluated(const Node& tree, const Known& known);

Number of_binary(const Node& tree, const Known& known) {
  const Number a = evaluated(tree.kids[0], known);
  if (!a) return a;
  if (tree.text == "&&" && *a == 0.0) return 0.0;
  if (tree.text == "||" && *a != 0.0) return 1.0;
  const Number b = evaluated(tree.kids[1], known);
  if (!b) return b;
  if (tree.text == "&&" || tree.text == "||") return *b != 0.0;
  return joined(tree.text, *a, *b);
}

Number of_call(const Node& tree, const Known& known) {
  const Number a = evaluated(tree.kids[0], known);
  if (tree.text == "is_set") return a && !std::isnan(*a);
  if (!a || tree.kids.size() == 1) return a ? Number(called(tree.text, *a)) : a;
  const Number b = evaluated(tree.kids[1], known);
  return b ? Number(called(tree.text, *a, *b)) : b;
}

Number evaluated(const Node& tree, const Known& known) {
  switch (tree.kind) {
    case Kind::number:
      return read(tree.text);
    case Kind::symbol:
      return named(tree.text, known);
    case Kind::binary:
      return of_binary(tree, known);
    case Kind::call:
      return of_call(tree, known);
    case Kind::negate: {
      const Number a = evaluated(tree.kids[0], known);
      return a ? Number(-*a) : a;
    }
    case Kind::choose: {
      const Number condition = evaluated(tree.kids[0], known);
      return condition ? evaluated(tree.kids[*condition != 0.0 ? 1 : 2], known) : condition;
    }
  }
  return std::nullopt;
}

}  // namespace

double value(const Node& tree, const Known& known) {
  return evaluated(tree, known).value_or(std::numeric_limits<double>::quiet_NaN());
}

const Node& chosen(const Node& tree, const Known& known) {
  if (tree.kind != Kind::choose) return tree;
  const double condition = value(tree.kids[0], known);
  return std::isnan(condition) ? tree : chosen(tree.kids[condition != 0.0 ? 1 : 2], known);
}

}  // namespace loadpath::formula
