#include "lib/quantity/expression/tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::expression {
namespace {

constexpr double not_available = std::numeric_limits<double>::quiet_NaN();

using Join = double (*)(double, double);

/// A square is the product that it is in a formula; std::pow may differ in the last digit.
double raised(double base, double exponent) { return exponent == 2.0 ? base * base : std::pow(base, exponent); }

double finite(double x) { return std::isfinite(x) ? x : not_available; }

Value single(double x) { return {{}, {finite(x)}}; }

/// A step that failed may leave a series short: missing values are not available.
Value loaded(const Value& given) {
  Value value = given;
  const Axis* axis = given.signature.axis;
  value.si.resize(axis == nullptr ? 1 : axis->at.size(), not_available);
  std::transform(value.si.begin(), value.si.end(), value.si.begin(), finite);
  return value;
}

template <class Map>
Value mapped(Value value, Map map) {
  for (double& x : value.si) x = finite(map(x));
  return value;
}

Value joined(Value a, Value b, Join join) {
  if (!a.is_series()) return mapped(std::move(b), [x = a.si[0], join](double y) { return join(x, y); });
  for (std::size_t i = 0; i < a.si.size(); ++i) a.si[i] = finite(join(a.si[i], b.si[b.is_series() ? i : 0]));
  return a;
}

Join join_of(Operation operation) {
  switch (operation) {
    case Operation::add:
      return [](double a, double b) { return a + b; };
    case Operation::subtract:
      return [](double a, double b) { return a - b; };
    case Operation::multiply:
      return [](double a, double b) { return a * b; };
    case Operation::divide:
      return [](double a, double b) { return a / b; };
    default:
      return raised;
  }
}

Value called(const Node& node, const Known& known) {
  const Function& f = *node.function;
  const bool is_reduced = f.map == nullptr && f.rule != Rule::place && node.kids.size() == 1;
  // A reduction of a series with missing values is not available either way.
  if (is_reduced && node.kids.front().operation == Operation::reference)
    return single(f.reduce(known(node.kids.front().path)));
  Value value = numbers(node.kids.front(), known);
  if (f.map != nullptr) return mapped(std::move(value), f.map);
  if (f.rule == Rule::place) return single(value_at(value, constant(node.kids[1])));
  if (is_reduced) return single(f.reduce(value));
  for (std::size_t i = 1; i < node.kids.size(); ++i) {
    value = joined(std::move(value), numbers(node.kids[i], known), f.join);
  }
  return value;
}

}  // namespace

Value numbers(const Node& node, const Known& known) {
  switch (node.operation) {
    case Operation::literal:
      return single(node.si);
    case Operation::reference:
      return loaded(known(node.path));
    case Operation::negate:
      return mapped(numbers(node.kids[0], known), [](double x) { return -x; });
    case Operation::call:
      return called(node, known);
    default:
      return joined(numbers(node.kids[0], known), numbers(node.kids[1], known), join_of(node.operation));
  }
}

namespace {

bool called(const Node& node, const Column& column, std::span<double> out) {
  const Function& f = *node.function;
  if (f.rule == Rule::place || !numbers(node.kids.front(), column, out)) return false;
  if (f.map != nullptr) {
    for (double& x : out) x = finite(f.map(x));
    return true;
  }
  if (node.kids.size() == 1) {
    Value one{{}, {0.0}};
    for (double& x : out) {
      one.si[0] = x;
      x = finite(f.reduce(one));
    }
    return true;
  }
  std::vector<double> other(out.size());
  for (std::size_t k = 1; k < node.kids.size(); ++k) {
    if (!numbers(node.kids[k], column, other)) return false;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = finite(f.join(out[i], other[i]));
  }
  return true;
}

}  // namespace

bool numbers(const Node& node, const Column& column, std::span<double> out) {
  switch (node.operation) {
    case Operation::literal:
      std::fill(out.begin(), out.end(), finite(node.si));
      return true;
    case Operation::reference:
      std::transform(out.begin(), out.end(), column(node.path), out.begin(),
                     [](double, double x) { return finite(x); });
      return true;
    case Operation::negate:
      if (!numbers(node.kids[0], column, out)) return false;
      for (double& x : out) x = -x;
      return true;
    case Operation::call:
      return called(node, column, out);
    default:
      break;
  }
  std::vector<double> right(out.size());
  if (!numbers(node.kids[0], column, out) || !numbers(node.kids[1], column, right)) return false;
  const Join join = join_of(node.operation);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = finite(join(out[i], right[i]));
  return true;
}

bool is_constant(const Node& node) {
  return node.operation != Operation::reference && std::all_of(node.kids.begin(), node.kids.end(), is_constant);
}

double number(const Node& node, const Single& single) {
  const auto kid = [&](std::size_t k) { return number(node.kids[k], single); };
  switch (node.operation) {
    case Operation::literal:
      return finite(node.si);
    case Operation::reference:
      return finite(single(node.path));
    case Operation::negate:
      return -kid(0);
    case Operation::call:
      break;
    default:
      return finite(join_of(node.operation)(kid(0), kid(1)));
  }
  const Function& f = *node.function;
  double value = kid(0);
  if (f.map != nullptr) return finite(f.map(value));
  if (node.kids.size() == 1) return finite(f.reduce({{}, {value}}));
  if (f.join == nullptr) return not_available;  // of a place in a series
  for (std::size_t k = 1; k < node.kids.size(); ++k) value = finite(f.join(value, kid(k)));
  return value;
}

double constant(const Node& node) {
  static const Value none{{}, {not_available}};
  return numbers(node, [](const std::string&) -> const Value& { return none; }).si.front();
}

}  // namespace loadpath::expression
