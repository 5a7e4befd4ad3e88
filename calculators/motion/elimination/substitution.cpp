#include "calculators/motion/elimination/substitution.hpp"

#include "lib/quantity/expression/tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace loadpath::motion {

namespace {

using expression::Node;
using expression::Operation;

/// A part of a text, with how firmly it binds.
struct Piece {
  enum Rank { sum, product, power, factor };
  std::string text;
  Rank rank = factor;
  std::optional<double> value = {};  // of a number
  double multiple = 1.0;             // of a multiple of a core
  std::string core = {};             // empty: the text itself
};

Piece piece_of(double value) { return {number_text(value), value < 0.0 ? Piece::sum : Piece::factor, value}; }

std::string at_least_as(const Piece& piece, Piece::Rank rank) {
  return piece.rank < rank ? "(" + piece.text + ")" : piece.text;
}

bool is_number(const Piece& piece, double value) { return piece.value && *piece.value == value; }

/// A multiple of a piece; as a quotient, where that number is shorter.
Piece multiple_of(const Piece& a, double factor) {
  if (a.value) return piece_of(factor * *a.value);
  const std::string core = a.core.empty() ? at_least_as(a, Piece::power) : a.core;
  const double multiple = factor * a.multiple;
  if (multiple == 1.0) return a.core.empty() ? a : Piece{core, Piece::power};
  const std::string number = number_text(std::abs(multiple)), divisor = number_text(1.0 / std::abs(multiple));
  const bool is_quotient = divisor.size() < number.size();
  const std::string text = number == "1" ? core : is_quotient ? core + "/" + divisor : number + "*" + core;
  if (multiple < 0.0) return {"-" + text, Piece::sum, {}, multiple, core};
  return {text, Piece::product, {}, multiple, core};
}

Piece sum_of(const Piece& a, const Piece& b) {
  if (is_number(a, 0.0)) return b;
  if (is_number(b, 0.0)) return a;
  if (b.value && *b.value < 0.0) return {a.text + " - " + number_text(-*b.value), Piece::sum};
  return {a.text + " + " + at_least_as(b, Piece::product), Piece::sum};
}

Piece difference_of(const Piece& a, const Piece& b) {
  if (b.value) return sum_of(a, piece_of(-*b.value));
  return is_number(a, 0.0) ? multiple_of(b, -1.0) : Piece{a.text + " - " + at_least_as(b, Piece::product), Piece::sum};
}

Piece product_of_pieces(const Piece& a, const Piece& b) {
  if (a.value) return multiple_of(b, *a.value);
  if (b.value) return multiple_of(a, *b.value);
  return {at_least_as(a, Piece::product) + "*" + at_least_as(b, Piece::power), Piece::product};
}

Piece quotient_of(const Piece& a, const Piece& b) {
  if (b.value && *b.value != 0.0) return multiple_of(a, 1.0 / *b.value);
  return {at_least_as(a, Piece::product) + "/" + at_least_as(b, Piece::power), Piece::product};
}

Piece call_of(std::string_view function, const Piece& a) { return {std::string(function) + "(" + a.text + ")"}; }

Piece power_of(const Piece& a, double exponent) {
  if (exponent == 1.0) return a;
  if (exponent == 0.5) return call_of("sqrt", a);
  if (std::abs(exponent - 1.0 / 3.0) < 1e-12) return call_of("cbrt", a);
  return {at_least_as(a, Piece::factor) + "^" + at_least_as(piece_of(exponent), Piece::factor), Piece::power};
}

/// The text of a law with a piece in place of the time.
Piece written(const Node& node, const Piece& time) {
  if (expression::is_constant(node)) return piece_of(expression::constant(node));
  const auto kid = [&](std::size_t k) { return written(node.kids[k], time); };
  switch (node.operation) {
    case Operation::reference:
      return time;
    case Operation::negate:
      return multiple_of(kid(0), -1.0);
    case Operation::add:
      return sum_of(kid(0), kid(1));
    case Operation::subtract:
      return difference_of(kid(0), kid(1));
    case Operation::multiply:
      return product_of_pieces(kid(0), kid(1));
    case Operation::divide:
      return quotient_of(kid(0), kid(1));
    case Operation::power:
      return power_of(kid(0), expression::constant(node.kids[1]));
    default:
      break;
  }
  Piece arguments = kid(0);
  for (std::size_t k = 1; k < node.kids.size(); ++k) arguments.text += ", " + kid(k).text;
  return call_of(node.function->name, arguments);
}

std::size_t times_in(const Node& node) {
  std::size_t count = node.operation == Operation::reference ? 1 : 0;
  for (const Node& kid : node.kids) count += times_in(kid);
  return count;
}

/// The inverse of a function of one argument; nothing if it has none.
std::optional<Piece> undone(std::string_view function, const Piece& value) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> pairs{
      {{"exp", "ln"}, {"sin", "asin"}, {"cos", "acos"}, {"tan", "atan"}}};
  if (function == "sqrt") return power_of(value, 2.0);
  if (function == "cbrt") return power_of(value, 3.0);
  for (const auto& [one, other] : pairs) {
    if (function == one) return call_of(other, value);
    if (function == other) return call_of(one, value);
  }
  return std::nullopt;
}

/// The time at which a law that contains it once has a value.
std::optional<Piece> solved(const Node& node, const Piece& value);

std::optional<Piece> solved_for_operand(const Node& node, const Piece& value) {
  const bool is_first = times_in(node.kids[0]) == 1;
  const Node& kid = node.kids[is_first ? 0 : 1];
  const Piece other = piece_of(expression::constant(node.kids[is_first ? 1 : 0]));
  switch (node.operation) {
    case Operation::add:
      return solved(kid, difference_of(value, other));
    case Operation::subtract:
      return solved(kid, is_first ? sum_of(value, other) : difference_of(other, value));
    case Operation::multiply:
      return solved(kid, quotient_of(value, other));
    case Operation::divide:
      return solved(kid, is_first ? product_of_pieces(other, value) : quotient_of(other, value));
    case Operation::power:
      return *other.value == 0.0 ? std::nullopt : solved(kid, power_of(value, 1.0 / *other.value));
    default:
      return std::nullopt;
  }
}

std::optional<Piece> solved(const Node& node, const Piece& value) {
  if (node.operation == Operation::reference) return value;
  if (node.operation == Operation::negate) return solved(node.kids[0], multiple_of(value, -1.0));
  if (node.operation != Operation::call) return solved_for_operand(node, value);
  const auto inner = node.kids.size() == 1 ? undone(node.function->name, value) : std::nullopt;
  return inner ? solved(node.kids[0], *inner) : std::nullopt;
}

}  // namespace

void add_substitution(std::string_view x_name, std::string_view x_law, std::string_view y_name, std::string_view y_law,
                      std::vector<CurveEquation>& all) {
  constexpr std::array<std::string_view, 1> time_name{"t"};
  const auto x = expression::parse(x_law, time_name), y = expression::parse(y_law, time_name);
  if (!x || !y || times_in(x->tree.root) != 1) return;
  const auto time = solved(x->tree.root, {std::string(x_name)});
  if (time) all.push_back({std::string(y_name) + " = " + written(y->tree.root, *time).text, PathForm::other});
}

}  // namespace loadpath::motion
