// The small language in which STEP texts are written: C++ expressions over symbols, read back for the report.
//
//   + - * / ?: comparisons && || unary - parentheses, calls (sqrt cbrt pow<n> root<n> pow(x, y) abs sin cos tan asin
//   acos atan exp log min max is_set), numbers, unit names (`d / mm`, `10.0 * mm`), and names that are symbols: d,
//   without or with the object that it is read from: in.d of the input, r.F_c of the result, pulley.d of an element
//   of a list. A choice is compared with one of its words: in.kind == Kind::wide.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::formula {

enum class Kind { number, symbol, negate, binary, call, choose };

struct Node {
  Kind kind = Kind::number;
  std::string text;  // the number, name, operator or function as written; pow<3> keeps its argument: "pow<3>"
  std::vector<Node> kids;
};

/// The tree of a formula, or nothing if the text is not in the language. A name keeps its object ("in.d"); a word of a
/// choice takes it from its choice: in.kind == Kind::wide compares "in.kind" with "in.kind::wide".
std::optional<Node> parse(std::string_view cpp);

/// The names of a tree, each once, as written.
std::vector<std::string> names(const Node& tree);

/// The d of "in.d", the wide of "in.kind::wide".
std::string_view symbol_of(std::string_view name);

/// The formula as it is shown: of every name its symbol.
std::string shown(std::string_view cpp);

/// The SI value of a symbol or unit name; nothing if it is unknown.
using Known = std::function<std::optional<double>(std::string_view name)>;

/// The value of the tree over SI values; NaN if a name is unknown. `pi` and the units of lib/formula/units.cpp need
/// no `known`.
double value(const Node& tree, const Known& known);

/// The subtree that remains once its outermost choices are settled by known values.
const Node& chosen(const Node& tree, const Known& known);

/// Whether the value is certainly an angle: an inverse function, or an angle that is `known`, with no other operands
/// than numbers and pi.
bool is_angle(const Node& tree, const std::function<bool(std::string_view name)>& known);

/// The printed value of a symbol when it is substituted: number and printed unit ("2700", "N·m"); nothing: keep the
/// name.
struct Written {
  std::string number;
  std::string unit;
};
using Substituted = std::function<std::optional<Written>(std::string_view name)>;

}  // namespace loadpath::formula
