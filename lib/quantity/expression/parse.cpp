#include "lib/quantity/expression/parser.hpp"
#include "lib/quantity/expression/scan.hpp"
#include "lib/quantity/gravity.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/quantity/unit.hpp"

#include <charconv>
#include <cmath>
#include <numbers>

namespace loadpath::expression {
namespace {

constexpr int deepest = 64;
constexpr std::size_t longest = 1024;

}  // namespace

Node Parser::joined(Operation operation, Node left, Node right) const {
  const auto from = left.at;
  Node node;
  node.operation = operation;
  node.kids.push_back(std::move(left));
  node.kids.push_back(std::move(right));
  return ending_here(std::move(node), from);
}

Outcome<Parsed> Parser::parse() {
  if (done()) {
    fail(0, 1, say("the expression is empty"), say("write a value after '=', as in =2 * lever.drive.M"));
  } else if (text_.size() > longest) {
    fail(longest, text_.size() - longest, say("an expression is at most {1} bytes long", std::to_string(longest)),
         say("give parts of it to steps of their own"));
  }
  Parsed parsed{{std::string(text_), sum()}, {}};
  if (!done()) fail_unexpected();
  if (fault_) return *fault_;
  parsed.references = std::move(references_);
  return parsed;
}

Node Parser::sum() {
  Node left = product();
  while (!done()) {
    const bool plus = take('+');
    if (!plus && !take(minus_end(text_, next_))) break;
    left = joined(plus ? Operation::add : Operation::subtract, std::move(left), product());
  }
  return left;
}

Node Parser::product() {
  Node left = signed_power();
  while (!done()) {
    const bool times = take(times_end(text_, next_));
    if (!times && !take('/')) break;
    left = joined(times ? Operation::multiply : Operation::divide, std::move(left), signed_power());
  }
  return left;
}

Node Parser::signed_power() {
  const auto from = next_;
  if (++depth_ > deepest) {
    fail(next_, 1, say("parentheses, signs and exponents are nested deeper than {1}", std::to_string(deepest)),
         say("give parts of the expression to steps of their own"));
  }
  Node node;
  if (take(minus_end(text_, next_))) {
    node.operation = Operation::negate;
    node.kids.push_back(signed_power());
    node = ending_here(std::move(node), from);
  } else {
    node = power();
  }
  --depth_;
  return node;
}

Node Parser::power() {
  Node base = primary();
  if (!take('^')) return base;
  return joined(Operation::power, std::move(base), signed_power());
}

Node Parser::primary() {
  const auto whole = next_ + (sees('.') ? 1 : 0);
  if (digits_end(text_, whole) != whole) return number();
  if (sees('(')) return group();
  if (name_end(text_, next_) != next_) return name();
  fail_missing_value();
  return {};
}

Node Parser::group() {
  const auto open = next_;
  take('(');
  Node node = sum();
  if (done()) {
    fail(open, 1, say("'(' is not closed"), say("write ')' after its last value"));
  } else if (!take(')')) {
    fail_unexpected();
  }
  return ending_here(std::move(node), open);
}

Node Parser::number() {
  const auto from = next_;
  Node node;
  const char* begin = text_.data() + from;
  const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), node.si);
  const auto length = static_cast<std::size_t>(end - begin);
  if (error != std::errc{}) {
    fail(from, length, say("the number '{1}' is too large or too small", slice(from, from + length)),
         say("choose a larger or a smaller unit"));
    return node;
  }
  step_to(from + length);
  unit(node);
  return ending_here(std::move(node), from);
}

void Parser::unit(Node& literal) {
  const auto from = next_;
  const auto end = unit_end(text_, from, variables_);
  if (!take(end)) return;
  const auto unit = read_unit(text_.substr(0, end), from);
  if (!unit) return fail_unit(unit.fault(), from, end);
  const auto written = slice(from, end);
  if (unit->offset != 0.0) {
    return fail(from, end - from, say("'{1}' is a point on a scale and cannot be used in an expression", written),
                say("write a temperature difference in K"));
  }
  if (counts_anything(unit->dimension, written)) {
    return fail(from, end - from, say("'{1}' is ambiguous: a speed of rotation or a frequency", written),
                say("write rpm for a speed of rotation"));
  }
  literal.si = unit->to_si(literal.si);
  literal.dimension = unit->dimension;
  literal.kind = kind_of_unit(unit->dimension, unit->has(Mark::hertz), unit->has(Mark::work), unit->has(Mark::scale));
  if (!std::isfinite(literal.si)) {
    fail(from, end - from, say("the number is too large in '{1}'", written), say("choose another unit"));
  }
}

Node Parser::name() {
  const auto path = path_end(text_, next_);
  if (path != next_) return reference(path);
  const auto end = name_end(text_, next_);
  const auto behind = skip_space(text_, end);
  if (behind < text_.size() && text_[behind] == '(') return call(end);
  const auto word = text_.substr(next_, end - next_);
  if (is_among(variables_, word)) return reference(end);
  if (word == "pi") return constant(std::numbers::pi, {}, end);
  if (word == "rev") return constant(2.0 * std::numbers::pi, Dimension::of(0, 0, 0, 0, 1), end);
  if (word == "g") return constant(standard_gravity, Dimension::of(1, 0, -2), end);
  fail_bare_name(end);
  return {};
}

Node Parser::constant(double si, Dimension dimension, std::size_t end) {
  const auto from = next_;
  Node node;
  node.si = si;
  node.dimension = dimension;
  take(end);
  return ending_here(std::move(node), from);
}

Node Parser::reference(std::size_t end) {
  const auto from = next_;
  Node node;
  node.operation = Operation::reference;
  node.path = slice(from, end);
  references_.push_back({node.path, from});
  take(end);
  return ending_here(std::move(node), from);
}

Node Parser::call(std::size_t end) {
  const auto from = next_;
  const auto name = slice(from, end);
  Node node;
  node.operation = Operation::call;
  node.function = find_function(name);
  if (node.function == nullptr) {
    fail_unknown_function(name);
    return node;
  }
  take(end);
  arguments(node, next_);
  node = ending_here(std::move(node), from);
  const auto given = node.kids.size();
  if (given < node.function->least || given > node.function->most) {
    fail(node.at, node.length, say("wrong number of arguments of '{1}': {2}", name, std::to_string(given)),
         say("write {1}", node.function->form));
  }
  return node.function->is_resultant ? resultant(std::move(node)) : node;
}

/// The root of the sum of the squares, sqrt(x^2 + y^2): dimensions, factors and derivatives are those of the
/// operations.
Node Parser::resultant(Node call) const {
  const auto within_call = [&](Node node) {
    node.at = call.at, node.length = call.length;
    return node;
  };
  Node sum;
  for (Node& side : call.kids) {
    const bool is_first = &side == &call.kids.front();
    Node two = within_call({});
    two.si = 2.0;
    Node square = within_call(joined(Operation::power, std::move(side), std::move(two)));
    sum = is_first ? std::move(square) : within_call(joined(Operation::add, std::move(sum), std::move(square)));
    if (!is_first) sum.function = call.function;  // for messages
  }
  call.function = find_function("sqrt");
  call.kids.clear();
  call.kids.push_back(std::move(sum));
  return call;
}

void Parser::arguments(Node& node, std::size_t open) {
  take('(');
  if (take(')')) return;
  do node.kids.push_back(sum());
  while (take(','));
  if (done()) {
    fail(open, 1, say("'(' is not closed"), say("write ')' after its last value"));
  } else if (!take(')')) {
    fail_unexpected();
  }
}

Outcome<Parsed> parse(std::string_view text, Names variables) { return Parser{text, variables}.parse(); }

}  // namespace loadpath::expression
